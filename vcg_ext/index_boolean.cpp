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
#include "vcg_ext/arrange/stored_operands.h"
#include "vcg_ext/arrange/triangle_contact.h"
#include "vcg_ext/arrange/triple_contact.h"
#include "vcg_ext/base/huge_pages.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/carry/certificates.h"
#include "vcg_ext/carry/polygons.h"
#include "vcg_ext/distance/operand_reference.h"
#include "vcg_ext/mesh/clean.h"
#include "vcg_ext/mesh/closing_distance.h"
#include "vcg_ext/mesh/near_vertices.h"
#include "vcg_ext/mesh/unmatched_edges.h"
#include "vcg_ext/parts/merge_shared_walls.h"
#include "vcg_ext/solids/block_audit.h"
#include "vcg_ext/solids/cell_labels.h"
#include "vcg_ext/solids/delaunay_pieces.h"
#include "vcg_ext/solids/kept_cuts.h"
#include "vcg_ext/solids/labels.h"
#include "vcg_ext/solids/manifold_copies.h"
#include "vcg_ext/solids/merge_fragments.h"
#include "vcg_ext/solids/merge_walls.h"
#include "vcg_ext/solids/operand_refusals.h"
#include "vcg_ext/solids/overlap_owners.h"
#include "vcg_ext/solids/rounding_loop.h"
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

// Cures what is left by arranging the operands as they are stored.
Status arrangeAsStored(Purpose purpose, Monitor& monitor, Arrangement& out) {
	if (out.placeRepair.faultsAfter == 0) {
		return {};
	}
	const auto arrangeAgain = [&](MeshArrays operands, const Options& options, Arrangement& again) {
		Stages stages(monitor, again.stageTimes, 1, 0);
		arrangeSoup(purpose.forBlocks, std::move(operands), options, monitor, stages, again);
		return stages.status();
	};
	return holdAsStored(arrangeAgain, monitor, out);
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
		if (stages.status().ok() && out.placeRepair.faultsAfter > 0 && !rounded.points.empty()) {
			const Status status = arrangeRounded(purpose, std::move(rounded), monitor, out);
			if (!status.ok()) {
				return status;
			}
		}
		stages.run("rounding_loop", 0, [&] { return arrangeAsStored(purpose, monitor, out); });
		return stages.status();
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

Status arrangeAgain(Purpose purpose, const InputAgain& again, const Options& options,
                    Monitor& monitor, Arrangement& out) {
	MeshArrays input;
	const Status status = guarded([&] { return again(input); });
	return status.ok() ? arrangeFor(purpose, std::move(input), options, monitor, out) : status;
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

// Of an open operand, the same; any other status as it is.
Status orClosingDistance(Status status, const InputAgain& again, const Options& options,
                         Monitor& monitor) {
	return status.code == StatusCode::NotClosed
	           ? withClosingDistance(std::move(status), again, options, monitor)
	           : status;
}

}  // namespace

Status arrangeExpression(MeshArrays input, const InputAgain& again, const Expression& expression,
                         const Options& options, Monitor& monitor, Arrangement& out) {
	return guarded([&] {
		const auto all = input.operands();
		const bool isParityAll = std::all_of(all.begin(), all.end(), [&](OperandId operand) {
			return expression.gates.asksParityOnly(operand);
		});
		Options asked = options;
		asked.windingRule = isParityAll ? WindingRule::Odd : WindingRule::Nonzero;
		Status status = inOrder([&] { return refuseWithoutFaces(input); },
		                        [&] { return arrangeCells(std::move(input), asked, monitor, out); },
		                        [&] { return refuseUnlessSolids(out); });
		return orClosingDistance(std::move(status), again, asked, monitor);
	});
}

Status arrangeOperands(MeshArrays input, const InputAgain& again, const Options& options,
                       Monitor& monitor, Arrangement& out) {
	const Status status = arrange(std::move(input), options, monitor, out);
	if (!isOnlyForEmbedded(status.code, options.selfIntersections)) {
		return status;
	}
	Status result = inOrder([&] { return arrangeAgain(kCells, again, options, monitor, out); },
	                        [&] { return refuseUnlessSolids(out); });
	return orClosingDistance(std::move(result), again, options, monitor);
}

namespace {

constexpr double kMadeBlock = 0.95;  // of a block's progress bar

// Collects a block's faces and vertices from a labelled arrangement.
using Collect = std::function<Status(const Arrangement& arrangement, Block&)>;

// A block from the labelled arrangement to its certificate.
void makeBlock(const Arrangement& arrangement, const Collect& collect, const BlockVariant& variant,
               Monitor& monitor, Stages& stages, Block& out) {
	const Options& options = arrangement.options;
	stages.run("blocks", 0.55, [&] {
		const Status status = collect(arrangement, out);
		out.keptCuts = variant.keptCuts;
		return status;
	});
	const bool mayChange = options.mergeCoplanar || out.anySuspect();
	stages.run("manifold_copies", 0.1, [&] {
		const bool isLater = options.weldNonManifold || variant.isPulledApartLast;
		return isLater ? Status{} : copyNonManifold(arrangement, monitor, out);
	});
	stages.run("merge_fragments", 0.1, [&] { return mergeFragments(arrangement, monitor, out); });
	stages.run("delaunay_pieces", 0.05,
	           [&] { return makePiecesDelaunay(arrangement, monitor, out); });
	stages.run("clean", 0.1, [&] {
		const BlockMeasure unrepaired = measureUnrepaired(arrangement, out, out.repair);
		const Status status = finishBlock(arrangement, monitor, out);
		compareWithUnrepaired(arrangement, unrepaired, out, out.repair);
		return status;
	});
	const bool isAsCut = !mayChange && out.zeroAreaFacesRemoved == 0;
	stages.run("certificates", 0.05,
	           [&] { return certify(arrangement, out, {}, isAsCut, monitor, out.certificate); });
}

// Names the sources of a block that was read from operands arranged again as the first arrangement
// does, and compares it with that one's.
Status finishAgain(const Arrangement& arrangement, const Collect& collect, Monitor& monitor,
                   Block& out) {
	nameFacesAsFirst(*arrangement.again, out.faceSource);
	nameVerticesAsFirst(*arrangement.again, out.vertexSource);
	Block exact;
	return inOrder([&] { return collect(arrangement, exact); },
	               [&] {
		               return arrangement.options.weldNonManifold
		                          ? Status{}
		                          : copyNonManifold(arrangement, monitor, exact);
	               },
	               [&] {
		               compareWithExact(arrangement, exact, out, out.repair);
		               return Status{};
	               });
}

Status extractCollected(const Arrangement& arrangement, const Collect& collect, Monitor& monitor,
                        Block& out) {
	return guarded([&] {
		Stages stages(monitor, out.stageTimes);
		const Arrangement& stored = asStored(arrangement);
		makeBlock(stored, collect, {}, monitor, stages, out);
		stages.run("kept_cuts", 0, [&] {
			const auto remake = [&](const BlockVariant& variant, Block& again) {
				Stages repeated(monitor, again.stageTimes, kMadeBlock, 0);
				makeBlock(stored, collect, variant, monitor, repeated, again);
				return repeated.status();
			};
			return inOrder([&] { return keepCutsThatHold(stored, remake, out); },
			               [&] { return pullApartLast(stored, remake, out); });
		});
		if (arrangement.again != nullptr) {
			stages.run("rounding_loop", 0,
			           [&] { return finishAgain(arrangement, collect, monitor, out); });
		}
		if (arrangement.options.mergeTolerance > 0) {
			stages.run("merge_walls", 0, [&] { return mergeWalls(arrangement, monitor, out); });
		}
		stages.run("polygons", 0.05, [&] { return findFauxEdges(arrangement, {}, monitor, out); });
		return stages.status();
	});
}

}  // namespace

Status extractBlock(const Arrangement& arrangement, Operation operation, Monitor& monitor,
                    Block& out) {
	const WindingRule rule = arrangement.options.windingRule;
	const auto collect = [&](const Arrangement& from, Block& block) {
		if (!from.cells.areKnown()) {
			return collectBlock(from, operation, monitor, block);
		}
		const Status status =
		    collectCells(from, cellSetOf(from, cellPredicateOf(operation, rule)), monitor, block);
		block.operation = operation;
		return status;
	};
	return extractCollected(arrangement, collect, monitor, out);
}

Status extractBlock(const Arrangement& arrangement, const CellPredicate& isInside, Monitor& monitor,
                    Block& out) {
	const auto collect = [&](const Arrangement& from, Block& block) {
		return collectCells(from, cellSetOf(from, isInside), monitor, block);
	};
	return extractCollected(arrangement, collect, monitor, out);
}

Status extractBlock(const Arrangement& arrangement, const CellSet& isInside,
                    const CellSet& isInsideAsStored, Monitor& monitor, Block& out) {
	const auto collect = [&](const Arrangement& from, Block& block) {
		return collectCells(from, &from == &arrangement ? isInside : isInsideAsStored, monitor,
		                    block);
	};
	return extractCollected(arrangement, collect, monitor, out);
}

CellSet boundedCells(const Arrangement& arrangement) {
	CellSet cells(arrangement.cells.windings.size(), 1);
	if (!cells.empty()) {
		cells.front() = 0;
	}
	return cells;
}

namespace {

Status findParts(const Arrangement& arrangement, bool alsoBlocks, Monitor& monitor, Split& out) {
	return guarded([&] {
		out = Split{};
		Stages stages(monitor, out.stageTimes);
		stages.run("sub_surfaces", 0.7, [&] {
			const Status status = findSubSurfaces(arrangement, monitor, out.surfaces);
			if (status.ok()) {
				listStoredTriangles(arrangement, out.surfaces.complex, out.surfaces.stored);
			}
			return status;
		});
		if (arrangement.options.mergeTolerance > 0) {
			stages.run("merge_shared_walls", 0,
			           [&] { return mergeSharedWalls(arrangement, monitor, out.surfaces); });
		}
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

// Windings of an operand of which parts are inside out are read as given, but where all are.
bool isAnyWoundBothWays(const SubBlocks& blocks, Operands operands) {
	return std::any_of(operands.begin(), operands.end(), [&](OperandId operand) {
		const auto anyOf = [&](auto&& isSuch) {
			return std::any_of(blocks.all.begin(), blocks.all.end(), [&](const SubBlock& block) {
				return isSuch(block.windings[operand]);
			});
		};
		return anyOf([](std::int32_t w) { return w < 0; }) &&
		       anyOf([](std::int32_t w) { return w > 0; });
	});
}

// What an embedded operand may not do shows in the arrangement, or when its parts are found.
// \tparam kFind finds them
template <Status (*kFind)(const Arrangement&, Monitor&, Split&)>
Status splitAny(MeshArrays input, const InputAgain& again, const Options& options, Monitor& monitor,
                Arrangement& out, Split& parts) {
	const auto find = [&] { return kFind(out, monitor, parts); };
	const std::size_t count = input.operands().count();
	if (count == 0) {
		return statusOf(StatusCode::EmptyOperand);
	}
	if (count != 2) {
		return inOrder(
		    [&] { return arrangeFor(kSplitSoup, std::move(input), options, monitor, out); }, find);
	}
	const Status status =
	    inOrder([&] { return arrangeSurfaces(std::move(input), options, monitor, out); }, find);
	const bool isSoup = status.ok() ? hasRepeatedFacesAndIsOpen(out) ||
	                                      isAnyWoundBothWays(parts.blocks, out.mesh.operands())
	                                : isOnlyForEmbedded(status.code, options.selfIntersections);
	if (!isSoup) {
		return status;
	}
	return inOrder([&] { return arrangeAgain(kSplitSoup, again, options, monitor, out); }, find);
}

}  // namespace

Status splitOperands(MeshArrays input, const InputAgain& again, const Options& options,
                     Monitor& monitor, Arrangement& out, Split& parts) {
	return splitAny<split>(std::move(input), again, options, monitor, out, parts);
}

Status splitOperandSurfaces(MeshArrays input, const InputAgain& again, const Options& options,
                            Monitor& monitor, Arrangement& out, Split& parts) {
	return splitAny<splitSurfaces>(std::move(input), again, options, monitor, out, parts);
}

Status requireSolids(const std::vector<OperandId>& solids, const InputAgain& again,
                     Monitor& monitor, Arrangement& out, Split& parts) {
	const bool isAnyOpen = std::any_of(solids.begin(), solids.end(),
	                                   [&](OperandId operand) { return !out.closed[operand]; });
	Status status;
	if (isAnyOpen && !out.isSoup) {
		const Options options = out.options;
		status = inOrder([&] { return arrangeAgain(kSplitSoup, again, options, monitor, out); },
		                 [&] { return split(out, monitor, parts); });
	}
	for (std::size_t i = 0; i < solids.size() && status.ok(); ++i) {
		status = guarded([&] { return refuseSolid(out, parts.blocks, solids[i]); });
	}
	return orClosingDistance(std::move(status), again, out.options, monitor);
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
		return collectSubSurfaces(arrangement, split.surfaces, split.blocks, {operand, {}, false},
		                          monitor, out);
	});
}

Status extractSubBlock(const Arrangement& arrangement, const Split& split, SubBlockId block,
                       Monitor& monitor, SplitMesh& out) {
	return guarded([&] {
		monitor.beginStage("split_meshes", 0, 1);
		return collectSubBlock(arrangement, split.surfaces, split.blocks, block, monitor, out);
	});
}

Status extractClip(const Arrangement& arrangement, const Split& split, const Clip& clip,
                   Monitor& monitor, SplitMesh& out) {
	return guarded([&] {
		monitor.beginStage("split_meshes", 0, 1);
		return collectClip(arrangement, split.surfaces, split.blocks, clip, monitor, out);
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
		out = Audit{};
		const Status status = measureBlocks(arrangement, blocks, monitor, out.blocks);
		out.volumeLawResidual = lawResidual(arrangement, blocks, out.blocks);
		return status;
	});
}

Status audit(const Arrangement& arrangement, const std::vector<Block>& blocks,
             const std::vector<CellSet>& cells, Monitor& monitor, Audit& out) {
	return guarded([&] {
		out = Audit{};
		const Status status = measureBlocks(arrangement, blocks, monitor, out.blocks);
		out.volumeLawResidual = cellResidual(arrangement, cells, out.blocks);
		return status;
	});
}

Status audit(const Arrangement& arrangement, const Split& split,
             const std::vector<SplitMesh>& boundaries, Monitor& monitor, SplitAudit& out) {
	return guarded([&] {
		return auditSubBlocks(arrangement, split.surfaces, split.blocks, boundaries, monitor, out);
	});
}

Status audit(const Arrangement& arrangement, const Split& split, const Clip& clip,
             const SplitMesh& mesh, Monitor& monitor, BlockMeasure& measure) {
	return guarded([&] {
		const Status status =
		    auditClip(arrangement, split.surfaces, split.blocks, clip, mesh, measure);
		return status.ok() && pollCancelled(monitor) ? statusOf(StatusCode::Cancelled) : status;
	});
}

namespace {

// The boundary of what the rule calls inside.
Status takeInside(const Arrangement& arrangement, Monitor& monitor, Reference& out) {
	const WindingRule rule = arrangement.options.windingRule;
	Block block;
	const auto inside = [rule](const PerOperand<std::int32_t>& windings) {
		return isInside(rule, windings[kFirst]);
	};
	return inOrder([&] { return extractBlock(arrangement, inside, monitor, block); },
	               [&] { return takeBoundary(arrangement, block, out); });
}

// The operand's faces as they are: only checked and welded.
Status takeTrusted(MeshArrays input, const Options& options, Monitor& monitor, Reference& out) {
	Arrangement arrangement;
	arrangement.options = options;
	return inOrder(
	    [&] {
		    return weldNearVertices(options.weldDistance, monitor, input, arrangement.vertexWeld);
	    },
	    [&] {
		    arrangement.mesh = std::move(input);
		    return prepareSoup(arrangement, monitor);
	    },
	    [&] {
		    takeOperand(arrangement, out);
		    return Status{};
	    });
}

}  // namespace

Status prepareReference(MeshArrays input, const Options& options, bool isSigned, Monitor& monitor,
                        Reference& out) {
	return guarded([&] {
		out = Reference{};
		out.isSigned = isSigned;
		out.rule = options.windingRule;
		if (!isSigned || options.selfIntersections == SelfIntersections::Trust) {
			return takeTrusted(std::move(input), options, monitor, out);
		}
		Options searched = options;
		searched.weldNonManifold = true;
		searched.outputScalar = OutputScalar::Double;
		Arrangement arrangement;
		const Status status = arrangeCells(std::move(input), searched, monitor, arrangement);
		if (!status.ok()) {
			return status;
		}
		out.selfIntersecting = arrangement.selfIntersecting[kFirst];
		out.stageTimes = arrangement.stageTimes;
		if (arrangement.closed[kFirst]) {
			return takeInside(arrangement, monitor, out);
		}
		takeOperand(arrangement, out);
		return Status{};
	});
}

}  // namespace index_boolean
