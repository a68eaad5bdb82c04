// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one place where the core meets vcglib.
// in: any vcg::tri::TriMesh and a matrix; out: one operand of MeshArrays. Back: a closed surface's
// arrays; out: the same surface in a TriMesh, with normals and bounding box.
// Guarantee: coordinates are the host's own product of matrix and vertex, in the mesh's scalar;
// deleted elements are left out; what is written does not depend on the number of threads.
#pragma once

#include "bounding_box.h"
#include "huge_pages.h"
#include "mesh_arrays.h"
#include "mesh_checks.h"
#include "parallel.h"

#include <vcg/complex/complex.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <new>

namespace index_boolean {

// The number of elements that one thread reads or writes at a time.
constexpr std::size_t kElementGrain = 16384;

// How many threads the parallel loops use.
inline std::size_t threadCount() {
#ifdef _OPENMP
	return static_cast<std::size_t>(omp_get_max_threads());
#else
	return 1;
#endif
}

// The positions of the elements that are not deleted, in order; an empty vector if all of
// `elements` live, so that the usual mesh pays nothing.
template <class Elements>
std::vector<std::uint32_t> livePositions(const Elements& elements, std::size_t liveCount) {
	std::vector<std::uint32_t> positions;
	if (liveCount == elements.size())
		return positions;
	positions.reserve(liveCount);
	for (std::size_t i = 0; i < elements.size(); ++i) {
		if (!elements[i].IsD())
			positions.push_back(static_cast<std::uint32_t>(i));
	}
	return positions;
}

// Which elements of a mesh became an operand's vertices or faces.
struct LiveElements {
	std::vector<std::uint32_t> positions;  // as livePositions gives them
	std::size_t count = 0;

	// The position in the mesh's vector of the operand's i-th element.
	std::size_t operator[](std::size_t i) const { return positions.empty() ? i : positions[i]; }
};

template <class Elements>
LiveElements liveElements(const Elements& elements, int liveCount) {
	const auto count = static_cast<std::size_t>(liveCount);
	return {livePositions(elements, count), count};
}

// The vertex ids that a mesh's vertices get in the arrays.
template <class TriMesh>
class VertexNumbering {
public:
	// \param live the mesh's vertices that get an id; \param begin the id of the first of them
	VertexNumbering(const TriMesh& mesh, const LiveElements& live, std::size_t begin)
	    : first_(mesh.vert.data()), size_(mesh.vert.size()), begin_(begin) {
		if (live.positions.empty())
			return;
		ids_.assign(mesh.vert.size(), VertexId::none());
		for (std::size_t i = 0; i < live.count; ++i)
			ids_[live[i]] = makeId<VertexTag>(begin + i);
	}

	// none() for a deleted vertex and for a pointer to none of the mesh's vertices: the core then
	// refuses the face.
	VertexId of(const typename TriMesh::VertexType* vertex) const {
		const std::less<const typename TriMesh::VertexType*> before;
		if (vertex == nullptr || before(vertex, first_) || !before(vertex, first_ + size_))
			return VertexId::none();
		const auto position = static_cast<std::size_t>(vertex - first_);
		return ids_.empty() ? makeId<VertexTag>(begin_ + position) : ids_[position];
	}

private:
	const typename TriMesh::VertexType* first_;
	std::size_t size_, begin_;
	std::vector<VertexId> ids_;  // by position; empty: no vertex is deleted
};

// Makes room in the arrays for an operand's elements behind those that are there.
inline void growArrays(std::size_t vertexCount, std::size_t faceCount, int operand,
                       MeshArrays& out) {
	const auto first = static_cast<std::size_t>(operand);
	out.vertexBegin[first] = static_cast<std::uint32_t>(out.points.size());
	out.faceBegin[first] = static_cast<std::uint32_t>(out.triangles.size());
	reserveHuge(out.points, out.points.size() + vertexCount);
	reserveHuge(out.triangles, out.triangles.size() + faceCount);
	out.points.resize(out.points.size() + vertexCount);
	out.triangles.resize(out.triangles.size() + faceCount);
	if (!out.faux.empty())
		out.faux.resize(out.triangles.size(), 0);
	for (std::size_t end = first + 1; end < out.vertexBegin.size(); ++end) {
		out.vertexBegin[end] = static_cast<std::uint32_t>(out.points.size());
		out.faceBegin[end] = static_cast<std::uint32_t>(out.triangles.size());
	}
}

// Which elements of a mesh an operand was read from, and what was noticed on the way.
struct OperandElements {
	LiveElements vertices, faces;
	bool anyVertexSelected = false, anyFaceSelected = false;
};

// Reads the faux edges of the operand whose faces are the last in the arrays, if there are any:
// most meshes have none.
template <class TriMesh>
Status appendFauxEdges(const TriMesh& mesh, Monitor& monitor, OperandElements& elements,
                       MeshArrays& out) {
	const LiveElements& faces = elements.faces;
	const std::size_t first = out.triangles.size() - faces.count;
	std::atomic<bool> anyFaux{false}, anySelected{false};
	Status status = parallelFor(faces.count, kElementGrain, 0, monitor,
	                            [&](std::size_t begin, std::size_t end) {
		                            bool faux = false, selected = false;
		                            for (std::size_t i = begin; i < end; ++i) {
			                            faux |= mesh.face[faces[i]].IsAnyF();
			                            selected |= mesh.face[faces[i]].IsS();
		                            }
		                            if (faux)
			                            anyFaux = true;
		                            if (selected)
			                            anySelected = true;
	                            });
	elements.anyFaceSelected = anySelected;
	if (!status.ok() || !anyFaux)
		return status;
	out.faux.resize(out.triangles.size(), 0);
	return parallelFor(
	    faces.count, kElementGrain, 0, monitor, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t i = begin; i < end; ++i) {
			    const auto& face = mesh.face[faces[i]];
			    out.faux[first + i] = static_cast<std::uint8_t>(
			        (face.IsF(0) ? 1U : 0U) | (face.IsF(1) ? 2U : 0U) | (face.IsF(2) ? 4U : 0U));
		    }
	    });
}

// Reads a mesh as the next operand: operand 0 into empty arrays, then operand 1.
// \param transform applied to each vertex by vcglib's product; faces keep their corners' order
// \param operand   0 or 1
// \param out       both operands' arrays
// \param elements  replaced
// \return Ok, Cancelled, or TooLarge before anything is read. Throws std::bad_alloc.
// Complexity: O(n), in parallel.
template <class TriMesh>
Status appendOperand(const TriMesh& mesh,
                     const vcg::Matrix44<typename TriMesh::ScalarType>& transform, int operand,
                     Monitor& monitor, MeshArrays& out, OperandElements& elements) {
	Status status = checkCounts(out.points.size() + static_cast<std::size_t>(mesh.vn),
	                            out.triangles.size() + static_cast<std::size_t>(mesh.fn));
	if (!status.ok())
		return status;
	elements = {liveElements(mesh.vert, mesh.vn), liveElements(mesh.face, mesh.fn)};
	const LiveElements &vertices = elements.vertices, &faces = elements.faces;
	growArrays(vertices.count, faces.count, operand, out);
	Point* points = out.points.data() + (out.points.size() - vertices.count);
	std::atomic<bool> anySelected{false};
	const auto readPoints = [&](std::size_t begin, std::size_t end) {
		bool selected = false;
		for (std::size_t i = begin; i < end; ++i) {
			const auto& vertex = mesh.vert[vertices[i]];
			const auto p = transform * vertex.cP();
			points[i] = {static_cast<double>(p[0]), static_cast<double>(p[1]),
			             static_cast<double>(p[2])};
			selected |= vertex.IsS();
		}
		if (selected)
			anySelected = true;
	};
	status = parallelFor(vertices.count, kElementGrain, 0, monitor, readPoints);
	elements.anyVertexSelected = anySelected;
	if (!status.ok())
		return status;

	const VertexNumbering<TriMesh> ids(mesh, vertices, out.points.size() - vertices.count);
	Triangle* triangles = out.triangles.data() + (out.triangles.size() - faces.count);
	const auto readTriangles = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			const auto& face = mesh.face[faces[i]];
			triangles[i] = {ids.of(face.cV(0)), ids.of(face.cV(1)), ids.of(face.cV(2))};
		}
	};
	status = parallelFor(faces.count, kElementGrain, 0, monitor, readTriangles);
	return status.ok() ? appendFauxEdges(mesh, monitor, elements, out) : status;
}

using IndexedEdge = std::array<std::uint32_t, 2>;

// A power of two that brings the largest coordinate in a box near 1, so that products of
// coordinates neither overflow nor vanish; 1 if there is no coordinate but zero.
inline double unitScale(const BoundingBox& box) {
	double largest = 0;
	for (std::size_t axis = 0; axis < 3; ++axis)
		largest = std::max({largest, std::abs(box.lo[axis]), std::abs(box.hi[axis])});
	constexpr int kSmallestExponent = -1022;  // beyond, the scale itself would overflow
	return largest > 0 ? std::ldexp(1.0, -std::max(std::ilogb(largest), kSmallestExponent)) : 1.0;
}

// The cross product of a triangle's edges after scaling: along the face's normal.
inline Point scaledNormal(const Points& points, const IndexTriangle& triangle, double scale) {
	const Point &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
	Point u, v;
	for (std::size_t i = 0; i < 3; ++i) {
		u[i] = b[i] * scale - a[i] * scale;
		v[i] = c[i] * scale - a[i] * scale;
	}
	return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// Adds to `sums` the normals of the faces at each vertex of [begin, end), in the faces' order.
inline void sumNormals(const Points& points, const IndexTriangles& triangles, double scale,
                       std::size_t begin, std::size_t end, Points& sums) {
	for (const IndexTriangle& triangle : triangles) {
		std::array<bool, 3> inside;
		for (std::size_t corner = 0; corner < 3; ++corner)
			inside[corner] = triangle[corner] - begin < end - begin;  // false below begin: it wraps
		if (!inside[0] && !inside[1] && !inside[2])
			continue;
		const Point normal = scaledNormal(points, triangle, scale);
		for (std::size_t corner = 0; corner < 3; ++corner) {
			if (inside[corner]) {
				Point& sum = sums[triangle[corner]];
				sum = {sum[0] + normal[0], sum[1] + normal[1], sum[2] + normal[2]};
			}
		}
	}
}

// The direction of a vector; zero if it has none.
inline Point direction(const Point& v) {
	const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
	const double factor = length > 0 ? 1 / length : 0;
	return {v[0] * factor, v[1] * factor, v[2] * factor};
}

// A point in the mesh's scalar.
template <class TriMesh>
typename TriMesh::CoordType toCoordinate(const Point& p) {
	using Scalar = typename TriMesh::ScalarType;
	return typename TriMesh::CoordType(static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]),
	                                   static_cast<Scalar>(p[2]));
}

// Makes room in an empty mesh for a surface that fillSurface then writes.
// Throws std::bad_alloc. Several meshes may be allocated at the same time.
template <class TriMesh>
void allocateSurface(std::size_t vertexCount, std::size_t faceCount, TriMesh& out) {
	reserveHuge(out.vert, vertexCount);
	reserveHuge(out.face, faceCount);
	vcg::tri::Allocator<TriMesh>::AddVertices(out, vertexCount);
	vcg::tri::Allocator<TriMesh>::AddFaces(out, faceCount);
}

// The box of all points; all zero if there is none. \return Ok or Cancelled
inline Status boxOf(const Points& points, Monitor& monitor, BoundingBox& box) {
	return points.empty() ? Status{}
	                      : findBoundingBox(points.data(), points.size(), 0, monitor, box);
}

// Writes a surface into a mesh of its size: coordinates, faces, bounding box, and the faces' unit
// normals.
// \param points    coordinates that the mesh's scalar holds, else they are rounded
// \param triangles of indices into points
// \param out       made by allocateSurface for these counts
// \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: O(n), in parallel.
template <class TriMesh>
Status fillSurface(const Points& points, const IndexTriangles& triangles, Monitor& monitor,
                   TriMesh& out) {
	BoundingBox box{};
	Status status = boxOf(points, monitor, box);
	if (!status.ok())
		return status;
	const double scale = unitScale(box);
	const auto writeVertices = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i)
			out.vert[i].P() = toCoordinate<TriMesh>(points[i]);
	};
	status = parallelFor(points.size(), kElementGrain, 0, monitor, writeVertices);
	if (!status.ok())
		return status;

	const auto writeFaces = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			auto& face = out.face[i];
			for (int corner = 0; corner < 3; ++corner)
				face.V(corner) = &out.vert[triangles[i][static_cast<std::size_t>(corner)]];
			face.N() = toCoordinate<TriMesh>(direction(scaledNormal(points, triangles[i], scale)));
		}
	};
	out.bbox.SetNull();
	if (!points.empty()) {  // rounding never swaps two coordinates
		out.bbox.Add(toCoordinate<TriMesh>(box.lo));
		out.bbox.Add(toCoordinate<TriMesh>(box.hi));
	}
	return parallelFor(triangles.size(), kElementGrain, 0, monitor, writeFaces);
}

// Gives the vertices of a surface written before unit normals: those of their faces, weighted by
// area, as in the results of MeshLab's own Booleans. Parameters, errors as above.
template <class TriMesh>
Status fillVertexNormals(const Points& points, const IndexTriangles& triangles, Monitor& monitor,
                         TriMesh& out) {
	BoundingBox box{};
	const Status status = boxOf(points, monitor, box);
	if (!status.ok())
		return status;
	const double scale = unitScale(box);
	Points normalSums;
	assignHuge(normalSums, points.size(), Point{0, 0, 0});
	const auto writeNormals = [&](std::size_t begin, std::size_t end) {
		sumNormals(points, triangles, scale, begin, end, normalSums);
		for (std::size_t i = begin; i < end; ++i)
			out.vert[i].N() = toCoordinate<TriMesh>(direction(normalSums[i]));
	};
	// Each range passes over all faces, so there is one for each thread; the sums do not depend on
	// the ranges.
	const std::size_t vertexGrain = std::max(kElementGrain, points.size() / threadCount() + 1);
	return parallelFor(points.size(), vertexGrain, 0, monitor, writeNormals);
}

// Marks the faux edges of a surface written before.
// \param faux per face, as in MeshArrays; empty: there is none
// \return Ok or Cancelled
template <class TriMesh>
Status fillFauxEdges(const std::vector<std::uint8_t>& faux, Monitor& monitor, TriMesh& out) {
	const auto write = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			for (int edge = 0; edge < 3; ++edge) {
				if ((faux[i] >> edge & 1) != 0)
					out.face[i].SetF(edge);
			}
		}
	};
	return parallelFor(faux.size(), kElementGrain, 0, monitor, write);
}

// Adds the edges of polylines between a mesh's vertices.
// \param edges of indices into the mesh's vertices
// Throws std::bad_alloc.
template <class TriMesh>
void addEdges(const std::vector<IndexedEdge>& edges, TriMesh& out) {
	auto next = vcg::tri::Allocator<TriMesh>::AddEdges(out, edges.size());
	for (const IndexedEdge& edge : edges) {
		next->V(0) = &out.vert[edge[0]];
		next->V(1) = &out.vert[edge[1]];
		++next;
	}
}

}  // namespace index_boolean
