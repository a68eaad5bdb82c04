// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The entry: two surfaces are intersected once (an Arrangement), and every block, sub-surface and
// sub-block is read from it. Source: Mei & Tipper, "Simple and Robust Boolean Operations for
// Triangulated Surfaces" (2013; Zhou, Qin, Mei, Tipper, Mathematics 2023, 11, 2713), on exact
// decisions. Guarantee: coordinates decide signs, signs make indices, after that only indices. No
// epsilon; the result is the same, byte for byte, for any number of threads.
// The one public header: it brings all that a caller needs, but for the templates on vcglib's
// meshes (mesh/mesh_arrays_vcg.h). Other headers change as the core does.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/arrange/curve_lines.h"
#include "vcg_ext/base/huge_pages.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/carry/attributes.h"
#include "vcg_ext/distance/signed_distance.h"
#include "vcg_ext/mesh/folded_fans.h"
#include "vcg_ext/mesh/measure.h"
#include "vcg_ext/mesh/mesh_arrays.h"
#include "vcg_ext/parts/clip.h"
#include "vcg_ext/parts/split_audit.h"
#include "vcg_ext/parts/split_meshes.h"
#include "vcg_ext/solids/blocks.h"
#include "vcg_ext/solids/cell_blocks.h"
#include "vcg_ext/solids/expression.h"
#include "vcg_ext/solids/expression_tokens.h"

namespace index_boolean {

// Intersects the two closed operands of `input`, for blocks.
// \param input   both operands' arrays; moved in, the arrangement owns them from here on
// \param options octree limits, threads, output scalar
// \param monitor progress and cancel
// \param out     the arrangement; only meaningful if the status is Ok
// \return any StatusCode
// Complexity: O(n + k log k) for n faces and k points of the curve, beyond the octree's descent.
Status arrange(MeshArrays input, const Options& options, Monitor& monitor, Arrangement& out);

// Reads one block from the arrangement. Empty blocks are a valid result.
// \param operation which set the block bounds
// \param out       a closed, consistently oriented surface without zero-area faces
// \return Ok, Cancelled, OutOfMemory or InternalError
// Complexity: O(n).
Status extractBlock(const Arrangement& arrangement, Operation operation, Monitor& monitor,
                    Block& out);

// Intersects any number of surfaces, each of which may meet itself, for blocks: by cells, from
// which a block of any combination of the operands can be read. Open operands part space as well,
// but their winding number is 0 everywhere. Parameters as above.
// \return any StatusCode but NotClosed, NotOriented, NoVolume, NestedComponents; SelfIntersecting
//         only if options.selfIntersections is Refuse
// Complexity: O(n log n + p + t) beyond the search for pairs that meet, for n triangles of the
// arrangement, p pairs of faces in contact and t triples of faces pairwise in contact.
Status arrangeCells(MeshArrays input, const Options& options, Monitor& monitor, Arrangement& out);

// Reads the block of all cells for which a predicate is true, of an arrangement with cells.
// \return Ok, Cancelled, OutOfMemory; InternalError if it is true of the outside, or there are no
//         cells. Complexity: O(n), and a call for each cell.
Status extractBlock(const Arrangement& arrangement, const CellPredicate& isInside, Monitor& monitor,
                    Block& out);

// The same of a set of cells.
// \param isInside         cells of the arrangement
// \param isInsideAsStored cells of asStored(arrangement), which is nearly always the same
// \return as above. Complexity: O(n).
Status extractBlock(const Arrangement& arrangement, const CellSet& isInside,
                    const CellSet& isInsideAsStored, Monitor& monitor, Block& out);

// Makes a run's operands once more, as they were given, for a run that begins again.
using InputAgain = std::function<Status(MeshArrays& out)>;

// Intersects the operands of an expression, for the blocks of its statements (cellsOf): as
// arrangeCells, and each operand has to be closed as it is cut and to enclose something. If the
// expression asks for no more than the parity of winding numbers, faces may be turned anyhow.
// options.windingRule does not matter: what an operand is true of is the expression's.
// \param input the expression's operands, in its order
// \param again called only for what is not closed: to find the weldDistance that would close it
// \return as arrangeCells; EmptyOperand, NotClosed (with that distance, if there is one),
//         NotOriented or NoVolume of an operand that is not so
// Complexity: as arrangeCells.
Status arrangeExpression(MeshArrays input, const InputAgain& again, const Expression& expression,
                         const Options& options, Monitor& monitor, Arrangement& out);

// All bounded cells: what the outside does not reach, whatever the winding numbers are. Throws
// std::bad_alloc. \pre the arrangement has cells. Complexity: O(c) for c cells.
CellSet boundedCells(const Arrangement& arrangement);

// Intersects two closed operands, which may meet themselves, for blocks: as arrange, and what that
// refuses for being no embedded surfaces, as arrangeCells. options.selfIntersections says what is
// searched and refused.
// \param again called only then; may throw std::bad_alloc; what it returns unless Ok is returned
// \return any StatusCode: of operands that meet themselves, SelfIntersecting if that is asked for;
//         NotClosed or NotOriented of what is open as it is cut, with the weldDistance that would
//         close it, if there is one; EmptyOperand of what is double-sided, NoVolume of what else
//         has no inside
// Complexity: of those two.
Status arrangeOperands(MeshArrays input, const InputAgain& again, const Options& options,
                       Monitor& monitor, Arrangement& out);

// Intersects any two surfaces, open or closed, orientable or not, for splitting: without labels, so
// that no block can be read from the arrangement. Parameters as above.
// \return any StatusCode but NotClosed, NotOriented, NoVolume, NestedComponents
// Complexity: as arrange.
Status arrangeSurfaces(MeshArrays input, const Options& options, Monitor& monitor,
                       Arrangement& out);

// All parts of surfaces, and of the space between them.
struct Split {
	SubSurfaces surfaces;
	SubBlocks blocks;
	std::vector<StageTime> stageTimes;
};

// Finds all sub-surfaces and sub-blocks of an arrangement, of either entry.
// \return Ok, Cancelled, OutOfMemory, InternalError; SelfIntersecting where an operand meets itself
//         in a way that shows
// Complexity: O(n + k log k) for n faces, k of them at the curve.
Status split(const Arrangement& arrangement, Monitor& monitor, Split& out);

// Finds the sub-surfaces alone: out.blocks stays empty.
// \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: as split.
Status splitSurfaces(const Arrangement& arrangement, Monitor& monitor, Split& out);

// Intersects any number of surfaces, which may meet themselves, and finds all their parts, or the
// sub-surfaces alone: two as arrangeSurfaces and split; what meets itself, and any other number of
// them, as one soup. options.selfIntersections and `again` as for arrangeOperands.
// \return any StatusCode but NotClosed, NotOriented, NoVolume, NestedComponents; EmptyOperand, too,
//         if there is no operand
// Complexity: of those two.
Status splitOperands(MeshArrays input, const InputAgain& again, const Options& options,
                     Monitor& monitor, Arrangement& out, Split& parts);
Status splitOperandSurfaces(MeshArrays input, const InputAgain& again, const Options& options,
                            Monitor& monitor, Arrangement& out, Split& parts);

// Sees to it that some operands of a split are solids, by which others can be clipped: what is open
// as it was given may be closed as it is cut, or by the winding rule, for which the run begins
// again as one soup. \param again as for splitOperands \param out, parts as splitOperands has left
// them; replaced if the run begins again \return NotClosed (with the weldDistance that
// would close it, if there is one), NotOriented, or as refuseWithoutInside of the first
//         operand that is none; any StatusCode of splitOperands. Complexity: O(c) for c sub-blocks,
//         or that of splitOperands.
Status requireSolids(const std::vector<OperandId>& solids, const InputAgain& again,
                     Monitor& monitor, Arrangement& out, Split& parts);

// The loops as polylines; see curve_lines.h. \return Ok, Cancelled, OutOfMemory
// Complexity: O(k) for k points of the curve.
Status extractCurve(const Arrangement& arrangement, Monitor& monitor, CurveLines& out);

// The mesh of all sub-surfaces of one operand, and the boundary of one sub-block; see
// split_meshes.h; and those sub-surfaces that lie in an operand that is a solid, or outside of
// it; see clip.h. \return Ok, Cancelled, OutOfMemory, InternalError
// Complexity: O(n) for n triangles of the arrangement; of a sub-block, O(m) for its m faces.
Status extractSubSurfaces(const Arrangement& arrangement, const Split& split, OperandId operand,
                          Monitor& monitor, SplitMesh& out);
Status extractSubBlock(const Arrangement& arrangement, const Split& split, SubBlockId block,
                       Monitor& monitor, SplitMesh& out);
Status extractClip(const Arrangement& arrangement, const Split& split, const Clip& clip,
                   Monitor& monitor, SplitMesh& out);

// The seams of the operands, which stay in every output; see seams.h.
// \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: O(n log n); nothing without seams.
Status operandSeams(const Arrangement& arrangement, const GivenTriangles& given,
                    const SameAttributes& same, Monitor& monitor, Seams& out);

// Of which input elements a block's or split mesh's elements take their attributes; see
// attributes.h. \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: O(n), in parallel.
Status attributeSources(const Arrangement& arrangement, const AttributeInput& input,
                        Monitor& monitor, SourcedMesh& mesh, AttributeSources& out);

// The edges of a delivered mesh that are open by index: where vertices in one place stay apart, at
// seams. \return Ok, Cancelled, OutOfMemory. Complexity: O(n), in parallel, if there are none.
Status countOpenEdges(const SourcedMesh& mesh, int threads, Monitor& monitor, std::size_t& count);

// What is known of delivered blocks by measuring them.
struct Audit {
	std::vector<BlockMeasure> blocks;  // one per block given
	double volumeLawResidual = 0;      // the largest |law| over the sum of the operands' volumes
};

// Measures delivered blocks (volume, area, components, closedness) and the volume laws.
// \param blocks any of the arrangement's blocks
// \param out    one measure per block, in the same order, and the largest law residual
// \return Ok, Cancelled, OutOfMemory, or InternalError if a block is not closed
// Complexity: O(n) for all faces of the blocks, in parallel.
Status audit(const Arrangement& arrangement, const std::vector<Block>& blocks, Monitor& monitor,
             Audit& out);

// The same of blocks of cells: the law is that a block has the volume of its cells.
// \param cells of each block \return as above. Complexity: O(n + c) for c cells of all blocks.
Status audit(const Arrangement& arrangement, const std::vector<Block>& blocks,
             const std::vector<CellSet>& cells, Monitor& monitor, Audit& out);

// Audits the sub-blocks of a split, with their boundaries as delivered; see split_audit.h.
// \param boundaries of all sub-blocks, in their order, or none
// \return Ok, Cancelled, OutOfMemory, or InternalError if a check fails
// Complexity: O(n) for all faces of the boundaries.
Status audit(const Arrangement& arrangement, const Split& split,
             const std::vector<SplitMesh>& boundaries, Monitor& monitor, SplitAudit& out);

// Audits a clip, with its mesh as delivered; see split_audit.h.
// \param measure replaced: of the mesh
// \return Ok, Cancelled, OutOfMemory, or InternalError if the check fails
// Complexity: O(n) for its faces and the operands' points.
Status audit(const Arrangement& arrangement, const Split& split, const Clip& clip,
             const SplitMesh& mesh, Monitor& monitor, BlockMeasure& measure);
// Makes the surface that distances are measured to (SignedDistance) of one operand: welded, without
// zero-area faces, right side out. With signs, and unless it is trusted, it is searched: of one
// that meets itself, or has components in each other, it is the boundary of what
// options.windingRule calls inside, as stored in doubles; of any other one, the faces as given. A
// surface that is open, cut by itself, too, is taken as it is. Trusted, or without signs: the faces
// as given. \param input    one operand \param isSigned whether signs are wanted \return Ok,
// Cancelled, OutOfMemory, EmptyOperand, NotFinite, IndexOutOfRange, TooLarge,
//         InternalError; NoVolume if it is closed and encloses nothing; SelfIntersecting only if
//         options.selfIntersections is Refuse
// Complexity: as arrangeCells; trusted, O(n).
Status prepareReference(MeshArrays input, const Options& options, bool isSigned, Monitor& monitor,
                        Reference& out);

}  // namespace index_boolean
