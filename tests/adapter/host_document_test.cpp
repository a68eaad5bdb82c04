// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter in a host's document, in situations that pymeshlab does not let Python make: a
// callback that answers false, layers with deleted elements. Runs on pymeshlab's own libraries.
#include <filter_indexboolean.h>
#include <layers/layers.h>
#include <texts/filter_definitions.h>

#include <vcg_ext/mesh/mesh_arrays_vcg.h>

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

int calls = 0;
int cancelAt = 0;  // the call that answers false; 0: none

bool hostCallback(const int, const char*) {
	++calls;
	return calls != cancelAt;
}

// An octahedron: simple, closed, in general position after a shift.
void addOctahedron(const Point& centre, const char* label, MeshDocument& document) {
	Points points(6, centre);
	for (std::size_t axis = 0; axis < 3; ++axis) {
		points[2 * axis][axis] -= 1;
		points[2 * axis + 1][axis] += 1;
	}
	const IndexTriangles triangles{{1, 3, 5}, {3, 0, 5}, {0, 2, 5}, {2, 1, 5},
	                               {3, 1, 4}, {0, 3, 4}, {2, 0, 4}, {1, 2, 4}};
	MeshModel* layer = document.addNewMesh(QString(), label);
	Monitor monitor;
	const std::vector<std::uint8_t> faux;
	SurfaceWriter<CMeshO> writer(points, triangles, faux, layer->cm);
	ASSERT_TRUE(writer.begin(monitor).ok());
	writer.appendVertices(0, points.size());
	writer.appendFaces(0, triangles.size());
	layer->cm.face[2].SetS();
}

// What a cancelled run must leave as it was.
std::vector<int> stateOf(const MeshDocument& document) {
	std::vector<int> state{static_cast<int>(document.meshNumber()), document.mm()->id()};
	for (const MeshModel& layer : document.meshIterator()) {
		state.push_back(layer.id());
		state.push_back(layer.cm.vn);
		state.push_back(layer.cm.fn);
		state.push_back(layer.isVisible() ? 1 : 0);
		for (const CFaceO& face : layer.cm.face) {
			state.push_back(face.IsS() ? 1 : 0);
		}
	}
	return state;
}

class HostDocument : public testing::Test {
protected:
	void SetUp() override {
		addOctahedron({0, 0, 0}, "A", document);
		addOctahedron({0.3, 0.2, 0.1}, "B", document);
	}

	std::map<std::string, QVariant> run(int cancelAtCall,
	                                    FilterId id = FilterId::GenerateIndexBoolean) {
		calls = 0;
		cancelAt = cancelAtCall;
		const QAction* action = *std::next(filter.actions().begin(), static_cast<int>(id));
		unsigned int mask = 0;
		return filter.applyFilter(action, filter.initParameterList(action, document), document,
		                          mask, &hostCallback);
	}

	// Cancels at each call in turn, until a run comes to its end.
	void expectCancellingChangesNothing(FilterId id) {
		const std::vector<int> before = stateOf(document);
		int cancelled = 0;
		for (int call = 1;; ++call) {
			try {
				run(call, id);
				break;
			} catch (const MLException& refusal) {
				ASSERT_NE(std::string(refusal.what()).find("cancelled"), std::string::npos)
				    << refusal.what();
				ASSERT_EQ(calls, call) << "called again after it had answered false";
				ASSERT_EQ(stateOf(document), before) << "cancelled at call " << call;
				++cancelled;
			}
		}
		EXPECT_GT(cancelled, 5);
	}

	FilterIndexBoolean filter;
	MeshDocument document;
};

TEST_F(HostDocument, cancellingTheBooleanAtAnyCallThrowsAndChangesNothing) {
	expectCancellingChangesNothing(FilterId::GenerateIndexBoolean);
	EXPECT_EQ(document.meshNumber(), 6u);
}

TEST_F(HostDocument, cancellingTheSplitAtAnyCallThrowsAndChangesNothing) {
	expectCancellingChangesNothing(FilterId::GenerateIndexBooleanSplit);
	EXPECT_EQ(document.meshNumber(), 5u);
}

TEST_F(HostDocument, cancellingTheCurvesAtAnyCallThrowsAndChangesNothing) {
	expectCancellingChangesNothing(FilterId::GenerateIndexBooleanCurves);
	EXPECT_EQ(document.meshNumber(), 3u);
}

TEST_F(HostDocument, cancellingAnExpressionAtAnyCallThrowsAndChangesNothing) {
	expectCancellingChangesNothing(FilterId::GenerateIndexBooleanExpression);
	EXPECT_EQ(document.meshNumber(), 3u);
}

TEST_F(HostDocument, cancellingResolveAtAnyCallThrowsAndChangesNothing) {
	expectCancellingChangesNothing(FilterId::GenerateIndexBooleanResolve);
	EXPECT_EQ(document.meshNumber(), 3u);
}

TEST_F(HostDocument, newLayersBearTheMarkOfAResult) {
	run(0);
	for (const MeshModel& layer : document.meshIterator()) {
		EXPECT_EQ(isResultLayer(layer), layer.id() >= 2);
	}
	run(0, FilterId::GenerateIndexBooleanExpression);  // of what is visible
	EXPECT_EQ(document.meshNumber(), 7u);
	EXPECT_EQ(document.mm()->label(), QString("union(visible)"));
}

TEST_F(HostDocument, deletedElementsAreLeftOut) {
	CMeshO& mesh = document.getMesh(0)->cm;
	const auto faces = vcg::tri::Allocator<CMeshO>::AddFaces(mesh, 1);
	faces->V(0) = faces->V(1) = faces->V(2) = &mesh.vert[0];
	const auto vertices = vcg::tri::Allocator<CMeshO>::AddVertices(mesh, 1);
	std::swap(mesh.face[0].V(0), mesh.face[8].V(0));
	std::swap(mesh.face[0].V(1), mesh.face[8].V(1));
	std::swap(mesh.face[0].V(2), mesh.face[8].V(2));
	vcg::tri::Allocator<CMeshO>::DeleteFace(mesh, mesh.face[0]);
	vcg::tri::Allocator<CMeshO>::DeleteVertex(mesh, *vertices);
	const std::map<std::string, QVariant> result = run(0);
	EXPECT_GT(result.at("union_volume").toDouble(), 4.0 / 3);
	EXPECT_LT(result.at("union_volume").toDouble(), 8.0 / 3);
}

TEST_F(HostDocument, selectionFindsFacesBehindDeletedOnes) {
	CMeshO& mesh = document.getMesh(1)->cm;
	vcg::tri::Allocator<CMeshO>::DeleteFace(mesh, mesh.face[2]);
	EXPECT_THROW(run(0), MLException);
	// Face 2 = (0, 2, 5) has an edge in common with each of these.
	const std::set<std::size_t> neighbours{1, 3, 6};
	for (std::size_t i = 0; i < mesh.face.size(); ++i) {
		if (!mesh.face[i].IsD()) {
			EXPECT_EQ(mesh.face[i].IsS(), neighbours.count(i) == 1) << "face " << i;
		}
	}
	EXPECT_TRUE(document.getMesh(0)->cm.face[2].IsS()) << "the other layer's selection is lost";
}

TEST_F(HostDocument, aHostWithoutACallbackGetsAllLayers) {
	const QAction* action = filter.actions().front();
	unsigned int mask = 0;
	filter.applyFilter(action, filter.initParameterList(action, document), document, mask, nullptr);
	EXPECT_EQ(document.meshNumber(), 6u);
	EXPECT_EQ(document.mm()->label(), QString("A union B"));
}

}  // namespace
}  // namespace index_boolean
