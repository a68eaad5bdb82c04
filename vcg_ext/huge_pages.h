// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an array and how large it will be; out: room for it, in huge pages where the system has them.
// Guarantee: a hint only. What the array holds does not depend on it.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace index_boolean {

// Asks the system for huge pages in memory that has not been touched yet: the first touch of a
// page of 4 KiB costs as much as writing ten of them. Where there are none, nothing happens. O(1).
void adviseHugePages(void* memory, std::size_t bytes);

// How many bytes to ask for so that the system can give whole huge pages, at least `bytes`.
std::size_t hugePageCapacity(std::size_t bytes);

// Makes room for n items in an array. Throws std::bad_alloc.
template <class T, class Allocator>
void reserveHuge(std::vector<T, Allocator>& array, std::size_t n) {
	if (n > array.capacity()) {
		array.reserve(hugePageCapacity(n * sizeof(T)) / sizeof(T));
		adviseHugePages(array.data(), array.capacity() * sizeof(T));
	}
}

// Makes n items that have no value yet: nothing touches them before who writes them.
// \pre T is trivial. Throws std::bad_alloc.
template <class T>
std::unique_ptr<T[]> makeHuge(std::size_t n) {
	static_assert(std::is_trivially_default_constructible_v<T>);
	const std::size_t size = hugePageCapacity(n * sizeof(T));
	std::unique_ptr<T[]> array(new T[size / sizeof(T)]);
	adviseHugePages(array.get(), size);
	return array;
}

}  // namespace index_boolean
