// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter in a host's document, with a callback that answers false, which no host of today does.
// Runs on pymeshlab's own libraries.
#include <filter_indexboolean.h>

#include <vcg_ext/mesh_arrays_vcg.h>

#include <gtest/gtest.h>

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
	std::vector<Point> points(6, centre);
	for (std::size_t axis = 0; axis < 3; ++axis) {
		points[2 * axis][axis] -= 1;
		points[2 * axis + 1][axis] += 1;
	}
	const std::vector<IndexedTriangle> triangles{{1, 3, 5}, {3, 0, 5}, {0, 2, 5}, {2, 1, 5},
	                                             {3, 1, 4}, {0, 3, 4}, {2, 0, 4}, {1, 2, 4}};
	MeshModel* layer = document.addNewMesh(QString(), label);
	Monitor monitor;
	allocateSurface(points.size(), triangles.size(), layer->cm);
	ASSERT_TRUE(fillSurface(points, triangles, monitor, layer->cm).ok());
	layer->cm.face[2].SetS();
}

// What a cancelled run must leave as it was.
std::vector<int> stateOf(const MeshDocument& document) {
	std::vector<int> state{static_cast<int>(document.meshNumber()), document.mm()->id()};
	for (const MeshModel& layer : document.meshIterator()) {
		state.push_back(layer.id());
		state.push_back(layer.cm.vn);
		state.push_back(layer.cm.fn);
		for (const CFaceO& face : layer.cm.face)
			state.push_back(face.IsS() ? 1 : 0);
	}
	return state;
}

class HostCancel : public testing::Test {
protected:
	void SetUp() override {
		addOctahedron({0, 0, 0}, "A", document);
		addOctahedron({0.3, 0.2, 0.1}, "B", document);
	}

	std::map<std::string, QVariant> run(int cancelAtCall) {
		calls = 0;
		cancelAt = cancelAtCall;
		const QAction* action = filter.actions().front();
		unsigned int mask = 0;
		return filter.applyFilter(action, filter.initParameterList(action, document), document,
		                          mask, &hostCallback);
	}

	FilterIndexBoolean filter;
	MeshDocument document;
};

TEST_F(HostCancel, cancellingAtAnyCallThrowsAndChangesNothing) {
	const std::vector<int> before = stateOf(document);
	int cancelled = 0;
	for (int call = 1;; ++call) {
		try {
			run(call);
			break;
		} catch (const MLException& refusal) {
			ASSERT_NE(std::string(refusal.what()).find("cancelled"), std::string::npos)
			    << refusal.what();
			ASSERT_EQ(stateOf(document), before) << "cancelled at call " << call;
			++cancelled;
		}
	}
	EXPECT_GT(cancelled, 5);
	EXPECT_EQ(document.meshNumber(), 6u);
}

TEST_F(HostCancel, aHostWithoutACallbackGetsAllLayers) {
	const QAction* action = filter.actions().front();
	unsigned int mask = 0;
	filter.applyFilter(action, filter.initParameterList(action, document), document, mask, nullptr);
	EXPECT_EQ(document.meshNumber(), 6u);
	EXPECT_EQ(document.mm()->label(), QString("A union B"));
}

}  // namespace
}  // namespace index_boolean
