// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a type; out: a std::vector of it for arrays as large as a mesh. Guarantee: holds what a
// std::vector holds, unless it is made or resized "for overwrite": then new items have no value
// until they are written, if the type is trivial. Nothing touches their memory before, so that the
// threads which write it share the cost of the first touch.
#pragma once

#include "vcg_ext/base/huge_pages.h"

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace index_boolean {

// Memory in huge pages where the system has them. What is constructed without a value has none.
template <class T>
struct HugeAllocator {
	using value_type = T;
	// All are alike, so an array that is moved takes its memory along, and no item is asked whether
	// it can be moved: atomics cannot.
	using propagate_on_container_move_assignment = std::true_type;

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
class HugeVector : public std::vector<T, HugeAllocator<T>> {
	using Base = std::vector<T, HugeAllocator<T>>;

public:
	HugeVector() = default;
	HugeVector(std::initializer_list<T> items) : Base(items) {}
	explicit HugeVector(std::size_t n) : HugeVector(n, T{}) {}
	HugeVector(std::size_t n, const T& value) : Base(n, value) {}
	template <class Iterator, class = typename std::iterator_traits<Iterator>::iterator_category>
	HugeVector(Iterator begin, Iterator end) : Base(begin, end) {}

	// n items, see above. Throws std::bad_alloc. O(1), for a trivial type.
	static HugeVector forOverwrite(std::size_t n) { return HugeVector(ForOverwrite{}, n); }

	// Keeps the first items, as resize does; what is new is for overwrite, see above.
	void resizeForOverwrite(std::size_t n) { Base::resize(n); }

	void resize(std::size_t n) { Base::resize(n, T{}); }
	void resize(std::size_t n, const T& value) { Base::resize(n, value); }

	template <class... Arguments>
	T& emplace_back(Arguments&&... arguments) {
		return Base::emplace_back(T(std::forward<Arguments>(arguments)...));
	}

private:
	struct ForOverwrite {};
	HugeVector(ForOverwrite, std::size_t n) : Base(n) {}
};

// An array that will be overwritten, of either kind: for code that takes both.
template <class Array>
Array arrayForOverwrite(std::size_t n, const Array&) {
	return Array(n);
}
template <class T>
HugeVector<T> arrayForOverwrite(std::size_t n, const HugeVector<T>&) {
	return HugeVector<T>::forOverwrite(n);
}

}  // namespace index_boolean
