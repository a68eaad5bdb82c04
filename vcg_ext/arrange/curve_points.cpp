// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything here is sorting: names to number the points, faces to list those that are touched.
#include "vcg_ext/arrange/curve_points.h"

#include "vcg_ext/arrange/numbered_sort.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <functional>

namespace index_boolean {

namespace {

bool isNewPoint(const PointName& name) {
	return name.kind == PointKind::EdgeEdge || name.kind == PointKind::EdgeFace;
}

// A name and its place among the contacts' names.
struct NamedSlot {
	PointName name;
	std::uint32_t slot;
};

// A list of contacts may be longer than 32 bits number.
Status checkContacts(const Contacts& contacts, const Options& options) {
	return checkCounts(contacts.names.size(), contacts.pairs.size(), options.mostElements);
}

// Names that stand for input vertices are those vertices; the new points are left to be numbered.
std::vector<NamedSlot> takeInputVertices(const Contacts& contacts, Curve& curve,
                                         std::vector<VertexId>& vertexOfName) {
	std::vector<NamedSlot> newPoints;
	vertexOfName.resize(contacts.names.size());
	for (std::uint32_t i = 0; i < contacts.names.size(); ++i) {
		const PointName& name = contacts.names[i];
		if (isNewPoint(name)) {
			newPoints.push_back({name, i});
		} else {
			vertexOfName[i] = {name.ids[0]};
			curve.onOther[name.ids[0]] = 1;
		}
	}
	return newPoints;
}

// New points are numbered in the order of their names; the others are input vertices.
Status numberPoints(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor,
                    std::vector<VertexId>& vertexOfName) {
	Curve& curve = arrangement.curve;
	const std::size_t vertexCount = arrangement.mesh.points.size();
	curve.onOther = arrangement.mesh.quietVertices;
	curve.onOther.resize(vertexCount, 0);
	for (const VertexId v : arrangement.nonManifold) {  // surfaces of a soup may meet there
		at(curve.onOther, v) |= arrangement.isSoup ? 1 : 0;
	}
	std::vector<NamedSlot> slots = takeInputVertices(contacts, curve, vertexOfName);
	const auto keyOf = [vertexCount](const NamedSlot& slot) {
		const bool isOnFace = slot.name.kind == PointKind::EdgeFace;
		return (isOnFace ? vertexCount : 0) + slot.name.ids[0];
	};
	const auto before = [](const NamedSlot& a, const NamedSlot& b) { return a.name < b.name; };
	const Status status =
	    sortNumbered(slots, 2 * vertexCount, keyOf, before, arrangement.options, monitor);
	if (!status.ok()) {
		return status;
	}
	for (const auto& [name, slot] : slots) {
		if (curve.names.empty() || !(curve.names.back() == name)) {
			curve.names.push_back(name);
		}
		vertexOfName[slot] = arrangement.vertexOf(makeId<PointTag>(curve.names.size() - 1));
	}
	return checkCounts(vertexCount + curve.pointCount(), 0, arrangement.options.mostElements);
}

Status collectTouchedFaces(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor) {
	std::vector<FaceId>& faces = arrangement.curve.touchedFaces;
	faces.reserve(2 * contacts.pairs.size());
	for (const NamedContact& contact : contacts.pairs) {
		faces.push_back(contact.a);
		faces.push_back(contact.b);
	}
	const auto keyOf = [](FaceId f) { return f.value; };
	const Status status = sortNumbered(faces, arrangement.mesh.triangles.size(), keyOf,
	                                   std::less<FaceId>(), arrangement.options, monitor);
	faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
	return status;
}

}  // namespace

Status roundCurvePoints(Arrangement& arrangement, std::size_t first, Monitor& monitor) {
	Curve& curve = arrangement.curve;
	curve.rounded.resizeForOverwrite(curve.pointCount());
	const auto roundSome = [&](std::size_t begin, std::size_t end) {
		for (std::size_t p = first + begin; p < first + end; ++p) {
			ExactPoint point = exactPoint(arrangement, arrangement.vertexOf(makeId<PointTag>(p)));
			roundPoint(point);
			curve.rounded[p] = point.rounded;
		}
	};
	return parallelFor(curve.pointCount() - first, 128, arrangement.options.threads, monitor,
	                   roundSome);
}

Status numberCurvePoints(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor,
                         std::vector<VertexId>& vertexOfName) {
	return inOrder([&] { return checkContacts(contacts, arrangement.options); },
	               [&] { return numberPoints(arrangement, contacts, monitor, vertexOfName); },
	               [&] { return roundCurvePoints(arrangement, 0, monitor); },
	               [&] { return collectTouchedFaces(arrangement, contacts, monitor); });
}

}  // namespace index_boolean
