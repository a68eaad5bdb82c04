// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes are built in place inside their layers, since a copy costs more than the whole Boolean.
#include "layers.h"

#include <new>

namespace index_boolean {

namespace {

constexpr double kReadShare = 0.05, kWriteShare = 0.15;

// Layers that vanish again, with the old one current, unless they are kept.
class NewLayers {
public:
	explicit NewLayers(MeshDocument& document)
	    : document_(document), current_(document.mm() != nullptr ? document.mm()->id() : -1) {}

	~NewLayers() {
		if (kept_ || layers_.empty())
			return;
		for (const MeshModel* layer : layers_)
			deleteLayer(document_, *layer);
		document_.setCurrentMesh(current_);
	}

	NewLayers(const NewLayers&) = delete;
	NewLayers& operator=(const NewLayers&) = delete;

	void add(const QString& label) {
		layers_.reserve(layers_.size() + 1);
		constexpr bool kMakeCurrent = false;
		layers_.push_back(document_.addNewMesh(QString(), label, kMakeCurrent));
	}

	const std::vector<MeshModel*>& layers() const { return layers_; }

	void keep() {
		kept_ = true;
		document_.setCurrentMesh(layers_.front()->id());
	}

private:
	MeshDocument& document_;
	int current_;
	bool kept_ = false;
	std::vector<MeshModel*> layers_;
};

const Points& pointsOf(const LayerContent& content) {
	return content.surface != nullptr ? content.surface->points : content.curves->points;
}

std::size_t faceCountOf(const LayerContent& content) {
	return content.surface != nullptr ? content.surface->triangles.size() : 0;
}

std::size_t elementCount(const std::vector<LayerContent>& contents) {
	std::size_t count = 0;
	for (const LayerContent& content : contents)
		count += pointsOf(content).size() + faceCountOf(content);
	return count;
}

void writeVertexAttribute(const ScalarAttribute& attribute, CMeshO& mesh) {
	auto handle = vcg::tri::Allocator<CMeshO>::AddPerVertexAttribute<Scalarm>(mesh, attribute.name);
	for (std::size_t i = 0; i < attribute.values.size(); ++i)
		handle[i] = static_cast<Scalarm>(attribute.values[i]);
}

void writeFaceAttribute(const ScalarAttribute& attribute, CMeshO& mesh) {
	auto handle = vcg::tri::Allocator<CMeshO>::AddPerFaceAttribute<Scalarm>(mesh, attribute.name);
	for (std::size_t i = 0; i < attribute.values.size(); ++i)
		handle[i] = static_cast<Scalarm>(attribute.values[i]);
}

void writeFaceColours(const std::vector<vcg::Color4b>& colours, MeshModel& layer) {
	if (colours.empty())
		return;
	layer.updateDataMask(MeshModel::MM_FACECOLOR);
	for (std::size_t i = 0; i < colours.size(); ++i)
		layer.cm.face[i].C() = colours[i];
}

Status fillWithSurface(const LayerContent& content, Monitor& monitor, MeshModel& layer) {
	const SourcedMesh& surface = *content.surface;
	Status status = fillSurface(surface.points, surface.triangles, monitor, layer.cm);
	if (status.ok() && !surface.faux.empty()) {
		status = fillFauxEdges(surface.faux, monitor, layer.cm);
		layer.updateDataMask(MeshModel::MM_POLYGONAL);
	}
	if (!status.ok())
		return status;
	writeFaceColours(content.faceColours, layer);
	return content.writeAttributes
	           ? content.writeAttributes(monitor, layer)
	           : fillVertexNormals(surface.points, surface.triangles, monitor, layer.cm);
}

// Fills a layer that has room for the content's vertices and faces.
Status fillLayer(const LayerContent& content, Monitor& monitor, MeshModel& layer) {
	Status status;
	if (content.surface != nullptr) {
		status = fillWithSurface(content, monitor, layer);
	} else {
		status = fillSurface(content.curves->points, {}, monitor, layer.cm);
		addEdges(content.curves->edges, layer.cm);
	}
	for (const ScalarAttribute& attribute : content.vertexAttributes)
		writeVertexAttribute(attribute, layer.cm);
	for (const ScalarAttribute& attribute : content.faceAttributes)
		writeFaceAttribute(attribute, layer.cm);
	return status;
}

// Fills the layers, which have no elements yet. Making room is more than half of the work, since
// memory is touched for the first time: of large layers, several are made room in at the same time.
Status fillLayers(const std::vector<LayerContent>& contents, Monitor& monitor,
                  const std::vector<MeshModel*>& layers) {
	const std::size_t grain = elementCount(contents) > kElementGrain ? 1 : contents.size();
	const auto allocate = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			allocateSurface(pointsOf(contents[i]).size(), faceCountOf(contents[i]), layers[i]->cm);
		}
	};
	Status status = parallelFor(contents.size(), grain, 0, monitor, allocate);
	for (std::size_t i = 0; i < contents.size() && status.ok(); ++i)
		status = fillLayer(contents[i], monitor, *layers[i]);
	return status;
}

}  // namespace

Status readLayers(const std::array<MeshModel*, 2>& layers, Progress& progress, OperandArrays& out) {
	try {
		Status status;
		Monitor monitor = progress.nextPhase(kReadShare);
		monitor.beginStage("reading layers", 0, 1);
		for (std::size_t k = 0; k < layers.size() && status.ok(); ++k) {
			const CMeshO& mesh = layers[k]->cm;
			status = appendOperand(mesh, mesh.Tr, static_cast<int>(k), monitor, out.arrays,
			                       out.elements[k]);
		}
		return status;
	} catch (const std::bad_alloc&) {
		Status status;
		status.code = StatusCode::OutOfMemory;
		return status;
	}
}

void selectFaces(const std::vector<std::uint32_t>& faces, const LiveElements& live,
                 MeshModel& layer) {
	CMeshO& mesh = layer.cm;
	vcg::tri::UpdateSelection<CMeshO>::Clear(mesh);
	for (const std::uint32_t face : faces)
		mesh.face[live[face]].SetS();
	mesh.svn = 0;
	mesh.sfn = static_cast<int>(vcg::tri::UpdateSelection<CMeshO>::FaceCount(mesh));
}

Status addLayers(const std::vector<LayerContent>& contents, Progress& progress,
                 MeshDocument& document, std::vector<MeshModel*>& added) {
	try {
		Monitor monitor = progress.nextPhase(kWriteShare);
		monitor.beginStage("writing layers", 0, 1);
		NewLayers layers(document);
		for (const LayerContent& content : contents)
			layers.add(content.label);
		const Status status = fillLayers(contents, monitor, layers.layers());
		if (status.ok()) {
			layers.keep();
			added = layers.layers();
		}
		return status;
	} catch (const std::bad_alloc&) {
		Status status;
		status.code = StatusCode::OutOfMemory;
		return status;
	}
}

}  // namespace index_boolean
