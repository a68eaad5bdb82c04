// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A vector's memory begins a few bytes after a page's border, so the range is widened to whole huge
// pages: what neighbours in the heap have there gets them as well, or is touched already.
#include "huge_pages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace index_boolean {

namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;
constexpr std::size_t kHeader = 64;  // at most; what an allocator keeps beside the memory it gives

}  // namespace

void adviseHugePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
	if (bytes < kHugePage / 2)
		return;
	const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(memory) & ~(kHugePage - 1);
	const std::uintptr_t end =
	    (reinterpret_cast<std::uintptr_t>(memory) + bytes + kHugePage - 1) & ~(kHugePage - 1);
	madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

// Linux puts a mapping of whole huge pages on such a page's border.
std::size_t hugePageCapacity(std::size_t bytes) {
#ifdef MADV_HUGEPAGE
	if (bytes >= kHugePage / 2)
		return (bytes + kHeader + kHugePage - 1) / kHugePage * kHugePage - kHeader;
#endif
	return bytes;
}

}  // namespace index_boolean
