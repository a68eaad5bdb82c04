// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of indices and the one of pairs against std::map, with more entries than they begin
// with, and with hashes that collide.
#include <vcg_ext/base/index_table.h>

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace index_boolean;

TEST(IndexTable, findsTheFirstOfEqualItemsWhateverTheHash) {
	for (const std::uint64_t mask : {~std::uint64_t{0}, std::uint64_t{7}, std::uint64_t{0}}) {
		std::mt19937 random(3);
		std::vector<std::uint32_t> items(500);
		std::map<std::uint32_t, std::uint32_t> firsts;
		IndexTable table(items.size());
		for (std::uint32_t i = 0; i < items.size(); ++i) {
			items[i] = static_cast<std::uint32_t>(random() % 300);
			const auto isSame = [&](std::uint32_t j) { return items[j] == items[i]; };
			std::uint32_t& slot = table.slotOf(items[i] * 0x9e3779b97f4a7c15U & mask, isSame);
			slot = slot == IndexTable::kNone ? i : slot;
			EXPECT_EQ(slot, firsts.emplace(items[i], i).first->second);
		}
		const auto none = [&](std::uint32_t j) { return items[j] == 300; };
		EXPECT_EQ(table.find(300 & mask, none), IndexTable::kNone);
		table.reset(4);
		EXPECT_EQ(table.find(0, [](std::uint32_t) { return true; }), IndexTable::kNone);
	}
}

TEST(PairTable, growsAndKeepsTheFirstNumberOfAPair) {
	std::mt19937 random(5);
	PairTable table;
	EXPECT_EQ(table.find(0, 0), IndexTable::kNone);
	std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> expected;
	for (std::uint32_t number = 0; number < 20000; ++number) {
		const auto a = static_cast<std::uint32_t>(random() % 100);
		const auto b = static_cast<std::uint32_t>(random() % 100 + 0xffffff80U);
		const auto known = expected.emplace(std::pair(a, b), number).first->second;
		EXPECT_EQ(table.findOrAdd(a, b, number), known);
	}
	for (const auto& [pair, number] : expected) {
		EXPECT_EQ(table.find(pair.first, pair.second), number);
		EXPECT_EQ(table.find(pair.second, pair.first), IndexTable::kNone);
	}
}
