// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounding moves each point by at most a step; a face then sweeps at most the step times the square
// of the largest distance, and its area changes by at most the step times that. Volumes beyond the
// range of double tell nothing: closedness alone counts.
#include "vcg_ext/parts/split_audit.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace index_boolean {

namespace {

// How far a point may be stored from its rounded place, or from what stands for it.
double mostMoved(const Arrangement& arrangement) {
	return arrangement.placeRepair.largestMove + arrangement.options.mergeTolerance;
}

class Rounding {
public:
	// \param move how far a point may be from its rounded place
	Rounding(const BoundingBox& box, OutputScalar scalar, double move) {
		double reach = 0;
		for (std::size_t axis = 0; axis < 3; ++axis) {
			reach = std::max({reach, -box.lo[axis], box.hi[axis]});
		}
		diagonal_ = std::hypot(box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]);
		const bool isFloat = scalar == OutputScalar::Float;
		const double ulp = isFloat ? static_cast<double>(std::numeric_limits<float>::epsilon())
		                           : std::numeric_limits<double>::epsilon();
		const double least = isFloat ? static_cast<double>(std::numeric_limits<float>::denorm_min())
		                             : std::numeric_limits<double>::denorm_min();
		step_ = ulp * reach + least + move;
	}

	// Whether rounding can make up a difference between volumes below this many faces.
	bool explains(double difference, std::size_t faces) const {
		return isBelow(difference, faces, length() * length());
	}
	// The same of areas. They are roots of squares, which leave the range of double before they do.
	bool explainsArea(double difference, std::size_t faces) const {
		const double lost = std::sqrt(std::numeric_limits<double>::min());
		const double beyond = std::fabs(difference) - lost * static_cast<double>(faces + 1);
		return !std::isfinite(difference) || isBelow(std::max(beyond, 0.0), faces, length());
	}

private:
	double length() const { return diagonal_ + step_; }
	// \param reach what a face changes by if a corner moves by 1
	bool isBelow(double difference, std::size_t faces, double reach) const {
		constexpr double kRoundings = 16;  // of a face: its corners and its terms of the sum
		const double most = kRoundings * static_cast<double>(faces) * step_ * reach;
		return !(std::fabs(difference) > most + std::numeric_limits<double>::min());
	}

	double diagonal_, step_;
};

// The volume of the blocks in an operand less its own: 0 but for roundings, as also where it is
// open. Where cells are known, its own is that of what is inside.
double lawDifference(const Arrangement& arrangement, const SubBlocks& blocks, OperandId operand) {
	const WindingRule rule = arrangement.options.windingRule;
	const bool isOfInside = arrangement.cells.areKnown();
	if (arrangement.isSoup && rule == WindingRule::Odd && !isOfInside) {
		return 0;  // windings are parities
	}
	double sum = 0;
	for (const SubBlock& block : blocks.all) {
		const std::int32_t winding = block.windings[operand];
		sum += (isOfInside ? (isInside(rule, winding) ? 1 : 0) : winding) * block.volume;
	}
	return sum - (blocks.turned[operand] ? -1 : 1) * arrangement.volume[operand];
}

// The faces of a block's boundary in the exact arrangement.
std::size_t faceCount(const SubSurfaces& surfaces, const SubBlock& block) {
	std::size_t count = 0;
	for (const SubSurfaceSide& side : block.sides) {
		count += at(surfaces.all, side.of).faceCount;
	}
	return count;
}

}  // namespace

Status auditSubBlocks(const Arrangement& arrangement, const SubSurfaces& surfaces,
                      const SubBlocks& blocks, const std::vector<SplitMesh>& boundaries,
                      Monitor& monitor, SplitAudit& out) {
	out = SplitAudit{};
	const Points& points = arrangement.mesh.points;
	const Options& options = arrangement.options;
	BoundingBox box{};
	Status status = findBoundingBox(points.data(), points.size(), options.threads, monitor, box);
	const Rounding inside(box, OutputScalar::Double, 0);
	const Rounding delivered(box, options.outputScalar, mostMoved(arrangement));
	bool right = true;
	double most = 0;
	double total = 0;
	for (const OperandId operand : arrangement.volume.operands()) {
		total += std::fabs(arrangement.volume[operand]);
		const double difference = lawDifference(arrangement, blocks, operand);
		right = right && inside.explains(difference, 2 * surfaces.complex.faces.size());
		most = std::max(most, std::fabs(difference));
	}
	// Of volumes beyond the range of double no law tells anything; closedness is what counts then.
	const double residual = most / total;
	out.volumeLawResidual = std::isfinite(residual) ? residual : 0;
	for (std::size_t i = 0; i < boundaries.size() && status.ok(); ++i) {
		const SplitMesh& mesh = boundaries[i];
		const BlockMeasure measure = measureSurface(mesh.points, mesh.triangles, options.threads);
		// A block that is thinner than the scalar's steps may have lost faces, or all of them.
		const std::size_t faces = std::max(mesh.triangles.size() + mesh.zeroAreaFacesRemoved,
		                                   faceCount(surfaces, blocks.all[i]));
		out.closed = out.closed && measure.closed;
		right = right && delivered.explains(measure.volume - blocks.all[i].volume, faces);
		if (pollCancelled(monitor)) {
			status.code = StatusCode::Cancelled;
		}
	}
	if (status.ok() && !(right && out.closed)) {
		status.code = StatusCode::InternalError;
	}
	return status;
}

Status auditClip(const Arrangement& arrangement, const SubSurfaces& surfaces,
                 const SubBlocks& blocks, const Clip& clip, const SplitMesh& mesh,
                 BlockMeasure& measure) {
	const Points& points = arrangement.mesh.points;
	const Options& options = arrangement.options;
	Monitor monitor;
	BoundingBox box{};
	Status status = findBoundingBox(points.data(), points.size(), options.threads, monitor, box);
	double area = 0;
	std::size_t faces = mesh.triangles.size();  // and those that these stand for
	for (const SubSurfaceId s : surfaces.ofOperand[clip.surface]) {
		if (isInClip(blocks, options.windingRule, clip, s)) {
			area += at(surfaces.all, s).area;
			faces += at(surfaces.all, s).faceCount;
		}
	}
	measure = measureSurface(mesh.points, mesh.triangles, options.threads);
	const Rounding delivered(box, options.outputScalar, mostMoved(arrangement));
	// Where faces have been cleaned away, sheets that rounding has laid on each other are, too; and
	// what was arranged again as stored is without its folds.
	const bool isWhole = mesh.zeroAreaFacesRemoved == 0 && arrangement.again == nullptr;
	if (status.ok() && isWhole && !delivered.explainsArea(measure.area - area, faces)) {
		status.code = StatusCode::InternalError;
	}
	return status;
}

}  // namespace index_boolean
