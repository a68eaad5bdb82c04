// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bytes as the decisions that make two solids on a small grid: every run has exactly the volumes
// and walls of the oracle, keeps its promises, and is the same for swapped operands.
#include "fuzz_bytes.h"
#include "property.h"
#include "support/grid_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
	using namespace index_boolean;
	fuzz::ByteReader in(bytes, size);
	Options options = fuzz::options(in);
	const std::int64_t span = grid::kSpans[in.below(grid::kSpans.size())];
	const grid::SolidPair pair = grid::randomPair(grid::Random(in.rest(), in.restSize()), span);
	fuzz::expectNone(grid::swapDefect(pair, options));
	fuzz::expectNone(grid::deliveryDefect(pair, options));
	options.outputScalar = OutputScalar::Double;
	fuzz::expectNone(grid::measuresDefect(pair, options));
	return 0;
}
