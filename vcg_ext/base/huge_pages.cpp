// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks are mapped, not taken from the heap: the heap's memory begins anywhere, and is given back
// and asked for again whenever its end is free. A block that is larger than what is asked for is
// divided, since any part of a mapping can be given back on its own.
// The blocks kept are a state that all runs of a process share, as they share the heap and the
// helper threads: an allocator of a vector's has none of its own. A run without others leaves
// nothing in it.
#include "vcg_ext/base/huge_pages.h"

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <new>
#include <vector>

#if defined(__linux__) && !defined(INDEX_BOOLEAN_HEAP_ONLY)
#include <pthread.h>
#include <sys/mman.h>
#endif

namespace index_boolean {

#ifdef MADV_HUGEPAGE

namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;
constexpr std::size_t kHeader = 64;  // at most; what an allocator keeps beside the memory it gives

constexpr bool isLarge(std::size_t bytes) { return bytes >= kHugePage / 2; }

constexpr std::size_t wholePages(std::size_t bytes) {
	return (bytes + kHugePage - 1) / kHugePage * kHugePage;
}

struct Block {
	std::uintptr_t begin;
	std::size_t size;
};

void unmap(Block block) {
	if (block.size > 0) {
		munmap(reinterpret_cast<void*>(block.begin), block.size);
	}
}

// New memory that begins at a huge page's border. \param size of whole huge pages
Block map(std::size_t size) {
	const std::size_t room = size + kHugePage;
	void* memory = mmap(nullptr, room, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
	if (memory == MAP_FAILED) {
		throw std::bad_alloc();
	}
	const auto begin = reinterpret_cast<std::uintptr_t>(memory);
	const std::uintptr_t aligned = (begin + kHugePage - 1) & ~(kHugePage - 1);
	unmap({begin, aligned - begin});
	unmap({aligned + size, begin + room - (aligned + size)});
	madvise(reinterpret_cast<void*>(aligned), size, MADV_HUGEPAGE);
	return {aligned, size};
}

// The blocks that are kept while there is any PageReuse.
class KeptBlocks {
public:
	Block take(std::size_t size) {
		{
			const std::lock_guard<std::mutex> lock(mutex_);
			const auto best = std::min_element(blocks_.begin(), blocks_.end(),
			                                   [size](const Block& a, const Block& b) {
				                                   // Those that are too small come last.
				                                   return (a.size - size) < (b.size - size);
			                                   });
			if (best != blocks_.end() && best->size >= size) {
				const Block taken{best->begin, size};
				best->begin += size;
				best->size -= size;
				if (best->size == 0) {
					blocks_.erase(best);
				}
				return taken;
			}
		}
		return map(size);
	}

	void giveBack(Block block) {
		const std::lock_guard<std::mutex> lock(mutex_);
		if (users_ > 0 && blocks_.size() < blocks_.capacity()) {
			blocks_.push_back(block);
		} else {
			unmap(block);
		}
	}

	// Throws std::bad_alloc.
	void addUser() {
		const std::lock_guard<std::mutex> lock(mutex_);
		blocks_.reserve(kMostBlocks);
		++users_;
	}

	// Gives memory back while nobody waits.
	void removeUser() {
		std::vector<Block> blocks;
		{
			const std::lock_guard<std::mutex> lock(mutex_);
			if (--users_ == 0) {
				blocks.swap(blocks_);
			}
		}
		std::for_each(blocks.begin(), blocks.end(), unmap);
	}

	void lock() { mutex_.lock(); }
	void unlock() { mutex_.unlock(); }

private:
	static constexpr std::size_t kMostBlocks = 256;

	std::mutex mutex_;
	std::size_t users_ = 0;
	std::vector<Block> blocks_;
};

KeptBlocks& keptBlocks();

// A child made by fork() while another thread has the lock would find it taken for ever.
KeptBlocks* makeKeptBlocks() {
	pthread_atfork([] { keptBlocks().lock(); }, [] { keptBlocks().unlock(); },
	               [] { keptBlocks().unlock(); });
	return new KeptBlocks;
}

// Never destroyed: arrays in static memory may outlive everything else.
KeptBlocks& keptBlocks() {
	static auto* const blocks = makeKeptBlocks();
	return *blocks;
}

}  // namespace

void* allocatePages(std::size_t bytes) {
	return isLarge(bytes) ? reinterpret_cast<void*>(keptBlocks().take(wholePages(bytes)).begin)
	                      : ::operator new(bytes);
}

void releasePages(void* memory, std::size_t bytes) noexcept {
	if (isLarge(bytes)) {
		keptBlocks().giveBack({reinterpret_cast<std::uintptr_t>(memory), wholePages(bytes)});
	} else {
		::operator delete(memory);
	}
}

PageReuse::PageReuse() { keptBlocks().addUser(); }

PageReuse::~PageReuse() { keptBlocks().removeUser(); }

// A vector's memory begins a few bytes after a page's border, so the range is widened to whole huge
// pages: what neighbours in the heap have there gets them as well, or is touched already.
void adviseHugePages(void* memory, std::size_t bytes) {
	if (isLarge(bytes)) {
		const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(memory) & ~(kHugePage - 1);
		const std::size_t size =
		    wholePages(reinterpret_cast<std::uintptr_t>(memory) + bytes - begin);
		madvise(reinterpret_cast<void*>(begin), size, MADV_HUGEPAGE);
	}
}

// Linux puts a mapping of whole huge pages on such a page's border.
std::size_t hugePageCapacity(std::size_t bytes) {
	return isLarge(bytes) ? wholePages(bytes + kHeader) - kHeader : bytes;
}

#else

void* allocatePages(std::size_t bytes) { return ::operator new(bytes); }
void releasePages(void* memory, std::size_t) noexcept { ::operator delete(memory); }
PageReuse::PageReuse() = default;
PageReuse::~PageReuse() = default;
void adviseHugePages(void*, std::size_t) {}
std::size_t hugePageCapacity(std::size_t bytes) { return bytes; }

#endif

}  // namespace index_boolean
