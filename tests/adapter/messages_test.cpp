// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What users read: sentences, labels, parameters.
#include <layers/split_layers.h>
#include <texts/messages.h>

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

const LayerNames kLayers{{"bunny.ply", 3}, {"50% cube", 7}};

LayerNames named(const char* first, const char* second) { return {{first, 0}, {second, 1}}; }

bool contains(const std::string& text, const std::string& part) {
	return text.find(part) != std::string::npos;
}

std::string refusal(StatusCode code, int operand) {
	Status status;
	status.code = code;
	status.operand = operand;
	status.count = 12345;
	return refusalMessage(status, kLayers);
}

TEST(Messages, eachRefusalIsASentenceOfItsOwnWithARemedy) {
	std::set<std::string> messages;
	for (int code = 1; code < kStatusCodeCount; ++code) {
		const std::string message = refusal(static_cast<StatusCode>(code), 0);
		const std::size_t firstSentence = message.find(". ");
		ASSERT_NE(firstSentence, std::string::npos) << message;
		EXPECT_GT(message.size(), firstSentence + 10) << "no remedy: " << message;
		EXPECT_EQ(message.back(), '.') << message;
		messages.insert(message);
	}
	EXPECT_EQ(messages.size(), static_cast<std::size_t>(kStatusCodeCount - 1));
}

TEST(Messages, aDefectNamesItsLayerByLabelAndId) {
	for (const StatusCode code :
	     {StatusCode::EmptyOperand, StatusCode::NotFinite, StatusCode::IndexOutOfRange,
	      StatusCode::NotClosed, StatusCode::NotOriented, StatusCode::NoVolume,
	      StatusCode::NestedComponents, StatusCode::SelfIntersecting}) {
		const std::string first = refusal(code, 0), second = refusal(code, 1);
		EXPECT_TRUE(contains(first, "Layer \"bunny.ply\" (id 3) ")) << first;
		EXPECT_FALSE(contains(first, "cube")) << first;
		EXPECT_TRUE(contains(second, "Layer \"50% cube\" (id 7) ")) << second;
	}
}

TEST(Messages, countedDefectsGiveTheirCount) {
	for (const StatusCode code :
	     {StatusCode::NotFinite, StatusCode::IndexOutOfRange, StatusCode::NotClosed,
	      StatusCode::NotOriented, StatusCode::NestedComponents, StatusCode::SelfIntersecting}) {
		EXPECT_TRUE(contains(refusal(code, 0), "12345")) << refusal(code, 0);
	}
}

TEST(Messages, aDefectOfBothLayersNamesBoth) {
	const std::string message = refusal(StatusCode::TooLarge, -1);
	EXPECT_TRUE(contains(message, "\"bunny.ply\" (id 3) and \"50% cube\" (id 7)")) << message;
}

TEST(Messages, anOpenLayerIsSentToTheFilterForOpenSurfaces) {
	EXPECT_TRUE(contains(refusal(StatusCode::NotClosed, 0), "generate_index_boolean_split"));
}

TEST(Messages, aCrackedLayerIsToldTheDistanceAndNothingElse) {
	Status status = statusOf(StatusCode::NotClosed);
	status.closingDistance = 2e-7;
	const std::string message = refusalMessage(status, kLayers);
	EXPECT_TRUE(contains(message, "with weld_distance = 2e-07 the layer is closed.")) << message;
	EXPECT_FALSE(contains(message, "Close Holes")) << message;
}

TEST(Messages, aDoubleSidedLayerIsToldWhatItIs) {
	Status status = statusOf(StatusCode::EmptyOperand);
	EXPECT_FALSE(contains(refusalMessage(status, kLayers), "double-sided"));
	status.count = 6;
	const std::string message = refusalMessage(status, kLayers);
	EXPECT_TRUE(contains(message, "6 pairs of opposite faces cancel. It is double-sided"))
	    << message;
}

TEST(Messages, surfacesHaveNoHolesToCloseNorSolidsInside) {
	EXPECT_EQ(takenFor(FilterId::GenerateIndexBoolean), TakenFor::Solid);
	for (const FilterId filter :
	     {FilterId::GenerateIndexBooleanSplit, FilterId::GenerateIndexBooleanCurves}) {
		for (const StatusCode code : {StatusCode::EmptyOperand, StatusCode::NotFinite,
		                              StatusCode::SelfIntersecting, StatusCode::WeldTooWide}) {
			const std::string message = refusalMessage(statusOf(code), kLayers, takenFor(filter));
			EXPECT_FALSE(contains(message, "Close Holes")) << message;
			EXPECT_FALSE(contains(message, "winding rule")) << message;
		}
	}
}

TEST(Messages, aReferenceMayBeOpenAndIsCutByNothing) {
	for (const FilterId filter :
	     {FilterId::ComputeIndexBooleanDistance, FilterId::ComputeIndexBooleanImplicit}) {
		const TakenFor kind = takenFor(filter);
		const auto messageOf = [&](StatusCode code) {
			return refusalMessage(statusOf(code), kLayers, kind);
		};
		EXPECT_FALSE(contains(messageOf(StatusCode::NotFinite), "Close Holes"));
		EXPECT_FALSE(contains(messageOf(StatusCode::SelfIntersecting), "cut"));
		EXPECT_TRUE(contains(messageOf(StatusCode::NoVolume), "self_intersections = trust"));
	}
}

TEST(Messages, whatClipsIsSentToWeldingIfThatClosesIt) {
	Status status = statusOf(StatusCode::NotClosed);
	EXPECT_TRUE(contains(openSolidMessage(status, kLayers), "Close Holes"));
	status.closingDistance = 1e-6;
	const std::string message = openSolidMessage(status, kLayers);
	EXPECT_TRUE(contains(message, "with weld_distance = 1e-06 the layer is closed")) << message;
	EXPECT_FALSE(contains(message, "Close Holes")) << message;
}

TEST(Messages, whatWasWeldedAndReadAsFansIsTold) {
	RunReport report;
	report.vertexWeld = {1, 0.5};
	report.selfIntersecting[kSecond] = 4;
	report.foldedFans[kSecond] = 2;
	const std::vector<std::string> messages = operandMessages(report, kLayers);
	ASSERT_EQ(messages.size(), 3u);
	EXPECT_EQ(messages[0], "1 vertex was moved to the place of a neighbour, by 0.5 at most.");
	EXPECT_TRUE(contains(messages[2], "\"50% cube\" (id 7) has 2 polygons with triangles"));
}

TEST(Messages, anEmptyBlockSaysWhyForEachOperation) {
	std::set<std::string> messages;
	for (const BlockDefinition& block : kBlockDefinitions) {
		const std::string message = emptyBlockMessage(block.operation, kLayers);
		EXPECT_TRUE(contains(message, " is empty: ")) << message;
		messages.insert(message);
	}
	EXPECT_EQ(messages.size(), kBlockDefinitions.size());
	EXPECT_TRUE(contains(emptyBlockMessage(Operation::SecondMinusFirst, kLayers),
	                     "\"50% cube\" (id 7) lies within \"bunny.ply\" (id 3)"));
}

TEST(Messages, duplicateFacesAreCountedByWhatBecameOfThem) {
	EXPECT_EQ(duplicatesMessage(kLayers[kFirst], 12, 0),
	          "Layer \"bunny.ply\" (id 3) has faces on the same three vertices: 12 duplicate faces "
	          "were taken once.");
	EXPECT_EQ(duplicatesMessage(kLayers[kFirst], 0, 1),
	          "Layer \"bunny.ply\" (id 3) has faces on the same three vertices: 1 opposite pair "
	          "cancelled.");
	EXPECT_EQ(
	    duplicatesMessage(kLayers[kSecond], 1, 2),
	    "Layer \"50% cube\" (id 7) has faces on the same three vertices: 1 duplicate face was "
	    "taken once, 2 opposite pairs cancelled.");
}

TEST(Messages, whatTheCoreHasChangedIsToldOfEachLayer) {
	RunReport report;
	EXPECT_TRUE(operandMessages(report, kLayers).empty());
	report.insideOut[kSecond] = true;
	report.duplicates.takenOnce[kFirst] = 12;
	report.duplicates.cancelledPairs[kSecond] = 1;
	const std::vector<std::string> expected{duplicatesMessage(kLayers[kFirst], 12, 0),
	                                        turnedMessage(kLayers[kSecond]),
	                                        duplicatesMessage(kLayers[kSecond], 0, 1)};
	EXPECT_EQ(operandMessages(report, kLayers), expected);
}

TEST(Messages, namesAreListed) {
	EXPECT_EQ(
	    lackingAttributesMessage(kLayers[kFirst], {"radii"}),
	    "Layer \"bunny.ply\" (id 3) has no radii: what comes of it has MeshLab's default there.");
	EXPECT_TRUE(
	    contains(lackingAttributesMessage(kLayers[kFirst], {"radii", "colours", "qualities"}),
	             "has no radii, colours and qualities: "));
	EXPECT_EQ(noPiecesRequestedMessage(false),
	          "No piece is asked for. Set at least one of these to true: sub_surfaces_first, "
	          "sub_surfaces_second, sub_blocks, first_inside_second, first_outside_second, "
	          "second_inside_first, second_outside_first.");
	EXPECT_TRUE(contains(noPiecesRequestedMessage(true), "true: sub_surfaces, sub_blocks, first_"));
	EXPECT_TRUE(contains(nothingRequestedMessage(), "true: union, intersection, "));
}

TEST(Messages, aSelfIntersectionIsSentToTheParameterThatResolvesIt) {
	const std::string message = refusal(StatusCode::SelfIntersecting, 1);
	EXPECT_TRUE(contains(message, "intersects itself: 12345 faces are concerned")) << message;
	EXPECT_TRUE(contains(message, "self_intersections = resolve")) << message;
}

TEST(Messages, theLogTellsFacesComponentsVolumeAndArea) {
	Block block;
	block.operation = Operation::FirstMinusSecond;
	block.triangles.resize(12);
	BlockMeasure measure;
	measure.volume = 1234567.5;
	measure.area = 0.125;
	measure.components = 1;
	EXPECT_EQ(blockMessage(blockLabel(block.operation, kLayers), block, measure),
	          "\"bunny minus 50% cube\": 12 faces, 1 component, volume 1.23457e+06, area 0.125.");
}

TEST(Messages, curvesAreCountedByKind) {
	CurveLines curves;
	curves.lines.push_back({LoopKind::Open, 0, 2, false, 1.5});
	curves.lines.push_back({LoopKind::SoftClosed, 2, 2, false, 2});
	LoopCounts counts;
	counts.open = counts.softClosed = 1;
	EXPECT_EQ(curvesMessage(curves, counts, kLayers),
	          "\"bunny curves 50% cube\": 2 loops (1 open, 0 hard-closed, 1 soft-closed), length "
	          "3.5.");
	EXPECT_TRUE(contains(curvesMessage({}, {}, kLayers), "do not meet in a line"));
}

TEST(Messages, aSplitTellsPiecesAndWhatTheyPart) {
	SplitResult result;
	SplitNames names;
	names.layers = kLayers;
	EXPECT_TRUE(contains(subBlocksMessage(result, names), "bound no part of space"));
	SubSurface surface{};
	surface.area = 2;
	surface.closedCycles = 1;
	surface.oneSided = true;
	result.split.surfaces.all.push_back(surface);
	surface.closedCycles = 2;
	surface.oneSided = false;
	result.split.surfaces.all.push_back(surface);
	result.split.surfaces.ofOperand[kSecond] = {SubSurfaceId{0}, SubSurfaceId{1}};
	result.split.blocks.separates = {0, 1};
	EXPECT_EQ(subSurfacesMessage(result, kSecond, names),
	          "\"50% cube cut by bunny\": 2 sub-surfaces (1 private, 1 public; 1 separating, 1 "
	          "one-sided), area 4.");
	EXPECT_TRUE(contains(tooManyLayersMessage(70, 64), "70 pieces, more than max_layers (64)"));
}

TEST(Messages, aClipTellsItsFacesOrThatItIsEmpty) {
	SplitNames names;
	names.layers = kLayers;
	const Clip clip{kSecond, kFirst, false};
	SplitMesh mesh;
	EXPECT_EQ(clipMessage(clip, mesh, {}, names),
	          "\"50% cube outside bunny\" is empty: nothing of \"50% cube\" (id 7) lies outside "
	          "\"bunny.ply\" (id 3).");
	mesh.triangles.resize(2);
	BlockMeasure measure;
	measure.components = 1;
	measure.area = 1.5;
	EXPECT_EQ(clipMessage(clip, mesh, measure, names),
	          "\"50% cube outside bunny\": 2 faces, 1 component, area 1.5.");
}

TEST(Messages, anOpenLayerThatIsToClipIsToldHowToBeClosed) {
	Status status = statusOf(StatusCode::NotClosed);
	status.operand = 1;
	status.count = 3;
	const std::string message = openSolidMessage(status, kLayers);
	EXPECT_TRUE(contains(message, "Layer \"50% cube\" (id 7) is not closed: 3 edges")) << message;
	EXPECT_TRUE(contains(message, "meshing_close_holes"));
	EXPECT_FALSE(contains(message, "generate_index_boolean_split"));
}

TEST(FilterDefinitions, piecesAreParametersOfTheSplit) {
	SplitNames names;
	names.layers = named("A.ply", "B");
	std::vector<std::string> keys;
	for (const OperandId operand : {kFirst, kSecond}) {
		keys.push_back(names.keyOf(Pieces::subSurfacesOf(operand)));
	}
	keys.push_back(names.keyOf(Pieces::subBlocks()));
	for (const Clip& clip : {Clip{kFirst, kSecond, true}, Clip{kFirst, kSecond, false},
	                         Clip{kSecond, kFirst, true}, Clip{kSecond, kFirst, false}}) {
		keys.push_back(names.keyOf(Pieces::of(clip)));
		EXPECT_EQ(keys.back(), kClipDefinitions[keys.size() - 4].name);
	}
	for (const std::string& key : keys) {
		EXPECT_EQ(parameterDefinition(FilterId::GenerateIndexBooleanSplit, key).name, key);
	}
	EXPECT_EQ(names.labelOf(Pieces::subSurfacesOf(kFirst)), "A cut by B");
	EXPECT_EQ(names.labelOf(Pieces::subSurfacesOf(kSecond)), "B cut by A");
	EXPECT_EQ(names.labelOf(Pieces::subBlocks()), "A blocks B");
	EXPECT_EQ(names.labelOf(Pieces::of({kSecond, kFirst, true})), "B inside A");
	EXPECT_EQ(curvesLabel(named("A", "B")), "A curves B");
}

TEST(FilterDefinitions, piecesOfAListHaveTheOperandsNumbers) {
	SplitNames names;
	names.layers = LayerNames{{"A", 7}, {"B.ply", 8}, {"C", 9}};
	names.isList = true;
	names.first = {2};
	names.second = {0};
	EXPECT_EQ(names.keyOf(Pieces::subSurfacesOf({2})), "sub_surfaces_2");
	EXPECT_EQ(names.labelOf(Pieces::subSurfacesOf({1})), "B cut by 2 others");
	EXPECT_EQ(names.labelOf(Pieces::subBlocks()), "blocks of A and 2 others");
	EXPECT_EQ(names.keyOf(Pieces::of({{2}, {0}, false})), "first_outside_second");
	EXPECT_EQ(names.labelOf(Pieces::of({{0}, {2}, true})), "A inside C");
	names.layers = LayerNames{{"A", 7}};
	EXPECT_EQ(names.labelOf(Pieces::subSurfacesOf({0})), "A cut by itself");
	EXPECT_EQ(names.labelOf(Pieces::subBlocks()), "A blocks");
}

TEST(SplitLayers, neighbouringIdsHaveColoursThatDiffer) {
	for (std::size_t id = 0; id < 100; ++id) {
		const Colour a = colourOf(id), b = colourOf(id + 1);
		int difference = 0;
		for (std::size_t channel = 0; channel < 3; ++channel) {
			difference += std::abs(static_cast<int>(a[channel]) - static_cast<int>(b[channel]));
		}
		EXPECT_GT(difference, 100) << "id " << id;
	}
}

TEST(FilterDefinitions, blocksAreParametersInTheOrderOfTheLayers) {
	const auto& parameters = filterDefinition(FilterId::GenerateIndexBoolean).parameters;
	for (std::size_t i = 0; i < kBlockDefinitions.size(); ++i) {
		EXPECT_EQ(kBlockDefinitions[i].operation, static_cast<Operation>(i));
		EXPECT_STREQ(parameters[i + 2].name, operationName(kBlockDefinitions[i].operation));
		EXPECT_EQ(parameters[i + 2].kind, ParameterKind::Bool);
	}
}

TEST(FilterDefinitions, everyDefaultIsAccepted) {
	for (const FilterDefinition& filter : filterDefinitions()) {
		EXPECT_EQ(&filterDefinition(filter.id), &filter);
		for (const ParameterDefinition& parameter : filter.parameters) {
			EXPECT_EQ(&parameterDefinition(filter.id, parameter.name), &parameter);
			if (parameter.kind != ParameterKind::Layer) {
				EXPECT_GE(parameter.defaultValue, parameter.minimum) << parameter.name;
				EXPECT_LE(parameter.defaultValue, parameter.maximum) << parameter.name;
			}
		}
	}
}

TEST(FilterDefinitions, switchesHaveTheDefaultsOfTheCore) {
	const auto defaultOf = [](const char* name) {
		const auto& parameter = parameterDefinition(FilterId::GenerateIndexBoolean, name);
		EXPECT_EQ(parameter.kind, ParameterKind::Bool);
		EXPECT_FALSE(parameter.advanced);
		return parameter.defaultValue != 0;
	};
	const Options options;
	EXPECT_EQ(defaultOf("merge_fragments"), options.mergeFragments);
	EXPECT_EQ(defaultOf("merge_coplanar"), options.mergeCoplanar);
	EXPECT_EQ(defaultOf("weld_non_manifold"), options.weldNonManifold);
	for (const FilterId filter :
	     {FilterId::GenerateIndexBoolean, FilterId::GenerateIndexBooleanExpression,
	      FilterId::GenerateIndexBooleanResolve, FilterId::GenerateIndexBooleanSplit}) {
		const ParameterDefinition& tolerance = parameterDefinition(filter, "merge_tolerance");
		EXPECT_EQ(tolerance.kind, ParameterKind::Length);
		EXPECT_EQ(tolerance.defaultValue, options.mergeTolerance);
	}
	const auto choiceOf = [](const char* name) {
		return parameterDefinition(FilterId::GenerateIndexBoolean, name).defaultValue;
	};
	EXPECT_EQ(choiceOf("self_intersections"), static_cast<int>(SelfIntersections::Resolve));
	EXPECT_EQ(choiceOf("winding_rule"), static_cast<int>(options.windingRule));
}

TEST(Messages, aMergeSaysHowMuchWentAndHowFar) {
	EXPECT_EQ(mergedMessage("\"A union B\"", {12, 2e-16}),
	          "\"A union B\": 12 vertices went where walls were merged, from 2e-16 beside them at "
	          "most.");
	EXPECT_EQ(mergedMessage("All pieces", {1, 0}),
	          "All pieces: 1 vertex went where walls were merged, from 0 beside them at most.");
}

TEST(FilterDefinitions, labelsHaveNoDotsThatTheHostWouldTakeForAFilesSuffix) {
	EXPECT_EQ(blockLabel(Operation::Union, named("a.ply", "b.3ds")), "a union b");
	EXPECT_EQ(blockLabel(Operation::Union, named("scan.v2.stl", ".hidden")),
	          "scan_v2 union _hidden");
	EXPECT_EQ(blockLabel(Operation::Union, named("cube 1.25", "2.5 cubes")),
	          "cube 1_25 union 2_5 cubes");
	EXPECT_EQ(blockLabel(Operation::Union, named("", "end.")), " union end_");
}

TEST(FilterDefinitions, labelsAreMadeOfBothInputsLabels) {
	EXPECT_EQ(blockLabel(Operation::Union, named("A", "B")), "A union B");
	EXPECT_EQ(blockLabel(Operation::Intersection, named("A", "B")), "A intersection B");
	EXPECT_EQ(blockLabel(Operation::FirstMinusSecond, named("A", "B")), "A minus B");
	EXPECT_EQ(blockLabel(Operation::SecondMinusFirst, named("A", "B")), "B minus A");
	EXPECT_EQ(blockLabel(Operation::SymmetricDifference, named("A", "B")), "A xor B");
}

}  // namespace
}  // namespace index_boolean
