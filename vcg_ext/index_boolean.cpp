// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The driver: one line a stage, in the order data flows. Stages are timed here, from outside.
#include "vcg_ext/index_boolean.h"

#include "vcg_ext/arrange/coincident_faces.h"
#include "vcg_ext/arrange/curve_points.h"
#include "vcg_ext/arrange/cut_lines.h"
#include "vcg_ext/arrange/duplicate_faces.h"
#include "vcg_ext/arrange/equal_points.h"
#include "vcg_ext/arrange/loops.h"
#include "vcg_ext/arrange/octree_pairs.h"
#include "vcg_ext/arrange/operands.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/refined_closed.h"
#include "vcg_ext/arrange/repair_places.h"
#include "vcg_ext/arrange/retriangulate.h"
#include "vcg_ext/arrange/self_intersections.h"
#include "vcg_ext/arrange/soup_contacts.h"
#include "vcg_ext/arrange/triangle_contact.h"
#include "vcg_ext/arrange/triple_contact.h"
#include "vcg_ext/base/huge_pages.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/carry/certificates.h"
#include "vcg_ext/carry/polygons.h"
#include "vcg_ext/mesh/clean.h"
#include "vcg_ext/mesh/closing_distance.h"
#include "vcg_ext/mesh/near_vertices.h"
#include "vcg_ext/mesh/unmatched_edges.h"
#include "vcg_ext/solids/block_repair.h"
#include "vcg_ext/solids/cell_labels.h"
#include "vcg_ext/solids/delaunay_pieces.h"
#include "vcg_ext/solids/kept_cuts.h"
#include "vcg_ext/solids/labels.h"
#include "vcg_ext/solids/manifold_copies.h"
#include "vcg_ext/solids/merge_fragments.h"
#include "vcg_ext/solids/overlap_owners.h"
#include "vcg_ext/solids/turned_components.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <new>

namespace index_boolean {

namespace {

// Runs one body with exceptions turned into a status, in the default floating-point environment;
// its stages pass memory on to each other.
template <class Body>
Status guarded(Body&& body) {
	const FpEnvironmentGuard environment;
	Status status;
	try {
		const PageReuse pages;
		return body();
	} catch (const std::bad_alloc&) {
		status.code = StatusCode::OutOfMemory;
	} catch (...) {
		status.code = StatusCode::InternalError;
	}
	return status;
}

// Runs stages one after another until one fails; times each.
class Stages {
public:
	// \param done how far the progress bar is \param scale of the stages' shares of it
	Stages(Monitor& monitor, std::vector<StageTime>& times, double done = 0, double scale = 1)
	    : monitor_(monitor), times_(times), done_(done), scale_(scale) {}

	// `share` is the stage's part of the progress bar.
	template <class Stage>
	void run(const char* name, double share, Stage&& stage) {
		if (!status_.ok()) {
			return;
		}
		using Clock = std::chrono::steady_clock;
		monitor_.beginStage(name, done_, done_ + scale_ * share);
		done_ += scale_ * share;
		const Clock::time_point start = Clock::now();
		status_ = stage();
		times_.push_back({name, std::chrono::duration<double>(Clock::now() - start).count()});
		if (status_.ok() && monitor_.cancelled()) {
			status_.code = StatusCode::Cancelled;
		}
	}

	const Status& status() const { return status_; }

private:
	Monitor& monitor_;
	std::vector<StageTime>& times_;
	double done_, scale_;
	Status status_;
};

// The faces before it have no rounded corner. In double only pieces have, unless the repair has
// moved others; in float every face may have.
std::size_t firstRounded(const Arrangement& arrangement, const Block& block) {
	const bool piecesOnly =
	    arrangement.options.outputScalar == OutputScalar::Double && !anyInputMoved(arrangement);
	return piecesOnly ? block.firstPiece : 0;
}

Status cleanBlock(const Arrangement& arrangement, Monitor& monitor, Block& block) {
	const FaceRange range{firstRounded(arrangement, block), block.triangles.size()};
	CleanResult cleaned;
	const Status status = cleanMesh(range, arrangement.options.threads, monitor, block.points,
	                                block.triangles, cleaned);
	if (status.ok()) {
		block.zeroAreaFacesRemoved = cleaned.zeroAreaFacesRemoved;
		if (block.isApart) {  // it stays so where nothing is cleaned
			block.suspect.assign(block.suspect.size(), 0);
		}
		for (const std::uint32_t vertex : cleaned.looked) {
			block.suspect[vertex] = 1;
		}
		cleaned.faces.apply(block.faceSource);
		cleaned.vertices.apply(block.vertexSource);
		cleaned.vertices.apply(block.suspect);
	}
	return status;
}

// Cleaning may join sheets that were apart, and without doubt only the stored coordinates tell
// which edges are too short for what.
Status finishBlock(const Arrangement& arrangement, Monitor& monitor, Block& block) {
	const Options& options = arrangement.options;
	const std::size_t first = firstRounded(arrangement, block);  // cleaning leaves those before it
	return inOrder([&] { return cleanBlock(arrangement, monitor, block); },
	               [&] {
		               return options.weldNonManifold
		                          ? Status{}
		                          : copyNonManifoldAsStored(options.outputScalar, monitor, block);
	               },
	               [&] { return dropTurnedComponents(arrangement, first, monitor, block); });
}

// The volume of each operation's block, NaN if it was not delivered.
using BlockVolumes = std::array<double, kOperationCount>;

// The largest |law| over the laws whose blocks have all been delivered.
double largestLawResidual(const PerOperand<double>& operand, const BlockVolumes& volumes) {
	const auto of = [&volumes](Operation o) { return volumes[static_cast<std::size_t>(o)]; };
	const double either = of(Operation::Union);
	const double both = of(Operation::Intersection);
	const double firstOnly = of(Operation::FirstMinusSecond);
	const double secondOnly = of(Operation::SecondMinusFirst);
	const double one = of(Operation::SymmetricDifference);
	const double laws[] = {
	    either + both - operand[kFirst] - operand[kSecond],
	    firstOnly + both - operand[kFirst],
	    secondOnly + both - operand[kSecond],
	    either - firstOnly - operand[kSecond],
	    either - secondOnly - operand[kFirst],
	    one - firstOnly - secondOnly,
	    one + 2 * both - operand[kFirst] - operand[kSecond],
	};
	double most = 0;
	for (const double law : laws) {
		most = std::fmax(most, std::fabs(law));  // fmax passes over NaN: a block not delivered
	}
	// Of volumes beyond the range of double no law tells anything; closedness is what counts then.
	const double residual = most / (operand[kFirst] + operand[kSecond]);
	return std::isfinite(residual) ? residual : 0;
}

// What an arrangement is for: blocks need closed operands and labels, splitting needs neither.
// Operands that may meet themselves are a soup.
struct Purpose {
	bool forBlocks, isSoup;
};
constexpr Purpose kBlocks{true, false}, kSplit{false, false};
constexpr Purpose kCells{true, true}, kSplitSoup{false, true};

// All stages of the arrangement of two embedded operands, in the order in which data flows.
void arrangeEmbedded(bool forBlocks, MeshArrays input, const Options& options, Monitor& monitor,
                     Stages& stages, Arrangement& out) {
	out.options = options;
	out.mesh = std::move(input);
	std::vector<FacePair> pairs;
	Contacts contacts;
	std::vector<VertexId> vertexOfName;
	stages.run("operands", 0.2, [&] {
		return forBlocks ? prepareOperands(out, monitor) : prepareSurfaces(out, monitor);
	});
	stages.run("self_intersections", 0.05, [&] { return checkSelfIntersections(out, monitor); });
	stages.run("coincident_faces", 0.05, [&] { return findCoincidentFaces(out, monitor); });
	stages.run("octree_pairs", 0.2, [&] { return findPairs(out.mesh, options, monitor, pairs); });
	stages.run("triangle_contact", 0.15,
	           [&] { return findContacts(out, pairs, monitor, contacts); });
	stages.run("curve_points", 0.05,
	           [&] { return numberCurvePoints(out, contacts, monitor, vertexOfName); });
	stages.run("cut_lines", 0.05,
	           [&] { return findCutLines(out, contacts, vertexOfName, monitor); });
	stages.run("retriangulate", 0.08, [&] { return retriangulate(out, monitor); });
	stages.run("repair_places", 0.02, [&] { return repairPlaces(out, monitor); });
	stages.run("loops", 0.05, [&] { return traceLoops(out, monitor); });
	if (forBlocks) {
		stages.run("labels", 0.05, [&] { return labelArrangement(out, monitor); });
		stages.run("overlap_owners", 0.05, [&] { return chooseOverlapOwners(out, monitor); });
	}
}

// All stages of a soup's arrangement.
void arrangeSoup(bool forBlocks, MeshArrays input, const Options& options, Monitor& monitor,
                 Stages& stages, Arrangement& out) {
	out.options = options;
	out.mesh = std::move(input);
	Contacts contacts;
	std::vector<VertexId> vertexOfName;
	stages.run("operands", 0.1, [&] { return prepareSoup(out, monitor); });
	if (options.selfIntersections == SelfIntersections::Refuse) {
		stages.run("self_intersections", 0, [&] { return checkSelfIntersections(out, monitor); });
	}
	stages.run("soup_contacts", 0.2, [&] { return findSoupContacts(out, monitor, contacts); });
	stages.run("curve_points", 0.05,
	           [&] { return numberCurvePoints(out, contacts, monitor, vertexOfName); });
	// Points that are known to be one spare the search for triples most of its arithmetic.
	stages.run("triple_contact", 0.1, [&] {
		return inOrder([&] { return mergeEqualPoints(out, monitor, contacts, vertexOfName); },
		               [&] { return findTripleContacts(out, vertexOfName, monitor, contacts); });
	});
	stages.run("equal_points", 0.05,
	           [&] { return mergeEqualPoints(out, monitor, contacts, vertexOfName); });
	stages.run("cut_lines", 0.05,
	           [&] { return findCutLines(out, contacts, vertexOfName, monitor); });
	stages.run("retriangulate", 0.15, [&] { return retriangulate(out, monitor); });
	stages.run("refined_closed", 0.02, [&] { return findRefinedClosed(out, monitor); });
	stages.run("repair_places", 0.03, [&] { return repairPlaces(out, monitor); });
	stages.run("loops", 0.05, [&] { return traceLoops(out, monitor); });
	if (forBlocks) {
		stages.run("cell_labels", 0.2, [&] { return labelCells(out, monitor); });
	}
}

void arrangeOnce(Purpose purpose, MeshArrays input, const Options& options, Monitor& monitor,
                 Stages& stages, Arrangement& out) {
	const auto& arrangeAll = purpose.isSoup ? arrangeSoup : arrangeEmbedded;
	arrangeAll(purpose.forBlocks, std::move(input), options, monitor, stages, out);
}

// Arranges the operands as their coordinates are stored, where the arrangement of the exact ones
// leaves faults: walls that are nearer to each other than numbers are touch then, or cross clearly.
// \param operands rounded \param out stays if that is no better, or they are no operands
Status arrangeRounded(Purpose purpose, MeshArrays operands, Monitor& monitor, Arrangement& out) {
	Options options = out.options;
	if (!purpose.isSoup) {
		options.selfIntersections = SelfIntersections::Refuse;
	}
	Arrangement rounded;
	rounded.stageTimes.push_back({out.stageTimes.front().stage, 0});  // what comes before both
	Stages stages(monitor, rounded.stageTimes, 1, 0);
	arrangeOnce(purpose, std::move(operands), options, monitor, stages, rounded);
	const StatusCode code = stages.status().code;
	if (code == StatusCode::Cancelled || code == StatusCode::OutOfMemory) {
		return stages.status();
	}
	if (code == StatusCode::Ok && rounded.placeRepair.faultsAfter < out.placeRepair.faultsAfter) {
		for (std::size_t i = 0; i < rounded.stageTimes.size(); ++i) {
			rounded.stageTimes[i].seconds += out.stageTimes[i].seconds;
		}
		rounded.options = out.options;
		rounded.vertexWeld = out.vertexWeld;
		out = std::move(rounded);
	}
	return {};
}

Status arrangeFor(Purpose purpose, MeshArrays input, const Options& options, Monitor& monitor,
                  Arrangement& out) {
	return guarded([&] {
		out = Arrangement{};
		Stages stages(monitor, out.stageTimes);
		VertexWeld weld;
		stages.run("near_vertices", 0,
		           [&] { return weldNearVertices(options.weldDistance, monitor, input, weld); });
		if (!stages.status().ok()) {
			return stages.status();
		}
		MeshArrays rounded;
		if (options.certify && !isStoredExactly(input.points, options.outputScalar)) {
			rounded = input;
			roundPlaces(options.outputScalar, rounded.points);
		}
		arrangeOnce(purpose, std::move(input), options, monitor, stages, out);
		out.vertexWeld = weld;
		return stages.status().ok() && out.placeRepair.faultsAfter > 0 && !rounded.points.empty()
		           ? arrangeRounded(purpose, std::move(rounded), monitor, out)
		           : stages.status();
	});
}

}  // namespace

Status arrange(MeshArrays input, const Options& options, Monitor& monitor, Arrangement& out) {
	return arrangeFor(kBlocks, std::move(input), options, monitor, out);
}

Status arrangeCells(MeshArrays input, const Options& options, Monitor& monitor, Arrangement& out) {
	return arrangeFor(kCells, std::move(input), options, monitor, out);
}

Status arrangeSurfaces(MeshArrays input, const Options& options, Monitor& monitor,
                       Arrangement& out) {
	return arrangeFor(kSplit, std::move(input), options, monitor, out);
}

namespace {

// Whether a refusal of operands that have to be embedded is none of operands that need not be.
bool isOnlyForEmbedded(StatusCode code, SelfIntersections selfIntersections) {
	switch (code) {
	case StatusCode::SelfIntersecting:
		return selfIntersections != SelfIntersections::Refuse;
	case StatusCode::NestedComponents:
	case StatusCode::NotClosed:
	case StatusCode::NotOriented:
	case StatusCode::NoVolume:
		return true;
	default:
		return false;
	}
}

Status arrangeAgain(Purpose purpose, const InputAgain& again, const Options& options,
                    Monitor& monitor, Arrangement& out) {
	MeshArrays input;
	const Status status = guarded([&] { return again(input); });
	return status.ok() ? arrangeFor(purpose, std::move(input), options, monitor, out) : status;
}

// Of an operand that encloses nothing. All of its faces may cancel: it is a double-sided model
// then, but under the rule Odd a set like any other.
Status refuseWithoutInside(const Arrangement& arrangement, OperandId operand) {
	const MeshArrays& mesh = arrangement.mesh;
	const bool isOdd = arrangement.options.windingRule == WindingRule::Odd;
	const std::size_t pairs = cancellingPairs(mesh, operand, isOdd);
	Status status;
	if (pairs == 0 || !isOdd) {
		status.code = pairs == 0 ? StatusCode::NoVolume : StatusCode::EmptyOperand;
		status.operand = numberOf(operand);
		status.count = pairs;
	}
	return status;
}

// Ok, or the first operand of which no block can be made: it is open, or encloses nothing.
Status refuseEmptyOperands(const Arrangement& arrangement) {
	return forEachOperand(arrangement.mesh.operands(), [&](OperandId operand) {
		if (!arrangement.closed[operand]) {
			return refuseOpen(arrangement, operand);
		}
		const auto& windings = arrangement.cells.windings;
		const bool isEmpty = std::all_of(windings.begin(), windings.end(), [&](const auto& w) {
			return !isInside(arrangement.options.windingRule, w[operand]);
		});
		return isEmpty ? refuseWithoutInside(arrangement, operand) : Status{};
	});
}

// The refusal of an open operand, with the distance that would close it, if there is one. It is
// tried before it is named.
Status withClosingDistance(Status refusal, const InputAgain& again, Options options,
                           Monitor& monitor) {
	const OperandId operand = makeId<OperandTag>(static_cast<std::size_t>(refusal.operand));
	const Status found = guarded([&] {
		MeshArrays input;
		return inOrder(
		    [&] { return again(input); },
		    [&] { return findClosingDistance(input, operand, monitor, options.weldDistance); });
	});
	if (!found.ok() || options.weldDistance == 0) {
		return found.code == StatusCode::Cancelled ? found : refusal;
	}
	Arrangement tried;
	const Status status = arrangeAgain(kCells, again, options, monitor, tried);
	if (status.ok() && tried.closed[operand]) {
		refusal.closingDistance = options.weldDistance;
	}
	return status.code == StatusCode::Cancelled ? status : refusal;
}

}  // namespace

Status arrangeOperands(MeshArrays input, const InputAgain& again, const Options& options,
                       Monitor& monitor, Arrangement& out) {
	const Status status = arrange(std::move(input), options, monitor, out);
	if (!isOnlyForEmbedded(status.code, options.selfIntersections)) {
		return status;
	}
	Status result = inOrder([&] { return arrangeAgain(kCells, again, options, monitor, out); },
	                        [&] { return refuseEmptyOperands(out); });
	return result.code == StatusCode::NotClosed
	           ? withClosingDistance(std::move(result), again, options, monitor)
	           : result;
}

namespace {

constexpr double kMadeBlock = 0.95;  // of a block's progress bar

// Collects a block's faces and vertices: collect(block).
using Collect = std::function<Status(Block&)>;

// A block from the labelled arrangement to its certificate.
void makeBlock(const Arrangement& arrangement, const Collect& collect,
               const std::vector<FaceId>& keptCuts, Monitor& monitor, Stages& stages, Block& out) {
	const Options& options = arrangement.options;
	stages.run("blocks", 0.55, [&] {
		const Status status = collect(out);
		out.keptCuts = keptCuts;
		return status;
	});
	const bool mayChange = options.mergeCoplanar || out.anySuspect();
	stages.run("manifold_copies", 0.1, [&] {
		return options.weldNonManifold ? Status{} : copyNonManifold(arrangement, monitor, out);
	});
	stages.run("merge_fragments", 0.1, [&] { return mergeFragments(arrangement, monitor, out); });
	stages.run("delaunay_pieces", 0.05,
	           [&] { return makePiecesDelaunay(arrangement, monitor, out); });
	stages.run("clean", 0.1, [&] {
		const BlockMeasure unrepaired = measureUnrepaired(arrangement, out);
		const Status status = finishBlock(arrangement, monitor, out);
		compareWithUnrepaired(arrangement, unrepaired, out);
		return status;
	});
	const bool isAsCut = !mayChange && out.zeroAreaFacesRemoved == 0;
	stages.run("certificates", 0.05,
	           [&] { return certify(arrangement, out, {}, isAsCut, monitor, out.certificate); });
}

Status extractCollected(const Arrangement& arrangement, const Collect& collect, Monitor& monitor,
                        Block& out) {
	return guarded([&] {
		Stages stages(monitor, out.stageTimes);
		makeBlock(arrangement, collect, {}, monitor, stages, out);
		stages.run("kept_cuts", 0, [&] {
			const auto remake = [&](const std::vector<FaceId>& keptCuts, Block& again) {
				Stages repeated(monitor, again.stageTimes, kMadeBlock, 0);
				makeBlock(arrangement, collect, keptCuts, monitor, repeated, again);
				return repeated.status();
			};
			return keepCutsThatHold(arrangement, remake, out);
		});
		stages.run("polygons", 0.05, [&] { return findFauxEdges(arrangement, {}, monitor, out); });
		return stages.status();
	});
}

}  // namespace

Status extractBlock(const Arrangement& arrangement, Operation operation, Monitor& monitor,
                    Block& out) {
	const WindingRule rule = arrangement.options.windingRule;
	const auto collect = [&](Block& block) {
		if (!arrangement.cells.areKnown()) {
			return collectBlock(arrangement, operation, monitor, block);
		}
		const Status status =
		    collectCells(arrangement, cellPredicateOf(operation, rule), monitor, block);
		block.operation = operation;
		return status;
	};
	return extractCollected(arrangement, collect, monitor, out);
}

Status extractBlock(const Arrangement& arrangement, const CellPredicate& isInside, Monitor& monitor,
                    Block& out) {
	const auto collect = [&](Block& block) {
		return collectCells(arrangement, isInside, monitor, block);
	};
	return extractCollected(arrangement, collect, monitor, out);
}

namespace {

Status findParts(const Arrangement& arrangement, bool alsoBlocks, Monitor& monitor, Split& out) {
	return guarded([&] {
		out = Split{};
		Stages stages(monitor, out.stageTimes);
		stages.run("sub_surfaces", 0.7,
		           [&] { return findSubSurfaces(arrangement, monitor, out.surfaces); });
		if (alsoBlocks) {
			stages.run("sub_blocks", 0.3, [&] {
				return findSubBlocks(arrangement, out.surfaces, Walls::All, monitor, out.blocks);
			});
		}
		return stages.status();
	});
}

}  // namespace

Status split(const Arrangement& arrangement, Monitor& monitor, Split& out) {
	return findParts(arrangement, true, monitor, out);
}

Status splitSurfaces(const Arrangement& arrangement, Monitor& monitor, Split& out) {
	return findParts(arrangement, false, monitor, out);
}

namespace {

// Faces that an operand has more than once are walls once, but may be what closes it.
bool hasRepeatedFacesAndIsOpen(const Arrangement& arrangement) {
	const auto all = arrangement.mesh.operands();
	return std::any_of(all.begin(), all.end(), [&](OperandId operand) {
		return arrangement.duplicates.takenOnce[operand] > 0 && !arrangement.closed[operand];
	});
}

// What an embedded operand may not do shows in the arrangement, or when its parts are found.
// \param find finds them
template <class Find>
Status splitAny(MeshArrays input, const InputAgain& again, const Options& options, Monitor& monitor,
                Arrangement& out, Find&& find) {
	const Status status =
	    inOrder([&] { return arrangeSurfaces(std::move(input), options, monitor, out); }, find);
	const bool isSoup = isOnlyForEmbedded(status.code, options.selfIntersections) ||
	                    (status.ok() && hasRepeatedFacesAndIsOpen(out));
	if (!isSoup) {
		return status;
	}
	return inOrder([&] { return arrangeAgain(kSplitSoup, again, options, monitor, out); }, find);
}

}  // namespace

Status splitOperands(MeshArrays input, const InputAgain& again, const Options& options,
                     Monitor& monitor, Arrangement& out, Split& parts) {
	return splitAny(std::move(input), again, options, monitor, out,
	                [&] { return split(out, monitor, parts); });
}

Status splitOperandSurfaces(MeshArrays input, const InputAgain& again, const Options& options,
                            Monitor& monitor, Arrangement& out, Split& parts) {
	return splitAny(std::move(input), again, options, monitor, out,
	                [&] { return splitSurfaces(out, monitor, parts); });
}

Status extractCurve(const Arrangement& arrangement, Monitor& monitor, CurveLines& out) {
	return guarded([&] {
		monitor.beginStage("curve_lines", 0, 1);
		return drawCurve(arrangement, monitor, out);
	});
}

Status extractSubSurfaces(const Arrangement& arrangement, const Split& split, OperandId operand,
                          Monitor& monitor, SplitMesh& out) {
	return guarded([&] {
		monitor.beginStage("split_meshes", 0, 1);
		return collectSubSurfaces(arrangement, split.surfaces, split.blocks, operand, monitor, out);
	});
}

Status extractSubBlock(const Arrangement& arrangement, const Split& split, SubBlockId block,
                       Monitor& monitor, SplitMesh& out) {
	return guarded([&] {
		monitor.beginStage("split_meshes", 0, 1);
		return collectSubBlock(arrangement, split.surfaces, split.blocks, block, monitor, out);
	});
}

Status operandSeams(const Arrangement& arrangement, const GivenTriangles& given,
                    const SameAttributes& same, Monitor& monitor, Seams& out) {
	return guarded([&] { return findSeams(arrangement, given, same, monitor, out); });
}

Status attributeSources(const Arrangement& arrangement, const AttributeInput& input,
                        Monitor& monitor, SourcedMesh& mesh, AttributeSources& out) {
	return guarded([&] {
		monitor.beginStage("attributes", 0, 1);
		return findAttributeSources(arrangement, input, monitor, mesh, out);
	});
}

Status countOpenEdges(const SourcedMesh& mesh, int threads, Monitor& monitor, std::size_t& count) {
	return guarded([&] { return countUnmatchedEdges(mesh.triangles, threads, monitor, count); });
}

Status audit(const Arrangement& arrangement, const std::vector<Block>& blocks, Monitor& monitor,
             Audit& out) {
	return guarded([&] {
		Status status;
		out = Audit{};
		BlockVolumes volumes;
		volumes.fill(std::nan(""));
		for (std::size_t i = 0; i < blocks.size(); ++i) {
			const BlockMeasure measure =
			    measureSurface(blocks[i].points, blocks[i].triangles, arrangement.options.threads);
			volumes[static_cast<std::size_t>(blocks[i].operation)] = measure.volume;
			out.blocks.push_back(measure);
			if (!measure.closed) {
				status.code = StatusCode::InternalError;
			}
		}
		out.volumeLawResidual = largestLawResidual(arrangement.volume, volumes);
		if (status.ok() && pollCancelled(monitor)) {
			status.code = StatusCode::Cancelled;
		}
		return status;
	});
}

Status audit(const Arrangement& arrangement, const Split& split,
             const std::vector<SplitMesh>& boundaries, Monitor& monitor, SplitAudit& out) {
	return guarded([&] {
		return auditSubBlocks(arrangement, split.surfaces, split.blocks, boundaries, monitor, out);
	});
}

}  // namespace index_boolean
