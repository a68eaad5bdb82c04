// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// New layers are in the document while they are filled, and leave it if that fails.
#include "layers/layers.h"

#include <algorithm>
#include <deque>
#include <new>

namespace index_boolean {

namespace {

constexpr double kReadShare = 0.05, kWriteShare = 0.15;

// The attribute of a whole mesh that is the mark of a result.
const char* const kResultMark = "index_boolean_result";

// Layers that vanish again, with the old one current, unless they are kept.
class NewLayers {
public:
	explicit NewLayers(MeshDocument& document)
	    : document_(document), current_(document.mm() != nullptr ? document.mm()->id() : -1) {}

	~NewLayers() {
		if (kept_ || layers_.empty()) {
			return;
		}
		for (const MeshModel* layer : layers_) {
			deleteLayer(document_, *layer);
		}
		document_.setCurrentMesh(current_);
	}

	NewLayers(const NewLayers&) = delete;
	NewLayers& operator=(const NewLayers&) = delete;

	void add(const QString& label) {
		layers_.reserve(layers_.size() + 1);
		constexpr bool kMakeCurrent = false;
		layers_.push_back(document_.addNewMesh(QString(), label, kMakeCurrent));
		vcg::tri::Allocator<CMeshO>::AddPerMeshAttribute<bool>(layers_.back()->cm, kResultMark);
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

// The vertices or the faces of one layer.
struct WritingTask {
	LayerWriter* writer;
	Status (LayerWriter::*write)(Monitor&);
	std::size_t bytes;
};

// Fills the layers, which have no elements yet. Each vector is touched by one thread from front to
// back; the largest are begun first, so that none is left over when the others are done.
Status fillLayers(const std::vector<LayerContent>& contents, Monitor& monitor,
                  const std::vector<MeshModel*>& layers) {
	std::deque<LayerWriter> writers;
	std::vector<WritingTask> tasks;
	std::size_t bytes = 0;
	for (std::size_t i = 0; i < contents.size(); ++i) {
		LayerWriter& writer = writers.emplace_back(contents[i], *layers[i]);
		const Status status = writer.begin(monitor);
		if (!status.ok()) {
			return status;
		}
		tasks.push_back({&writer, &LayerWriter::writeVertices, writer.vertexBytes()});
		tasks.push_back({&writer, &LayerWriter::writeFaces, writer.faceBytes()});
		bytes += writer.vertexBytes() + writer.faceBytes();
	}
	std::stable_sort(tasks.begin(), tasks.end(),
	                 [](const WritingTask& a, const WritingTask& b) { return a.bytes > b.bytes; });
	constexpr std::size_t kWorthThreads = std::size_t{1} << 20;
	const std::size_t grain = bytes > kWorthThreads ? 1 : tasks.size();
	std::vector<Status> statuses(tasks.size());
	Status status =
	    parallelFor(tasks.size(), grain, 0, monitor, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t i = begin; i < end; ++i) {
			    statuses[i] = (tasks[i].writer->*tasks[i].write)(monitor);
		    }
	    });
	for (const Status& written : statuses) {
		status = status.ok() ? written : status;
	}
	return status;
}

}  // namespace

Status readLayers(const PerOperand<MeshModel*>& layers, Progress& progress, OperandArrays& out) {
	try {
		Status status;
		Monitor monitor = progress.nextPhase(kReadShare);
		monitor.beginStage("reading layers", 0, 1);
		std::size_t vertices = 0, faces = 0;
		for (const MeshModel* layer : layers) {
			vertices += static_cast<std::size_t>(layer->cm.vn);
			faces += static_cast<std::size_t>(layer->cm.fn);
		}
		out.arrays = noArrays(layers.size());
		out.elements = PerOperand<OperandElements>(layers.size());
		out.arrays.points.reserve(vertices);
		out.arrays.triangles.reserve(faces);
		for (const OperandId operand : layers.operands()) {
			const CMeshO& mesh = layers[operand]->cm;
			if (status.ok()) {
				status = appendOperand(mesh, mesh.Tr, operand, monitor, out.arrays,
				                       out.elements[operand]);
			}
		}
		return status;
	} catch (const std::bad_alloc&) {
		return statusOf(StatusCode::OutOfMemory);
	}
}

bool isResultLayer(const MeshModel& layer) {
	return vcg::tri::HasPerMeshAttribute(layer.cm, kResultMark);
}

void selectFaces(const std::vector<std::uint32_t>& faces, const LiveElements& live,
                 MeshModel& layer) {
	CMeshO& mesh = layer.cm;
	vcg::tri::UpdateSelection<CMeshO>::Clear(mesh);
	for (const std::uint32_t face : faces) {
		mesh.face[live[face]].SetS();
	}
	mesh.svn = 0;
	mesh.sfn = static_cast<int>(vcg::tri::UpdateSelection<CMeshO>::FaceCount(mesh));
}

Status addLayers(const std::vector<LayerContent>& contents, Progress& progress,
                 MeshDocument& document, std::vector<MeshModel*>& added) {
	try {
		Monitor monitor = progress.nextPhase(kWriteShare);
		monitor.beginStage("writing layers", 0, 1);
		NewLayers layers(document);
		for (const LayerContent& content : contents) {
			layers.add(content.label);
		}
		const Status status = fillLayers(contents, monitor, layers.layers());
		if (status.ok()) {
			layers.keep();
			added = layers.layers();
		}
		return status;
	} catch (const std::bad_alloc&) {
		return statusOf(StatusCode::OutOfMemory);
	}
}

}  // namespace index_boolean
