// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one place where the core meets vcglib.
// in: any vcg::tri::TriMesh and a matrix; out: one operand of MeshArrays. Back: a closed surface's
// arrays; out: the same surface in a TriMesh, with normals and bounding box.
// Guarantee: coordinates are the host's own product of matrix and vertex, in the mesh's scalar;
// deleted elements are left out; what is written does not depend on the number of threads.
#pragma once

#include "vcg_ext/base/huge_pages.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/bounding_box.h"
#include "vcg_ext/exact/unit_scale.h"
#include "vcg_ext/mesh/element_counts.h"
#include "vcg_ext/mesh/mesh_arrays.h"

#include <vcg/complex/complex.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <new>
#include <string>

namespace index_boolean {

// The number of elements that one thread reads or writes at a time.
constexpr std::size_t kElementGrain = 16384;

// The positions of the elements that are not deleted, in order; an empty vector if all of
// `elements` live, so that the usual mesh pays nothing.
template <class Elements>
std::vector<std::uint32_t> livePositions(const Elements& elements, std::size_t liveCount) {
	std::vector<std::uint32_t> positions;
	if (liveCount == elements.size()) {
		return positions;
	}
	positions.reserve(liveCount);
	for (std::size_t i = 0; i < elements.size(); ++i) {
		if (!elements[i].IsD()) {
			positions.push_back(static_cast<std::uint32_t>(i));
		}
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

// The elements of a mesh's vector that are not deleted.
// \param liveCount how many the mesh says there are. Throws std::bad_alloc. Complexity: O(n).
template <class Elements>
LiveElements liveElements(const Elements& elements, int liveCount) {
	const auto count = static_cast<std::size_t>(liveCount);
	return {livePositions(elements, count), count};
}

// The vertex ids that a mesh's vertices get in the arrays.
template <class TriMesh>
class VertexNumbering {
public:
	VertexNumbering() = default;  // of no vertices
	// \param live the mesh's vertices that get an id; \param begin the id of the first of them
	VertexNumbering(const TriMesh& mesh, const LiveElements& live, std::size_t begin)
	    : first_(mesh.vert.data()), size_(mesh.vert.size()), begin_(begin) {
		if (live.positions.empty()) {
			return;
		}
		ids_.assign(mesh.vert.size(), VertexId::none());
		for (std::size_t i = 0; i < live.count; ++i) {
			ids_[live[i]] = makeId<VertexTag>(begin + i);
		}
	}

	// none() for a deleted vertex and for a pointer to none of the mesh's vertices: the core then
	// refuses the face.
	VertexId of(const typename TriMesh::VertexType* vertex) const {
		const std::less<const typename TriMesh::VertexType*> before;
		if (vertex == nullptr || before(vertex, first_) || !before(vertex, first_ + size_)) {
			return VertexId::none();
		}
		const auto position = static_cast<std::size_t>(vertex - first_);
		return ids_.empty() ? makeId<VertexTag>(begin_ + position) : ids_[position];
	}

private:
	const typename TriMesh::VertexType* first_ = nullptr;
	std::size_t size_ = 0, begin_ = 0;
	std::vector<VertexId> ids_;  // by position; empty: no vertex is deleted
};

// Arrays for a number of operands, which have no elements yet. Throws std::bad_alloc. O(1).
inline MeshArrays noArrays(std::size_t operands) {
	MeshArrays arrays;
	arrays.vertexOffsets = arrays.faceOffsets = OperandOffsets(operands);
	arrays.faceClass = PerOperand<std::vector<std::uint32_t>>(operands);
	return arrays;
}

// Makes room in the arrays for an operand's elements behind those that are there.
inline void growArrays(std::size_t vertexCount, std::size_t faceCount, OperandId operand,
                       MeshArrays& out) {
	out.points.resizeForOverwrite(out.points.size() + vertexCount);
	out.triangles.resizeForOverwrite(out.triangles.size() + faceCount);
	if (!out.faux.empty()) {
		out.faux.resize(out.triangles.size(), 0);
	}
	out.vertexOffsets.setEnd(operand, out.points.size());
	out.faceOffsets.setEnd(operand, out.triangles.size());
}

// Which elements of a mesh an operand was read from, and what was noticed on the way.
struct OperandElements {
	LiveElements vertices, faces;
	bool anyVertexSelected = false, anyFaceSelected = false;
};

// Reads the faux edges of the operand whose faces are the last in the arrays.
template <class TriMesh>
Status appendFauxEdges(const TriMesh& mesh, const LiveElements& faces, Monitor& monitor,
                       MeshArrays& out) {
	const std::size_t first = out.triangles.size() - faces.count;
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

// Reads a mesh as the next operand: the first into arrays without points, the others behind it.
// \param transform applied to each vertex by vcglib's product; faces keep their corners' order
// \param operand   whose offsets out has place for
// \param out       all operands' arrays
// \param elements  replaced
// \return Ok, Cancelled, or TooLarge before anything is read. Throws std::bad_alloc.
// Complexity: O(n), in parallel.
template <class TriMesh>
Status
appendOperand(const TriMesh& mesh, const vcg::Matrix44<typename TriMesh::ScalarType>& transform,
              OperandId operand, Monitor& monitor, MeshArrays& out, OperandElements& elements) {
	Status status = checkCounts(out.points.size() + static_cast<std::size_t>(mesh.vn),
	                            out.triangles.size() + static_cast<std::size_t>(mesh.fn));
	if (!status.ok()) {
		return status;
	}
	elements = {liveElements(mesh.vert, mesh.vn), liveElements(mesh.face, mesh.fn)};
	const LiveElements &vertices = elements.vertices, &faces = elements.faces;
	growArrays(vertices.count, faces.count, operand, out);
	Point* points = out.points.data() + (out.points.size() - vertices.count);
	std::atomic<bool> anySelected{false}, anyFaceSelected{false}, anyFaux{false};
	const auto readPoints = [&](std::size_t begin, std::size_t end) {
		bool selected = false;
		for (std::size_t i = begin; i < end; ++i) {
			const auto& vertex = mesh.vert[vertices[i]];
			const auto p = transform * vertex.cP();
			points[i] = {static_cast<double>(p[0]), static_cast<double>(p[1]),
			             static_cast<double>(p[2])};
			selected |= vertex.IsS();
		}
		if (selected) {
			anySelected = true;
		}
	};
	status = parallelFor(vertices.count, kElementGrain, 0, monitor, readPoints);
	elements.anyVertexSelected = anySelected;
	if (!status.ok()) {
		return status;
	}

	const VertexNumbering<TriMesh> ids(mesh, vertices, out.points.size() - vertices.count);
	Triangle* triangles = out.triangles.data() + (out.triangles.size() - faces.count);
	const auto readTriangles = [&](std::size_t begin, std::size_t end) {
		bool faux = false, selected = false;
		for (std::size_t i = begin; i < end; ++i) {
			const auto& face = mesh.face[faces[i]];
			triangles[i] = {ids.of(face.cV(0)), ids.of(face.cV(1)), ids.of(face.cV(2))};
			faux |= face.IsAnyF();
			selected |= face.IsS();
		}
		if (faux) {
			anyFaux = true;
		}
		if (selected) {
			anyFaceSelected = true;
		}
	};
	status = parallelFor(faces.count, kElementGrain, 0, monitor, readTriangles);
	elements.anyFaceSelected = anyFaceSelected;
	return status.ok() && anyFaux ? appendFauxEdges(mesh, faces, monitor, out) : status;
}

using IndexedEdge = std::array<std::uint32_t, 2>;

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

// A surface on its way into an empty mesh: coordinates, faces, their unit normals, faux edges,
// bounding box. Elements are appended in ranges and written while the cache still holds them, since
// memory that is touched twice costs more than all else. Vertices and faces may be written at the
// same time, each by one thread.
template <class TriMesh>
class SurfaceWriter {
public:
	// \param points    coordinates that the mesh's scalar holds, else they are rounded
	// \param triangles of indices into points
	// \param faux      per face, as in MeshArrays; empty: there is none
	// \param out       borrowed, as all arrays are
	SurfaceWriter(const Points& points, const IndexTriangles& triangles,
	              const std::vector<std::uint8_t>& faux, TriMesh& out)
	    : points_(points), triangles_(triangles), faux_(faux), out_(out) {}

	// Makes room, also for the optional components and attributes that the mesh has, and writes the
	// bounding box. \return Ok or Cancelled. Throws std::bad_alloc. O(n), in parallel.
	Status begin(Monitor& monitor);

	// Has the vertices written with unit normals: those of their faces, weighted by area, as in the
	// results of MeshLab's own Booleans. \pre begun; no vertex has been written
	// \return Ok or Cancelled. Throws std::bad_alloc. O(n), on this thread.
	Status findVertexNormals(Monitor& monitor);

	// Append the elements [begin, end). \pre begun; the mesh has those before. Throw
	// std::bad_alloc. O(n).
	void appendVertices(std::size_t begin, std::size_t end);
	void appendFaces(std::size_t begin, std::size_t end);

private:
	const Points& points_;
	const IndexTriangles& triangles_;
	const std::vector<std::uint8_t>& faux_;
	TriMesh& out_;
	double scale_ = 1;
	Points normalSums_;
};

template <class TriMesh>
Status SurfaceWriter<TriMesh>::begin(Monitor& monitor) {
	reserveHuge(out_.vert, points_.size());
	reserveHuge(out_.face, triangles_.size());
	out_.vert.reserve(
	    points_.size());  // for the optional components too, which the line above misses
	out_.face.reserve(triangles_.size());
	out_.bbox.SetNull();
	if (points_.empty()) {
		return {};
	}
	BoundingBox box{};
	const Status status = findBoundingBox(points_.data(), points_.size(), 0, monitor, box);
	if (status.ok()) {  // rounding never swaps two coordinates
		out_.bbox.Add(toCoordinate<TriMesh>(box.lo));
		out_.bbox.Add(toCoordinate<TriMesh>(box.hi));
		scale_ = unitScale(box);
	}
	return status;
}

template <class TriMesh>
Status SurfaceWriter<TriMesh>::findVertexNormals(Monitor& monitor) {
	normalSums_.assign(points_.size(), Point{0, 0, 0});
	const auto sum = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			const Point normal = scaledNormal(points_, triangles_[i], scale_);
			for (const std::uint32_t corner : triangles_[i]) {
				for (std::size_t axis = 0; axis < 3; ++axis) {
					normalSums_[corner][axis] += normal[axis];
				}
			}
		}
	};
	return inOrderFor(triangles_.size(), kElementGrain, monitor, sum);
}

template <class TriMesh>
void SurfaceWriter<TriMesh>::appendVertices(std::size_t begin, std::size_t end) {
	vcg::tri::Allocator<TriMesh>::AddVertices(out_, end - begin);
	for (std::size_t i = begin; i < end; ++i) {
		out_.vert[i].P() = toCoordinate<TriMesh>(points_[i]);
		if (!normalSums_.empty()) {
			out_.vert[i].N() = toCoordinate<TriMesh>(direction(normalSums_[i]));
		}
	}
}

template <class TriMesh>
void SurfaceWriter<TriMesh>::appendFaces(std::size_t begin, std::size_t end) {
	vcg::tri::Allocator<TriMesh>::AddFaces(out_, end - begin);
	auto* vertices = out_.vert.data();  // not all of them are there yet, but room for them is
	for (std::size_t i = begin; i < end; ++i) {
		auto& face = out_.face[i];
		const IndexTriangle& triangle = triangles_[i];
		for (int corner = 0; corner < 3; ++corner) {
			face.V(corner) = vertices + triangle[static_cast<std::size_t>(corner)];
		}
		face.N() = toCoordinate<TriMesh>(direction(scaledNormal(points_, triangle, scale_)));
		for (int edge = 0; !faux_.empty() && edge < 3; ++edge) {
			if ((faux_[i] >> edge & 1) != 0) {
				face.SetF(edge);
			}
		}
	}
}

// Adds a user's attribute to an empty mesh, with room for n values. Throws std::bad_alloc.
template <class Value, class TriMesh>
auto addVertexAttribute(const std::string& name, std::size_t n, TriMesh& out) {
	auto attribute = vcg::tri::Allocator<TriMesh>::template AddPerVertexAttribute<Value>(out, name);
	reserveHuge(attribute._handle->data, n);
	return attribute;
}

// The same for faces.
template <class Value, class TriMesh>
auto addFaceAttribute(const std::string& name, std::size_t n, TriMesh& out) {
	auto attribute = vcg::tri::Allocator<TriMesh>::template AddPerFaceAttribute<Value>(out, name);
	reserveHuge(attribute._handle->data, n);
	return attribute;
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
