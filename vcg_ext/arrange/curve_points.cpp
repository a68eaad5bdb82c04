// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything here is sorting: names to number the points, faces to list those that are touched.
#include "vcg_ext/arrange/curve_points.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <functional>

namespace index_boolean {

namespace {

bool isNewPoint(const PointName& name) {
	return name.kind == PointKind::EdgeEdge || name.kind == PointKind::EdgeFace;
}

struct NamedSlot {
	PointName name;
	std::uint32_t slot;  // in the contacts
};

class PointNumbering {
public:
	PointNumbering(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor,
	               std::vector<VertexId>& vertexOfName)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), curve_(arrangement.curve),
	      contacts_(contacts), monitor_(monitor), vertexOfName_(vertexOfName) {}

	Status numberPoints();
	Status roundPoints();
	Status collectTouchedFaces();

private:
	// As std::sort, for items with few equal keys in [0, keyCount).
	template <class Item, class KeyOf, class Before>
	Status sort(std::vector<Item>& items, std::size_t keyCount, KeyOf&& keyOf,
	            Before&& before) const {
		return bucketSort(items, keyCount, keyOf, before, arrangement_.options.threads, monitor_);
	}

	Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Curve& curve_;
	const Contacts& contacts_;
	Monitor& monitor_;
	std::vector<VertexId>& vertexOfName_;
};

// New points are numbered in the order of their names; the others are input vertices.
Status PointNumbering::numberPoints() {
	curve_.onOther = mesh_.quietVertices;
	curve_.onOther.resize(mesh_.points.size(), 0);
	vertexOfName_.resize(contacts_.names.size());
	std::vector<NamedSlot> slots;
	for (std::uint32_t i = 0; i < contacts_.names.size(); ++i) {
		const PointName& name = contacts_.names[i];
		if (isNewPoint(name)) {
			slots.push_back({name, i});
		} else {
			vertexOfName_[i] = {name.ids[0]};
			curve_.onOther[name.ids[0]] = 1;
		}
	}
	const std::size_t n = mesh_.points.size();
	const Status status = sort(
	    slots, 2 * n,
	    [n](const NamedSlot& slot) {
		    return (slot.name.kind == PointKind::EdgeFace ? n : 0) + slot.name.ids[0];
	    },
	    [](const NamedSlot& a, const NamedSlot& b) { return a.name < b.name; });
	for (const auto& [name, slot] : slots) {
		if (curve_.names.empty() || !(curve_.names.back() == name)) {
			curve_.names.push_back(name);
		}
		vertexOfName_[slot] = arrangement_.vertexOf(makeId<PointTag>(curve_.names.size() - 1));
	}
	return status;
}

Status PointNumbering::roundPoints() {
	curve_.rounded.resize(curve_.pointCount());
	return parallelFor(curve_.pointCount(), 128, arrangement_.options.threads, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t p = begin; p < end; ++p) {
			                   ExactPoint point = exactPoint(
			                       arrangement_, arrangement_.vertexOf(makeId<PointTag>(p)));
			                   roundPoint(point);
			                   curve_.rounded[p] = point.rounded;
		                   }
	                   });
}

Status PointNumbering::collectTouchedFaces() {
	std::vector<FaceId>& faces = curve_.touchedFaces;
	faces.reserve(2 * contacts_.pairs.size());
	for (const NamedContact& contact : contacts_.pairs) {
		faces.push_back(contact.a);
		faces.push_back(contact.b);
	}
	const Status status = sort(
	    faces, mesh_.triangles.size(), [](FaceId f) { return f.value; }, std::less<FaceId>());
	faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
	return status;
}

}  // namespace

Status numberCurvePoints(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor,
                         std::vector<VertexId>& vertexOfName) {
	PointNumbering numbering(arrangement, contacts, monitor, vertexOfName);
	Status status = numbering.numberPoints();
	if (status.ok()) {
		status = numbering.roundPoints();
	}
	return status.ok() ? numbering.collectTouchedFaces() : status;
}

}  // namespace index_boolean
