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

std::size_t elementCount(const std::vector<Block>& blocks) {
	std::size_t count = 0;
	for (const Block& block : blocks)
		count += block.points.size() + block.triangles.size();
	return count;
}

// Fills the layers, which have no elements yet. Making room is more than half of the work, since
// memory is touched for the first time: of large layers, several are made room in at the same time.
Status fillLayers(const std::vector<Block>& blocks, Monitor& monitor,
                  const std::vector<MeshModel*>& layers) {
	const std::size_t grain = elementCount(blocks) > kElementGrain ? 1 : blocks.size();
	const auto allocate = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i)
			allocateSurface(blocks[i].points.size(), blocks[i].triangles.size(), layers[i]->cm);
	};
	Status status = parallelFor(blocks.size(), grain, 0, monitor, allocate);
	for (std::size_t i = 0; i < blocks.size() && status.ok(); ++i) {
		status = fillSurface(blocks[i].points, blocks[i].triangles, monitor, layers[i]->cm);
		if (status.ok() && !blocks[i].faux.empty()) {
			status = fillFauxEdges(blocks[i].faux, monitor, layers[i]->cm);
			layers[i]->updateDataMask(MeshModel::MM_POLYGONAL);
		}
	}
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
			                       out.faces[k]);
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

Status addLayers(const std::vector<Block>& blocks, const std::vector<QString>& labels,
                 Progress& progress, MeshDocument& document, std::vector<MeshModel*>& added) {
	try {
		Monitor monitor = progress.nextPhase(kWriteShare);
		monitor.beginStage("writing layers", 0, 1);
		NewLayers layers(document);
		for (const QString& label : labels)
			layers.add(label);
		const Status status = fillLayers(blocks, monitor, layers.layers());
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
