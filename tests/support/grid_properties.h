// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must hold for every pair of solids on the grid: exact measures, what every block promises,
// invariance. Each function says what is wrong with a pair; nothing, if nothing is.
#pragma once

#include "core/shapes.h"
#include "exact_block.h"
#include "grid_polyhedra.h"
#include "stored_faces.h"

namespace index_boolean::grid {

inline shapes::Mesh meshOf(const GridMesh& m) {
	shapes::Mesh mesh;
	for (const IntPoint& p : m.points) {
		mesh.points.push_back(
		    {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
	}
	mesh.triangles = m.triangles;
	return mesh;
}

// --- exact measures ----------------------------------------------------------------------------

// The exact measures of all blocks of a pair, as the oracle has them.
struct Expected {
	std::array<Rational, kOperationCount> sixVolume;
	// Twice the projections of the faces of union and intersection together, of both differences,
	// and of the symmetric difference: each wall is kept once, or not at all.
	std::array<Rational, 3> doubleProjections;

	explicit Expected(const SolidPair& pair) {
		const Rational a = grid::sixVolume(pair.a), b = grid::sixVolume(pair.b);
		const Rational both = sixVolumeOfBoth(pair.a, pair.b);
		sixVolume = {a + b - both, both, a - both, b - both, a + b - both * 2};
		const CommonWalls walls = commonWalls(pair.a, pair.b);
		const Rational all = grid::doubleProjections(pair.a) + grid::doubleProjections(pair.b);
		doubleProjections = {all - walls.oppositeWay * 2, all - walls.sameWay * 2,
		                     all - walls.sameWay * 2 - walls.oppositeWay * 2};
	}
};

// Whether the stored coordinates are the exact ones rounded to nearest: so is a quotient of two
// integers below 2^53.
inline bool isRounded(const Point& stored, const FractionPoint& exact) {
	for (std::size_t k = 0; k < 3; ++k) {
		if (stored[k] != static_cast<double>(exact.x[k]) / static_cast<double>(exact.w)) {
			return false;
		}
	}
	return true;
}

// What is wrong with one block whose vertices all have names; fills its measure.
inline std::string exactDefect(const Arrangement& arrangement, const Block& block,
                               const Rational& sixVolume, ExactMeasure& measure) {
	measure = exactMeasure(arrangement, block);
	if (measure.sixVolume != sixVolume) {
		return "six volumes are " + measure.sixVolume.text() + ", not " + sixVolume.text();
	}
	const std::vector<FractionPoint> places = placesOf(arrangement, block);
	for (std::size_t v = 0; v < places.size(); ++v) {
		if (!isRounded(block.points[v], places[v])) {
			return "a vertex is not where its name says";
		}
	}
	return facesLieInTheirSources(arrangement, block) ? "" : "a face is not in its source";
}

// Whether the walls of all blocks together are those of the oracle.
inline bool hasWalls(const std::array<ExactMeasure, kOperationCount>& measures,
                     const Expected& expected) {
	const auto walls = [&measures](Operation o) {
		return measures[static_cast<std::size_t>(o)].doubleProjections;
	};
	return walls(Operation::Union) + walls(Operation::Intersection) ==
	           expected.doubleProjections[0] &&
	       walls(Operation::FirstMinusSecond) + walls(Operation::SecondMinusFirst) ==
	           expected.doubleProjections[1] &&
	       walls(Operation::SymmetricDifference) == expected.doubleProjections[2];
}

inline bool allVerticesHaveNames(const Block& block) {
	return std::find(block.vertexSource.begin(), block.vertexSource.end(), VertexId::none()) ==
	       block.vertexSource.end();
}

// As collected, before anything is rounded or cleaned; and as delivered: on so coarse a grid
// nothing falls together in double.
inline std::string measuresDefect(const SolidPair& pair, const Options& options) {
	const Expected expected(pair);
	Monitor monitor;
	Arrangement arrangement;
	const Status status =
	    arrange(arrays(meshOf(pair.a), meshOf(pair.b)), options, monitor, arrangement);
	if (!status.ok()) {
		return "refused: " + describe(status);
	}
	using Stage = std::pair<const char*, decltype(&collectBlock)>;
	for (const auto& [stage, blockOf] :
	     {Stage("collected ", collectBlock), Stage("delivered ", extractBlock)}) {
		std::array<ExactMeasure, kOperationCount> measures;
		bool named = true;
		for (std::size_t k = 0; k < kOperationCount; ++k) {
			const auto operation = static_cast<Operation>(k);
			const std::string which = std::string(stage) + operationName(operation) + ": ";
			Block block;
			if (!blockOf(arrangement, operation, monitor, block).ok()) {
				return which + "refused";
			}
			if (!allVerticesHaveNames(block)) {
				named = false;
				continue;
			}
			const std::string found =
			    exactDefect(arrangement, block, expected.sixVolume[k], measures[k]);
			if (!found.empty()) {
				return which + found;
			}
		}
		if (named && !hasWalls(measures, expected)) {
			return std::string(stage) + "walls are lost or doubled";
		}
	}
	return {};
}

// --- what every block promises -----------------------------------------------------------------

inline std::string promisesDefect(const shapes::BooleanRun& r) {
	const Options& options = r.arrangement.options;
	const bool manifold = !options.weldNonManifold && options.outputScalar == OutputScalar::Double;
	if (!r.status.ok()) {
		return std::string(statusName(r.status.code)) + ": " + describe(r.status);
	}
	for (std::size_t k = 0; k < r.blocks.size(); ++k) {
		const std::string broken = brokenPromise(r.blocks[k]);
		if (!broken.empty() || !r.audit.blocks[k].closed) {
			return broken + " in " + operationName(r.blocks[k].operation);
		}
		if (manifold && !shapes::isManifold(r.blocks[k].triangles)) {
			return std::string("no manifold: ") + operationName(r.blocks[k].operation);
		}
	}
	return r.audit.volumeLawResidual < 1e-6 ? "" : "the volume laws do not hold";
}

inline std::string deliveryDefect(const SolidPair& pair, const Options& options) {
	return promisesDefect(shapes::run(meshOf(pair.a), meshOf(pair.b), options));
}

// In float neighbouring points fall together, so that there is something to clean.
inline std::string floatDeliveryDefect(const SolidPair& pair, const Options& given) {
	Options options = given;
	options.outputScalar = OutputScalar::Float;
	return promisesDefect(shapes::run(meshOf(pair.a), meshOf(pair.b), options));
}

// --- invariance --------------------------------------------------------------------------------

inline constexpr std::array<Operation, kOperationCount> kStraight{
    Operation::Union, Operation::Intersection, Operation::FirstMinusSecond,
    Operation::SecondMinusFirst, Operation::SymmetricDifference};
inline constexpr std::array<Operation, kOperationCount> kSwapped{
    Operation::Union, Operation::Intersection, Operation::SecondMinusFirst,
    Operation::FirstMinusSecond, Operation::SymmetricDifference};

inline std::string difference(const shapes::BooleanRun& one, const shapes::BooleanRun& other,
                              const std::array<Operation, kOperationCount>& ofOther) {
	if (one.status.code != other.status.code) {
		return std::string(statusName(one.status.code)) + ", then " + statusName(other.status.code);
	}
	if (!one.status.ok()) {
		return {};
	}
	for (std::size_t k = 0; k < kOperationCount; ++k) {
		if (shapes::geometry(one.block(kStraight[k])) !=
		    shapes::geometry(other.block(ofOther[k]))) {
			return std::string("another ") + operationName(kStraight[k]);
		}
	}
	return {};
}

inline std::string swapDefect(const SolidPair& pair, const Options& options) {
	const shapes::Mesh a = meshOf(pair.a), b = meshOf(pair.b);
	return difference(shapes::run(a, b, options), shapes::run(b, a, options), kSwapped);
}

inline std::string numberingDefect(const SolidPair& pair, const Options& given) {
	const shapes::Mesh a = meshOf(pair.a), b = meshOf(pair.b);
	std::mt19937 random(static_cast<std::uint32_t>(a.triangles.size() + b.triangles.size()));
	const shapes::Mesh loose = shapes::soup(shapes::permuted(b, random));
	for (const OutputScalar scalar : {OutputScalar::Double, OutputScalar::Float}) {
		Options options = given;
		options.outputScalar = scalar;
		const std::string found =
		    difference(shapes::run(a, b, options),
		               shapes::run(shapes::permuted(a, random), loose, options), kStraight);
		if (!found.empty()) {
			return found + (scalar == OutputScalar::Float ? " in float" : "");
		}
	}
	return {};
}

inline std::string threadsDefect(const SolidPair& pair, const Options& given) {
	const shapes::Mesh a = meshOf(pair.a), b = meshOf(pair.b);
	const shapes::BooleanRun one = shapes::run(a, b, given);
	for (const int threads : {2, 8}) {
		Options options = given;
		options.threads = threads;
		const std::string found = difference(one, shapes::run(a, b, options), kStraight);
		if (!found.empty()) {
			return found + " from " + std::to_string(threads) + " threads";
		}
	}
	return {};
}

}  // namespace index_boolean::grid
