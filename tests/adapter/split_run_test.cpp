// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs behind the filters for splitting and for curves, driven through the host's kind of
// callback; and what all runs report alike.
#include "watched_host.h"

#include <runs/boolean_run.h>
#include <runs/curves_run.h>
#include <runs/split_run.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace watched_host;

Status splitWith(int cancelAt, SplitResult& result) {
	Progress progress = watch(cancelAt);
	return runSplit(overlappingBoxes(), again(overlappingBoxes), SplitRequest{}, progress, result);
}

Status curvesWith(int cancelAt, CurvesResult& result) {
	Progress progress = watch(cancelAt);
	return runCurves(overlappingBoxes(), again(overlappingBoxes), Options{}, progress, result);
}

TEST(SplitRun, theHostSeesPercentsThatNeverFallOnItsOwnThread) {
	SplitResult result;
	ASSERT_TRUE(splitWith(0, result).ok());
	expectGoodManners();
	for (const char* stage : {"loops", "sub surfaces", "sub blocks", "split meshes", "audit"}) {
		EXPECT_EQ(seen.stages.count(stage), 1u) << stage;
	}
}

TEST(SplitRun, aHostThatAnswersFalseCancelsAtEveryCall) {
	expectCancelledAtEveryCall([](int call) {
		SplitResult result;
		return splitWith(call, result);
	});
}

TEST(SplitRun, blocksAreAuditedAndTimed) {
	SplitResult result;
	ASSERT_TRUE(splitWith(0, result).ok());
	ASSERT_EQ(result.blockMeshes.size(), 3u);
	EXPECT_TRUE(result.audit.closed);
	EXPECT_LT(result.audit.volumeLawResidual, 1e-15);
	EXPECT_STREQ(result.report.stageTimes.back().stage, "audit");
	expectTimed(result.report);
}

TEST(SplitRun, withoutBlocksTheVolumesAreAuditedAlone) {
	Progress progress = watch(0);
	SplitRequest request;
	request.subBlocks = false;
	SplitResult result;
	ASSERT_TRUE(
	    runSplit(overlappingBoxes(), again(overlappingBoxes), request, progress, result).ok());
	EXPECT_TRUE(result.blockMeshes.empty());
	EXPECT_EQ(result.split.blocks.all.size(), 3u);
	EXPECT_LT(result.audit.volumeLawResidual, 1e-15);
}

// Three boxes in general position, and two sheets through them.
MeshArrays boxesAndSheets() {
	MeshArrays arrays;
	arrays.vertexOffsets = arrays.faceOffsets = OperandOffsets(5);
	appendBox({0, 0, 0}, {2, 2, 2}, {0}, arrays);
	appendBox({1, 1.125, 1.25}, {2.5, 2.625, 2.75}, {1}, arrays);
	appendBox({-0.5, 0.75, 0.875}, {1.5, 1.75, 3}, {2}, arrays);
	for (const double height : {0.5, 1.375}) {
		const auto first = static_cast<std::uint32_t>(arrays.points.size());
		const OperandId operand{height < 1 ? 3U : 4U};
		arrays.points.push_back({-3, -3, height});
		arrays.points.push_back({9, -3, height});
		arrays.points.push_back({-3, 9, height + 0.125});
		arrays.triangles.push_back({VertexId{first}, VertexId{first + 1}, VertexId{first + 2}});
		arrays.vertexOffsets.setEnd(operand, arrays.points.size());
		arrays.faceOffsets.setEnd(operand, arrays.triangles.size());
	}
	return arrays;
}

SplitRequest requestOfAll() {
	SplitRequest request;
	request.subSurfaces = PerOperand<bool>(5);
	std::fill(request.subSurfaces.begin(), request.subSurfaces.end(), true);
	request.clips = {{{3}, {0}, true}, {{4}, {1}, false}};
	return request;
}

Status splitManyWith(int cancelAt, SplitResult& result) {
	Progress progress = watch(cancelAt);
	return runSplit(boxesAndSheets(), again(boxesAndSheets), requestOfAll(), progress, result);
}

TEST(SplitRun, anyNumberOfOperandsAndClips) {
	SplitResult result;
	ASSERT_TRUE(splitManyWith(0, result).ok());
	expectGoodManners();
	expectTimed(result.report);
	EXPECT_TRUE(result.audit.closed);
	EXPECT_LT(result.audit.volumeLawResidual, 1e-15);
	EXPECT_EQ(result.surfaceMeshes.size(), 5u);
	for (const SplitMesh& mesh : result.surfaceMeshes) {
		EXPECT_FALSE(mesh.triangles.empty());
	}
	ASSERT_EQ(result.clipMeasures.size(), 2u);
	EXPECT_NEAR(result.clipMeasures[0].area, 4 * std::hypot(1, 0.125 / 12), 1e-14);
	const double outside = 72 - 1.5 * 1.5;
	EXPECT_NEAR(result.clipMeasures[1].area, outside * std::hypot(1, 0.125 / 12), 1e-12);
}

TEST(SplitRun, manyOperandsAreCancelledAtEveryCall) {
	expectCancelledAtEveryCall([](int call) {
		SplitResult result;
		return splitManyWith(call, result);
	});
}

// The second box without a face, which clips the first.
MeshArrays boxAndOpenBox() {
	MeshArrays boxes = overlappingBoxes();
	boxes.triangles.pop_back();
	boxes.faceOffsets.setEnd(kSecond, boxes.triangles.size());
	return boxes;
}

TEST(SplitRun, anOpenSolidIsRefusedOnceItHasBeenCutAndCancelledBefore) {
	const auto run = [](int call) {
		SplitResult result;
		Progress progress = watch(call);
		SplitRequest request;
		request.clips = {{kFirst, kSecond, true}};
		return runSplit(boxAndOpenBox(), again(boxAndOpenBox), request, progress, result);
	};
	const Status status = run(0);
	EXPECT_EQ(status.code, StatusCode::NotClosed);
	EXPECT_EQ(status.operand, 1);
	expectGoodMannersSoFar();
	const int calls = seen.calls;
	for (int call = 1; call < calls; ++call) {
		const StatusCode code = run(call).code;
		if (seen.calls >= call) {
			EXPECT_EQ(code, StatusCode::Cancelled) << "call " << call << " of " << calls;
		}
	}
}

TEST(CurvesRun, theHostSeesPercentsThatNeverFallOnItsOwnThread) {
	CurvesResult result;
	ASSERT_TRUE(curvesWith(0, result).ok());
	expectGoodManners();
	for (const char* stage : {"loops", "sub surfaces", "curve lines"}) {
		EXPECT_EQ(seen.stages.count(stage), 1u) << stage;
	}
}

TEST(CurvesRun, stagesAndTheWholeAreTimed) {
	CurvesResult result;
	ASSERT_TRUE(curvesWith(0, result).ok());
	EXPECT_STREQ(result.report.stageTimes.back().stage, "sub_surfaces");
	expectTimed(result.report);
}

TEST(CurvesRun, aHostThatAnswersFalseCancelsAtEveryCall) {
	expectCancelledAtEveryCall([](int call) {
		CurvesResult result;
		return curvesWith(call, result);
	});
}

// The second box inside out, and one face of the first there twice.
MeshArrays boxesWithFindings() {
	MeshArrays boxes = overlappingBoxes();
	for (std::size_t f = boxes.faceOffsets.begin(kSecond); f < boxes.faceOffsets.total(); ++f) {
		std::swap(boxes.triangles[f][1], boxes.triangles[f][2]);
	}
	boxes.triangles.insert(boxes.triangles.begin(), Triangle(boxes.triangles.front()));
	boxes.faceOffsets = {boxes.faceOffsets.end(kFirst) + 1, boxes.faceOffsets.total() + 1};
	return boxes;
}

void expectFindings(const RunReport& report) {
	EXPECT_FALSE(report.insideOut[kFirst]);
	EXPECT_TRUE(report.insideOut[kSecond]);
	EXPECT_EQ(report.duplicates.takenOnce[kFirst], 1u);
	EXPECT_EQ(report.duplicates.takenOnce[kSecond], 0u);
	EXPECT_EQ(report.loopCounts.hardClosed, 1u);
}

TEST(RunReport, allRunsReportTheSameOfTheOperands) {
	BooleanRequest request;
	request.operations = {Operation::Union};
	BooleanResult blocks;
	Progress progress = watch(0);
	ASSERT_TRUE(
	    runBoolean(boxesWithFindings(), again(boxesWithFindings), request, progress, blocks).ok());
	expectFindings(blocks.report);

	SplitResult pieces;
	progress = watch(0);
	ASSERT_TRUE(
	    runSplit(boxesWithFindings(), again(boxesWithFindings), SplitRequest{}, progress, pieces)
	        .ok());
	expectFindings(pieces.report);

	CurvesResult curves;
	progress = watch(0);
	ASSERT_TRUE(
	    runCurves(boxesWithFindings(), again(boxesWithFindings), Options{}, progress, curves).ok());
	expectFindings(curves.report);
}

}  // namespace
}  // namespace index_boolean
