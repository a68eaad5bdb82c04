// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a fuzz target without a fuzzer, on pseudo-random bytes: replay RUNS. Run n has the seed n,
// so that the runs are the same everywhere.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

int main(int argc, char** argv) {
	const unsigned long runs = argc == 2 ? std::strtoul(argv[1], nullptr, 10) : 0;
	if (runs == 0) {
		std::fprintf(stderr, "usage: %s RUNS\n", argv[0]);
		return 2;
	}
	for (unsigned long run = 0; run < runs; ++run) {
		std::mt19937 random(static_cast<std::mt19937::result_type>(run));
		std::vector<std::uint8_t> bytes(random() % 512);
		for (std::uint8_t& byte : bytes) {
			byte = static_cast<std::uint8_t>(random());
		}
		std::fprintf(stderr, "\rseed %lu", run);
		LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
	}
	std::fprintf(stderr, "\r%lu runs, nothing broken\n", runs);
	return 0;
}
