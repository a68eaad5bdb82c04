// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bytes as the decisions that make two solids on a small grid: a run has exactly the volumes and
// walls of the oracle, or keeps its promises, or is the same for swapped operands; a byte says
// which.
#include "fuzz_bytes.h"
#include "property.h"
#include "support/grid_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
	using namespace index_boolean;
	using Property = std::string (*)(const grid::SolidPair&, const Options&);
	constexpr std::array<Property, 3> kProperties{grid::measuresDefect, grid::deliveryDefect,
	                                              grid::swapDefect};
	fuzz::ByteReader in(bytes, size);
	Options options = fuzz::options(in);
	options.weldDistance = 0;  // what is welded has other volumes
	const std::uint32_t property = in.below(kProperties.size());
	if (property == 0) {
		options.outputScalar = OutputScalar::Double;
	}
	const std::int64_t span = grid::kSpans[in.below(grid::kSpans.size())];
	const grid::SolidPair pair = grid::randomPair(grid::Random(in.rest(), in.restSize()), span);
	fuzz::expectNone(kProperties[property](pair, options));
	return 0;
}
