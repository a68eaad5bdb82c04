// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything is found before anything is written, so that a run which stops leaves the layer alone.
#include "layers/distance_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <string>

namespace index_boolean {

namespace {

constexpr const char* kDistance = "distance";
constexpr const char* kDirection = "distance_direction";
constexpr const char* kClosestPoint = "closest_point";
constexpr const char* kClosestFace = "closest_face";

using Alloc = vcg::tri::Allocator<CMeshO>;

// What vertices and faces of a mesh do alike, under one name each.
struct Vertices {
	static auto& of(CMeshO& mesh) { return mesh.vert; }
	template <class Value>
	static auto attribute(CMeshO& mesh, const std::string& name) {
		Alloc::DeletePerVertexAttribute(mesh, name);  // of any type, if there is one
		return Alloc::AddPerVertexAttribute<Value>(mesh, name);
	}
};

struct Faces {
	static auto& of(CMeshO& mesh) { return mesh.face; }
	template <class Value>
	static auto attribute(CMeshO& mesh, const std::string& name) {
		Alloc::DeletePerFaceAttribute(mesh, name);
		return Alloc::AddPerFaceAttribute<Value>(mesh, name);
	}
};

Point3m toPoint(const Point& p) { return toCoordinate<CMeshO>(p); }

// Hosts take a quality into a histogram, which must not meet what is no number.
Scalarm qualityOf(const DistanceSample& sample, const DistanceWriting& writing) {
	constexpr double kMost = std::numeric_limits<Scalarm>::max();
	double quality = sample.distance;
	if (std::isnan(quality)) {
		const double most = writing.negate ? -writing.maximum : writing.maximum;
		quality = sample.sign == 0 ? 0 : sample.sign * most;  // no number times an infinite one
	}
	return static_cast<Scalarm>(std::clamp(quality, -kMost, kMost));
}

// Blue, white, red; grey where there is no distance.
vcg::Color4b colourOf(const DistanceSample& sample, const DistanceWriting& writing) {
	if (std::isnan(sample.distance)) {
		return vcg::Color4b(128, 128, 128, 255);
	}
	constexpr std::array<double, 3> kBelow{33, 102, 172}, kZero{247, 247, 247}, kAbove{178, 24, 43};
	const double place = writing.colorRange > 0 ? sample.distance / writing.colorRange : 0;
	const std::array<double, 3>& end = place < 0 ? kBelow : kAbove;
	const double share = std::min(std::fabs(place), 1.0);
	std::array<unsigned char, 3> channel{};
	for (std::size_t k = 0; k < 3; ++k) {
		channel[k] =
		    static_cast<unsigned char>(std::lround(kZero[k] + (end[k] - kZero[k]) * share));
	}
	return vcg::Color4b(channel[0], channel[1], channel[2], 255);
}

// Writes the samples from `first` on to all live elements of a kind.
template <class Kind>
void write(const DistanceWriting& writing, const LiveElements& live, std::size_t first,
           CMeshO& mesh) {
	const DistanceSample* samples = writing.samples->data() + first;
	auto& elements = Kind::of(mesh);
	auto distance = Kind::template attribute<Scalarm>(mesh, kDistance);
	for (std::size_t i = 0; i < live.count; ++i) {
		elements[live[i]].Q() = qualityOf(samples[i], writing);
		distance[live[i]] = static_cast<Scalarm>(samples[i].distance);
	}
	if (writing.direction) {
		auto direction = Kind::template attribute<Point3m>(mesh, kDirection);
		for (std::size_t i = 0; i < live.count; ++i) {
			direction[live[i]] = toPoint(samples[i].gradient);
		}
	}
	if (writing.closest) {
		auto point = Kind::template attribute<Point3m>(mesh, kClosestPoint);
		auto face = Kind::template attribute<Scalarm>(mesh, kClosestFace);
		for (std::size_t i = 0; i < live.count; ++i) {
			const bool isNone = std::isnan(samples[i].distance);
			point[live[i]] = toPoint(samples[i].closest);
			face[live[i]] = isNone ? Scalarm(-1)
			                       : static_cast<Scalarm>((*writing.closestFaces)[samples[i].face]);
		}
	}
	for (std::size_t i = 0; writing.color && i < live.count; ++i) {
		elements[live[i]].C() = colourOf(samples[i], writing);
	}
}

// Normals are of the mesh itself: its matrix is not applied to them.
void writeNormals(const DistanceWriting& writing, const LiveElements& live, CMeshO& mesh) {
	auto turned = mesh.Tr;
	turned.SetColumn(3, Point3m(0, 0, 0));
	turned.transposeInPlace();  // of a gradient, as of a plane
	for (std::size_t i = 0; i < live.count; ++i) {
		const Point& gradient = (*writing.samples)[i].gradient;
		Point3m normal = std::isnan(gradient[0]) ? Point3m(0, 0, 0) : turned * toPoint(gradient);
		mesh.vert[live[i]].N() = normal.Normalize();
	}
}

void selectInside(const DistanceWriting& writing, const LiveElements& live, CMeshO& mesh) {
	mesh.svn = 0;
	for (std::size_t i = 0; i < live.count; ++i) {
		const bool isInside = (*writing.samples)[i].sign < 0;
		isInside ? mesh.vert[live[i]].SetS() : mesh.vert[live[i]].ClearS();
		mesh.svn += isInside ? 1 : 0;
	}
}

int componentsOf(const DistanceWriting& writing) {
	int mask = MeshModel::MM_NONE;
	const auto add = [&](bool wanted, int component) { mask |= wanted ? component : 0; };
	add(writing.atVertices, MeshModel::MM_VERTQUALITY);
	add(writing.atVertices && writing.color, MeshModel::MM_VERTCOLOR);
	add(writing.atFaces, MeshModel::MM_FACEQUALITY);
	add(writing.atFaces && writing.color, MeshModel::MM_FACECOLOR);
	add(writing.normals, MeshModel::MM_VERTNORMAL);
	return mask;
}

}  // namespace

Status readMeasured(MeshModel& layer, Progress& progress, double share, MeasuredLayer& out) {
	try {
		Monitor monitor = progress.nextPhase(share);
		monitor.beginStage("reading layers", 0, 1);
		out.layer = &layer;
		out.arrays.vertexOffsets = OperandOffsets(1);
		out.arrays.faceOffsets = OperandOffsets(1);
		return appendOperand(layer.cm, layer.cm.Tr, kFirst, monitor, out.arrays, out.elements);
	} catch (const std::bad_alloc&) {
		return statusOf(StatusCode::OutOfMemory);
	}
}

Points pointsToMeasure(const MeasuredLayer& read, bool atVertices, bool atFaces) {
	const Points& vertices = read.arrays.points;
	const Triangles& faces = read.arrays.triangles;
	Points points;
	points.reserve((atVertices ? vertices.size() : 0) + (atFaces ? faces.size() : 0));
	if (atVertices) {
		points.insert(points.end(), vertices.begin(), vertices.end());
	}
	constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
	for (std::size_t face = 0; atFaces && face < faces.size(); ++face) {
		Point centre{0, 0, 0};
		for (const VertexId corner : faces[face]) {
			for (std::size_t k = 0; k < 3; ++k) {
				const bool isVertex = corner.value < vertices.size();
				centre[k] += isVertex ? at(vertices, corner)[k] / 3 : kNaN;
			}
		}
		points.push_back(centre);
	}
	return points;
}

Status writeDistances(const DistanceWriting& writing, const MeasuredLayer& read) {
	try {
		CMeshO& mesh = read.layer->cm;
		read.layer->updateDataMask(componentsOf(writing));
		const std::size_t vertexCount = writing.atVertices ? read.elements.vertices.count : 0;
		if (writing.atVertices) {
			write<Vertices>(writing, read.elements.vertices, 0, mesh);
		}
		if (writing.atFaces) {
			write<Faces>(writing, read.elements.faces, vertexCount, mesh);
		}
		if (writing.normals) {
			writeNormals(writing, read.elements.vertices, mesh);
		}
		if (writing.selectInside) {
			selectInside(writing, read.elements.vertices, mesh);
		}
		return {};
	} catch (const std::bad_alloc&) {
		return statusOf(StatusCode::OutOfMemory);
	}
}

}  // namespace index_boolean
