// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a type; out: a std::vector of it for arrays as large as a mesh. Guarantee: holds what a
// std::vector holds, except that items without a value given (resize, emplace_back, a count alone)
// have none until they are written, if the type is trivial: nothing touches their memory before, so
// that the threads which write it share the cost of the first touch.
#pragma once

#include "vcg_ext/base/huge_pages.h"

#include <new>
#include <utility>
#include <vector>

namespace index_boolean {

// Memory in huge pages where the system has them, and items that are not set to zero.
template <class T>
struct HugeAllocator {
	using value_type = T;

	HugeAllocator() = default;
	template <class U>
	HugeAllocator(const HugeAllocator<U>&) {}

	// Throws std::bad_alloc.
	T* allocate(std::size_t n) {
		constexpr std::size_t kMost = static_cast<std::size_t>(-1) / 2 / sizeof(T);
		if (n > kMost) {
			throw std::bad_alloc();
		}
		return static_cast<T*>(allocatePages(n * sizeof(T)));
	}
	void deallocate(T* memory, std::size_t n) { releasePages(memory, n * sizeof(T)); }

	template <class U>
	void construct(U* item) {
		::new (static_cast<void*>(item)) U;
	}
	template <class U, class... Arguments>
	void construct(U* item, Arguments&&... arguments) {
		::new (static_cast<void*>(item)) U(std::forward<Arguments>(arguments)...);
	}

	friend bool operator==(const HugeAllocator&, const HugeAllocator&) { return true; }
	friend bool operator!=(const HugeAllocator&, const HugeAllocator&) { return false; }
};

template <class T>
using HugeVector = std::vector<T, HugeAllocator<T>>;

}  // namespace index_boolean
