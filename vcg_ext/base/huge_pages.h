// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: how large an array will be; out: room for it, in huge pages where the system has them, from
// what earlier arrays have given back if a run keeps that. Guarantee: what the array holds does not
// depend on it.
#pragma once

#include <cstddef>
#include <vector>

// An address sanitizer has to see each block that is taken and given back: then the heap it is.
#if defined(__SANITIZE_ADDRESS__)
#define INDEX_BOOLEAN_HEAP_ONLY
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define INDEX_BOOLEAN_HEAP_ONLY
#endif
#endif

namespace index_boolean {

// Memory for an array. Its first touch costs as much as writing it ten times in pages of 4 KiB, so
// that large arrays begin at a huge page's border and are made of huge pages. Throws
// std::bad_alloc. From any thread. Complexity: O(1), or O(blocks kept).
void* allocatePages(std::size_t bytes);

// Gives it back. \param bytes as asked for. Complexity: as above.
void releasePages(void* memory, std::size_t bytes) noexcept;

// While one lives, memory that large arrays give back, in whatever thread, is kept for those to
// come: the system clears each page that it gives, which takes as long as a small stage. With the
// last one all that is kept goes back to the system.
class PageReuse {
public:
	PageReuse();
	~PageReuse();
	PageReuse(const PageReuse&) = delete;
	PageReuse& operator=(const PageReuse&) = delete;
};

// Asks for huge pages in memory of another allocator that has not been touched yet. A hint.
// Complexity: O(1).
void adviseHugePages(void* memory, std::size_t bytes);

// How many bytes to ask such an allocator for so that the system can give whole huge pages.
// Complexity: O(1).
std::size_t hugePageCapacity(std::size_t bytes);

// Makes room for n items in an array with another allocator. Throws std::bad_alloc.
template <class T, class Allocator>
void reserveHuge(std::vector<T, Allocator>& array, std::size_t n) {
	if (n > array.capacity()) {
		array.reserve(hugePageCapacity(n * sizeof(T)) / sizeof(T));
		adviseHugePages(array.data(), array.capacity() * sizeof(T));
	}
}

}  // namespace index_boolean
