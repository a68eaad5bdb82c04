// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Count, add up, write: each pass in fixed chunks. A vertex is kept iff its class is, so no face
// has to mark its corners.
#include "blocks.h"

#include "exact_sign.h"
#include "parallel.h"
#include "weld.h"

#include <cmath>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

// What becomes of the faces of one operand that lie inside (or outside) the other. A symmetric
// difference is two solids that share the curve: each has its own copy of the curve's points.
struct Rule {
	bool kept;
	bool turned;
	std::uint8_t curveCopy;
};
constexpr Rule kDrop{false, false, 0};
constexpr Rule kKeep{true, false, 0};
constexpr Rule kTurn{true, true, 0};
constexpr Rule kKeepOther{true, false, 1};
constexpr Rule kTurnOther{true, true, 1};

// [operation][operand][inside the other operand]. A face is kept iff the operation's truth differs
// between its two sides, turned iff it is true in front of the face.
constexpr Rule kRules[kOperationCount][2][2] = {
    // first: outside, inside       second: outside, inside
    {{kKeep, kDrop}, {kKeep, kDrop}},            // union
    {{kDrop, kKeep}, {kDrop, kKeep}},            // intersection
    {{kKeep, kDrop}, {kDrop, kTurn}},            // first minus second
    {{kDrop, kTurn}, {kKeep, kDrop}},            // second minus first
    {{kKeep, kTurnOther}, {kKeepOther, kTurn}},  // symmetric difference
};

// The exact point rounded to float, once: the double next to it decides, unless it lies half-way
// between two floats; then the exact point's side of it does.
double roundedToFloat(const ExactPoint& point, std::size_t axis) {
	const double value = point.rounded[axis];
	const auto nearest = static_cast<float>(value);
	if (point.form == ExactPoint::Form::Explicit || !std::isfinite(nearest)) {
		return static_cast<double>(nearest);
	}
	const double towards = value > static_cast<double>(nearest) ? HUGE_VAL : -HUGE_VAL;
	const double next =
	    static_cast<double>(std::nextafter(nearest, static_cast<float>(towards)));
	if (value - static_cast<double>(nearest) != next - value) {
		return static_cast<double>(nearest);
	}
	const Point middle = point.rounded;
	const int side =
	    compareCoordinate(point, ExactPoint::explicitPoint(middle), static_cast<int>(axis));
	const double low = std::min(static_cast<double>(nearest), next);
	const double high = std::max(static_cast<double>(nearest), next);
	return side == 0 ? static_cast<double>(nearest) : (side < 0 ? low : high);
}

class Collector {
public:
	Collector(const Arrangement& arrangement, Operation operation, Monitor& monitor, Block& out)
	    : arrangement_(arrangement), rules_(kRules[static_cast<std::size_t>(operation)]),
	      monitor_(monitor), out_(out) {}

	Status run();

private:
	Status collectVertices();
	Status collectFaces();
	void collectPieces();

	const Rule& rule(std::size_t operand, std::uint8_t inside) const {
		return rules_[operand][inside];
	}
	bool keepsVertex(std::size_t v) const {
		const std::uint8_t inside = arrangement_.labels.vertexInside[v];
		const int operand = arrangement_.mesh.operandOf(makeId<VertexTag>(v));
		return inside != kUnused && rule(static_cast<std::size_t>(operand), inside).kept;
	}
	const Rule& uncutRule(std::size_t face) const {
		const VertexId corner = arrangement_.mesh.triangles[face][0];
		return rule(static_cast<std::size_t>(arrangement_.mesh.operandOf(makeId<FaceTag>(face))),
		            at(arrangement_.labels.vertexInside, corner));
	}
	bool keepsFace(std::size_t face) const {
		return arrangement_.refinement.isCut[face] == 0 && uncutRule(face).kept;
	}
	void addCurvePoints(std::size_t copies);
	Point outputCoordinates(VertexId v) const;
	void write(std::size_t slot, const std::array<std::uint32_t, 3>& corners, FaceId face,
	           bool turned);

	const Arrangement& arrangement_;
	const Rule (&rules_)[2][2];
	Monitor& monitor_;
	Block& out_;
	std::vector<std::uint32_t> newIndex_;  // per input vertex, if kept
	std::uint32_t firstCurvePoint_ = 0;
};

// Counts what `keeps` in each chunk of n items; returns where each chunk's begin, the total last.
template <class Keeps>
Status countChunks(std::size_t n, int threads, Monitor& monitor, Keeps&& keeps,
                   std::vector<std::size_t>& begins) {
	begins.assign(chunkCount(n, kGrain) + 1, 0);
	const Status status = parallelForChunks(
	    n, kGrain, threads, monitor, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    std::size_t count = 0;
		    for (std::size_t i = begin; i < end; ++i) {
			    count += keeps(i) ? 1 : 0;
		    }
		    begins[chunk + 1] = count;
	    });
	for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
		begins[i + 1] += begins[i];
	}
	return status;
}

Point Collector::outputCoordinates(VertexId v) const {
	if (arrangement_.options.outputScalar == OutputScalar::Double) {
		return arrangement_.coordinates(v);
	}
	const ExactPoint exact = exactPoint(arrangement_, v);
	return {roundedToFloat(exact, 0), roundedToFloat(exact, 1), roundedToFloat(exact, 2)};
}

Status Collector::collectVertices() {
	const std::size_t n = arrangement_.mesh.points.size();
	const int threads = arrangement_.options.threads;
	const auto keeps = [this](std::size_t v) { return keepsVertex(v); };
	std::vector<std::size_t> begins;
	Status status = countChunks(n, threads, monitor_, keeps, begins);
	if (!status.ok()) {
		return status;
	}
	firstCurvePoint_ = static_cast<std::uint32_t>(begins.back());
	newIndex_.resize(n);
	out_.points.resize(begins.back());
	out_.vertexSource.resize(begins.back());
	status = parallelForChunks(
	    n, kGrain, threads, monitor_, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    std::size_t slot = begins[chunk];
		    for (std::size_t v = begin; v < end; ++v) {
			    if (keepsVertex(v)) {
				    newIndex_[v] = static_cast<std::uint32_t>(slot);
				    out_.points[slot] = outputCoordinates(makeId<VertexTag>(v));
				    out_.vertexSource[slot] = makeId<VertexTag>(v);
				    ++slot;
			    }
		    }
	    });
	addCurvePoints(rules_[0][1].curveCopy != rules_[0][0].curveCopy ? 2 : 1);
	return status;
}

// Around each point of the curve both operands have faces inside and outside the other, so every
// operation uses every point.
void Collector::addCurvePoints(std::size_t copies) {
	for (std::size_t copy = 0; copy < copies; ++copy) {
		for (std::uint32_t p = 0; p < arrangement_.curve.pointCount(); ++p) {
			const VertexId v = arrangement_.vertexOf({p});
			out_.points.push_back(outputCoordinates(v));
			out_.vertexSource.push_back(v);
		}
	}
}

void Collector::write(std::size_t slot, const std::array<std::uint32_t, 3>& corners, FaceId face,
                      bool turned) {
	out_.triangles[slot] = turned
	                           ? std::array<std::uint32_t, 3>{corners[0], corners[2], corners[1]}
	                           : corners;
	out_.faceSource[slot] = {face, turned};
}

Status Collector::collectFaces() {
	const std::size_t n = arrangement_.mesh.triangles.size();
	const int threads = arrangement_.options.threads;
	const auto keeps = [this](std::size_t face) { return keepsFace(face); };
	std::vector<std::size_t> begins;
	const Status status = countChunks(n, threads, monitor_, keeps, begins);
	if (!status.ok()) {
		return status;
	}
	out_.triangles.resize(begins.back());
	out_.faceSource.resize(begins.back());
	return parallelForChunks(
	    n, kGrain, threads, monitor_, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    std::size_t slot = begins[chunk];
		    for (std::size_t face = begin; face < end; ++face) {
			    if (keepsFace(face)) {
				    const Triangle& t = arrangement_.mesh.triangles[face];
				    write(slot++,
				          {at(newIndex_, t[0]), at(newIndex_, t[1]), at(newIndex_, t[2])},
				          makeId<FaceTag>(face), uncutRule(face).turned);
			    }
		    }
	    });
}

void Collector::collectPieces() {
	const Refinement& refinement = arrangement_.refinement;
	const auto pointCount = static_cast<std::uint32_t>(arrangement_.curve.pointCount());
	out_.firstPiece = out_.triangles.size();
	for (std::size_t i = 0; i < refinement.cutFaces.size(); ++i) {
		const CutFace& cutFace = refinement.cutFaces[i];
		const std::size_t end = i + 1 < refinement.cutFaces.size()
		                            ? refinement.cutFaces[i + 1].firstPiece
		                            : refinement.pieces.size();
		const auto operand = static_cast<std::size_t>(arrangement_.mesh.operandOf(cutFace.face));
		for (std::size_t piece = cutFace.firstPiece; piece < end; ++piece) {
			const Rule& rules = rule(operand, arrangement_.labels.pieceInside[piece]);
			if (!rules.kept) {
				continue;
			}
			std::array<std::uint32_t, 3> corners{};
			for (std::size_t k = 0; k < 3; ++k) {
				const VertexId v = refinement.pieces[piece][k];
				corners[k] = arrangement_.isCurvePoint(v)
				                 ? firstCurvePoint_ + rules.curveCopy * pointCount +
				                       arrangement_.pointOf(v).value
				                 : at(newIndex_, v);
			}
			out_.triangles.emplace_back();
			out_.faceSource.emplace_back();
			write(out_.triangles.size() - 1, corners, cutFace.face, rules.turned);
		}
	}
}

Status Collector::run() {
	Status status = collectVertices();
	if (status.ok()) {
		status = collectFaces();
	}
	if (status.ok()) {
		collectPieces();
	}
	return status;
}

}  // namespace

const char* operationName(Operation operation) {
	switch (operation) {
	case Operation::Union: return "union";
	case Operation::Intersection: return "intersection";
	case Operation::FirstMinusSecond: return "first_minus_second";
	case Operation::SecondMinusFirst: return "second_minus_first";
	case Operation::SymmetricDifference: return "symmetric_difference";
	}
	return "";
}

Status collectBlock(const Arrangement& arrangement, Operation operation, Monitor& monitor,
                    Block& out) {
	out = Block{};
	out.operation = operation;
	return Collector(arrangement, operation, monitor, out).run();
}

}  // namespace index_boolean
