// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as one to four meshes that may meet themselves, and options: a run ends with cells of
// which any blocks keep their promises, or with a refusal that has a name. An internal error is
// neither.
#include "fuzz_bytes.h"
#include "property.h"
#include "support/stored_faces.h"

namespace {

using namespace index_boolean;

std::string refusalDefect(const Status& status, std::size_t operands) {
	switch (status.code) {
	case StatusCode::EmptyOperand:
	case StatusCode::NotFinite:
	case StatusCode::BeyondFloat:
	case StatusCode::IndexOutOfRange:
	case StatusCode::WeldTooWide:
		return status.operand >= 0 && static_cast<std::size_t>(status.operand) < operands
		           ? ""
		           : "a refusal of no operand";
	default:
		return std::string("not to be expected: ") + describe(status);
	}
}

std::string blockDefect(const Arrangement& arrangement, const CellPredicate& isInside) {
	Monitor monitor;
	Block block;
	const Status status = extractBlock(arrangement, isInside, monitor, block);
	return status.ok() ? brokenPromise(block) : describe(status);
}

// Whether the first two operands, where they are solids, clip each other.
Status clipEachOther(const Arrangement& arrangement, const Split& parts, Monitor& monitor) {
	Status status;
	for (const bool isFirst : {true, false}) {
		const OperandId surface = isFirst ? kFirst : kSecond, solid = otherOf(surface);
		if (!refuseSolid(arrangement, parts.blocks, solid).ok()) {
			continue;
		}
		for (const bool isInside : {true, false}) {
			const Clip clip{surface, solid, isInside};
			SplitMesh mesh;
			BlockMeasure measure;
			status =
			    inOrder([&] { return status; },
			            [&] { return extractClip(arrangement, parts, clip, monitor, mesh); },
			            [&] { return audit(arrangement, parts, clip, mesh, monitor, measure); });
		}
	}
	return status;
}

// Whether the parts of the same soup are found and audited.
std::string splitDefect(const std::vector<SurfaceView>& views, const Options& options) {
	Monitor monitor;
	const auto again = [&](MeshArrays& out) { return joinSurfaces(views, 1, monitor, out); };
	MeshArrays arrays;
	Arrangement arrangement;
	Split parts;
	SplitAudit audited;
	const Status status = inOrder(
	    [&] { return again(arrays); },
	    [&] {
		    return splitOperands(std::move(arrays), again, options, monitor, arrangement, parts);
	    },
	    [&] { return audit(arrangement, parts, {}, monitor, audited); },
	    [&] { return views.size() < 2 ? Status{} : clipEachOther(arrangement, parts, monitor); });
	return status.ok() || status.code == StatusCode::SelfIntersecting ? "" : describe(status);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
	fuzz::ByteReader in(bytes, size);
	Options options = fuzz::options(in);
	options.selfIntersections = SelfIntersections::Resolve;
	options.windingRule = static_cast<WindingRule>(in.below(3));
	options.certify = in.below(64) == 0;  // the repair of such tangles takes a second each
	std::vector<shapes::Mesh> operands;
	const std::uint32_t more = in.below(4);
	for (std::uint32_t i = 0; i <= more; ++i) {
		operands.push_back(fuzz::mesh(in));
	}
	std::vector<SurfaceView> views;
	for (const shapes::Mesh& m : operands) {
		views.push_back(viewOf(m.points, m.triangles));
	}
	Monitor monitor;
	MeshArrays arrays;
	Arrangement arrangement;
	const Status status =
	    inOrder([&] { return joinSurfaces(views, 1, monitor, arrays); },
	            [&] { return arrangeCells(std::move(arrays), options, monitor, arrangement); });
	if (!status.ok()) {
		fuzz::expectNone(refusalDefect(status, operands.size()));
		return 0;
	}
	const auto isIn = [rule = options.windingRule](std::int32_t w) { return isInside(rule, w); };
	fuzz::expectNone(blockDefect(arrangement, [&](const PerOperand<std::int32_t>& w) {
		return std::any_of(w.begin(), w.end(), isIn);
	}));
	fuzz::expectNone(blockDefect(arrangement, [&](const PerOperand<std::int32_t>& w) {
		return std::count_if(w.begin(), w.end(), isIn) % 2 == 1;
	}));
	fuzz::expectNone(blockDefect(arrangement, [](const PerOperand<std::int32_t>& w) {
		return std::any_of(w.begin(), w.end(), [](std::int32_t n) { return n < 0 || n > 1; });
	}));
	fuzz::expectNone(splitDefect(views, options));
	return 0;
}
