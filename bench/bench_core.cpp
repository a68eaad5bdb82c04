// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// index_boolean_bench: times the core alone, from arrays to arrays, and prints JSON.
// Timed is all that a caller of the core waits for: the copy of both operands into its arrays,
// the arrangement, the blocks and their audit (or the parts that both are split into), and freeing
// the arrangement; not reading or placing.
// Every run starts anew. Exit status: 0 done, 1 refused or unreadable input, 2 usage.
#include "soups.h"

#include <vcg_ext/base/huge_pages.h>
#include <vcg_ext/base/parallel.h>
#include <vcg_ext/base/sign_counts.h>
#include <vcg_ext/index_boolean.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numeric>
#include <optional>
#include <thread>

namespace {

using namespace index_boolean;
using index_boolean_bench::Matrix;
using index_boolean_bench::Surface;
using nlohmann::ordered_json;

using Operands = std::array<Surface, 2>;

const std::vector<Operation> kFourBlocks{Operation::Union, Operation::Intersection,
                                         Operation::FirstMinusSecond, Operation::SecondMinusFirst};

struct CommandLine {
	std::vector<std::string> files;
	std::size_t spheres = 0, cubeAndSphere = 0, twinSpheres = 0;  // faces of a sphere; 0: not asked
	std::array<std::size_t, 2> terrain{};  // faces of the terrain and of the sheet
	bool split = false;
	std::uint32_t gridBoxes = 0;           // squares along a side; 0: not asked
	std::uint32_t plateHoles = 0;          // prisms through the plate; 0: not asked
	std::uint32_t smallPairs = 0;          // how many; 0: not asked
	std::uint32_t cancels = 0;             // how many; 0: not asked
	std::vector<std::uint32_t> hardSizes;  // per hard input; 0: not asked
	bool boxes = false, attributes = false, oneOperation = false, sizes = false, certify = false;
	bool checkSelfIntersections = false, resolve = false;
	std::string placement = "none";
	std::array<std::vector<double>, 2> transforms;  // 12 or 16 numbers, or none
	Operation operation = Operation::Union;
	int threads = 0, runs = 5, warmups = 1;
	double seconds = 0;         // of timed runs, at least
	double mergeTolerance = 0;  // a length
	std::string saveArrays;
};

// ---- operands

Matrix affine(const std::vector<double>& numbers) {
	Matrix matrix{};
	std::copy_n(numbers.begin(), matrix.size(), matrix.begin());
	return matrix;
}

void place(const CommandLine& commandLine, Operands& operands) {
	if (commandLine.placement == "standard") {
		const bool twice =
		    !commandLine.files.empty() && commandLine.files.front() == commandLine.files.back();
		for (Surface& surface : operands) {
			index_boolean_bench::normalize(surface);
		}
		const Point shift = twice ? Point{0.05, 0.04, 0.03} : Point{0, 0, 0};
		transform(index_boolean_bench::standardRotation(shift), operands[1]);
	}
	for (std::size_t k = 0; k < 2; ++k) {
		if (!commandLine.transforms[k].empty()) {
			transform(affine(commandLine.transforms[k]), operands[k]);
		}
	}
}

// An input on which something may grow with the square of its size; see limits.py.
struct HardInput {
	const char* option;
	const char* description;
	Operands (*make)(std::uint32_t size);
};

Surface cubeAt(const Point& centre, double side) {
	Surface cube = index_boolean_bench::makeCube(side);
	transform({1, 0, 0, centre[0], 0, 1, 0, centre[1], 0, 0, 1, centre[2]}, cube);
	return cube;
}

Operands makeStraySpheres(std::uint32_t faces) {
	Operands operands;
	operands[0] = operands[1] = index_boolean_bench::makeSphere(faces);
	transform(index_boolean_bench::standardRotation({0.6, 0.64, 0.48}), operands[1]);
	for (Surface& sphere : operands) {
		sphere.points.push_back({1e9, 1e9, 1e9});
	}
	return operands;
}

Operands makeCones(std::uint32_t sides) {
	Operands operands;
	operands[0] = operands[1] = index_boolean_bench::makeCone(sides);
	transform({1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0}, operands[1]);
	return operands;
}

const std::vector<HardInput> kHardInputs{
    {"--tower", "A tower of this many boxes that touch, and a cube that cuts its top",
     [](std::uint32_t count) -> Operands {
	     return {index_boolean_bench::makeTower(count), cubeAt({0, 0, 1.0 * count}, 1.5)};
     }},
    {"--wall", "A wall of N x N cubes across x, and a cube that cuts the first",
     [](std::uint32_t n) -> Operands {
	     return {index_boolean_bench::makeWall(n), cubeAt({1, 0.5, 0.5}, 0.5)};
     }},
    {"--stray-spheres",
     "The spheres, of about this many faces, each with one far vertex that no face has",
     makeStraySpheres},
    {"--cones", "Two cones of this many sides, tip on tip", makeCones},
    {"--polygon-plate",
     "A plate whose top is one polygon of N x N squares, and an upright prism of 10 N / 3 sides",
     [](std::uint32_t n) -> Operands {
	     return {index_boolean_bench::makePolygonPlate(n),
	             index_boolean_bench::makePrisms(1, std::max(3U, 10 * n / 3))};
     }},
    {"--row", "A row of this many cubes along x, and a cube that cuts the first",
     [](std::uint32_t count) -> Operands {
	     return {index_boolean_bench::makeRow(count), cubeAt({0, 0.5, 0.5}, 0.5)};
     }},
    {"--pinwheel", "This many tetrahedra round one edge, and a small cube that cuts the first",
     [](std::uint32_t count) -> Operands {
	     return {index_boolean_bench::makePinwheel(count), cubeAt({1, 0, 0}, 0.01)};
     }},
    {"--stack", "This many prisms in one layer whose bases lie in one plane, and a cube far away",
     [](std::uint32_t count) -> Operands {
	     return {index_boolean_bench::makeStack(count), cubeAt({9, 9, 9}, 1)};
     }},
    {"--crossed-cones",
     "Two cones of this many sides and one tip in one layer, and a cube far away",
     [](std::uint32_t sides) -> Operands {
	     return {index_boolean_bench::makeCrossedCones(sides), cubeAt({9, 9, 9}, 1)};
     }},
    {"--near-copies",
     "Five spheres of about this many faces in one layer, nearly in one place, and "
     "a cube far away",
     [](std::uint32_t faces) -> Operands {
	     return {index_boolean_bench::makeNearCopies(faces), cubeAt({9, 9, 9}, 1)};
     }},
    {"--pencil", "This many wedges in one layer with faces through one axis, and 4 N boxes across",
     [](std::uint32_t count) -> Operands {
	     constexpr double kHeight = 64;
	     return {index_boolean_bench::makePencil(count, kHeight),
	             index_boolean_bench::makeSlabs(4 * count, kHeight)};
     }},
};

// What the core is asked for.
Options optionsOf(const CommandLine& commandLine) {
	Options options;
	options.threads = commandLine.threads;
	options.selfIntersections = commandLine.resolve                  ? SelfIntersections::Resolve
	                            : commandLine.checkSelfIntersections ? SelfIntersections::Refuse
	                                                                 : SelfIntersections::Trust;
	options.certify = commandLine.certify;
	options.mergeTolerance = commandLine.mergeTolerance;
	return options;
}

// The hard input that is asked for, or none.
const HardInput* hardInput(const CommandLine& commandLine, std::uint32_t& size) {
	for (std::size_t i = 0; i < kHardInputs.size(); ++i) {
		size = commandLine.hardSizes[i];
		if (size > 0) {
			return &kHardInputs[i];
		}
	}
	return nullptr;
}

Operands makeOperands(const CommandLine& commandLine) {
	Operands operands;
	std::uint32_t size = 0;
	if (const HardInput* hard = hardInput(commandLine, size); hard != nullptr) {
		operands = hard->make(size);
	} else if (commandLine.spheres > 0) {
		operands[0] = operands[1] = index_boolean_bench::makeSphere(commandLine.spheres);
		transform(index_boolean_bench::standardRotation({0.6, 0.64, 0.48}), operands[1]);
	} else if (commandLine.cubeAndSphere > 0) {
		operands[0] = index_boolean_bench::makeCube(1.6);
		operands[1] = index_boolean_bench::makeSphere(commandLine.cubeAndSphere);
		transform(index_boolean_bench::standardRotation(), operands[1]);
	} else if (commandLine.terrain[0] > 0) {
		operands[0] = index_boolean_bench::makeTerrain(commandLine.terrain[0], 6, 0.05);
		operands[1] = index_boolean_bench::makeTerrain(commandLine.terrain[1], 2, 0.03);
		transform({1.2, 0, 0, -0.1, 0, 1.2, 0, -0.1, 0, 0, 1, 0.01}, operands[1]);
	} else if (commandLine.twinSpheres > 0) {
		operands[0] = operands[1] = index_boolean_bench::makeSphere(commandLine.twinSpheres);
	} else if (commandLine.plateHoles > 0) {
		operands[0] = index_boolean_bench::makeCube(1.2);
		transform({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.1, 0}, operands[0]);
		operands[1] = index_boolean_bench::makePrisms(commandLine.plateHoles, 33);
	} else if (commandLine.boxes) {
		operands[0] = operands[1] = index_boolean_bench::makeCube(1);
		transform(index_boolean_bench::standardRotation({0.3, 0.2, 0.1}), operands[1]);
	} else if (commandLine.gridBoxes > 0) {
		operands[0] = operands[1] = index_boolean_bench::makeGridBox(commandLine.gridBoxes);
		transform({1, 0, 0, 2, 0, 1, 0, 0.0078125, 0, 0, 1, 0.01171875}, operands[1]);
	} else {
		for (std::size_t k = 0; k < 2; ++k) {
			operands[k] = index_boolean_bench::readSurface(commandLine.files[k]);
		}
	}
	place(commandLine, operands);
	return operands;
}

// Raw arrays in the machine's byte order, three numbers a row, for peers to read: points_0.f64,
// triangles_0.u32 and the same with 1.
void saveArrays(const Operands& operands, const std::filesystem::path& folder) {
	std::filesystem::create_directories(folder);
	const auto save = [&](const std::string& name, const auto& rows) {
		std::ofstream file;
		file.exceptions(std::ios::failbit | std::ios::badbit);
		file.open(folder / name, std::ios::binary);
		file.write(reinterpret_cast<const char*>(rows.data()),
		           static_cast<std::streamsize>(rows.size() * sizeof(rows.front())));
	};
	for (std::size_t k = 0; k < 2; ++k) {
		save("points_" + std::to_string(k) + ".f64", operands[k].points);
		save("triangles_" + std::to_string(k) + ".u32", operands[k].triangles);
	}
}

// ---- one run

class StopWatch {
public:
	// Seconds since the last lap.
	double lap() {
		const Clock::time_point now = Clock::now();
		return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
	}

private:
	using Clock = std::chrono::steady_clock;
	Clock::time_point last_ = Clock::now();
};

struct Outcome {
	Status status;
	std::vector<std::pair<std::string, double>> stages;  // seconds, in the order they ran
	double total = 0;
	double auditSeconds = 0;
	LoopCounts loops;
	std::size_t facesCut = 0, segmentsOnFaces = 0, pieces = 0;
	std::vector<Block> blocks;
	Audit audit;
	std::array<std::size_t, 2> subSurfaces{};
	std::vector<double> subBlockVolumes;
	SplitAudit splitAudit;
};

// The stages after the arrangement. \return the status of the first that failed
Status readBlocks(const Arrangement& arrangement, const std::vector<Operation>& operations,
                  Monitor& monitor, StopWatch& stage, Outcome& out) {
	out.blocks.resize(operations.size());
	for (std::size_t i = 0; i < operations.size(); ++i) {
		const Status status = extractBlock(arrangement, operations[i], monitor, out.blocks[i]);
		if (!status.ok()) {
			return status;
		}
		out.stages.emplace_back(std::string("block ") + operationName(operations[i]), stage.lap());
	}
	const Status status = audit(arrangement, out.blocks, monitor, out.audit);
	out.auditSeconds = stage.lap();
	out.stages.emplace_back("audit", out.auditSeconds);
	return status;
}

// The stages after an arrangement for splitting: all parts, their meshes, and the audit.
Status readParts(const Arrangement& arrangement, Monitor& monitor, StopWatch& stage, Outcome& out) {
	Split parts;
	Status status = split(arrangement, monitor, parts);
	stage.lap();
	for (const StageTime& time : parts.stageTimes) {
		out.stages.emplace_back(time.stage, time.seconds);
	}
	for (std::size_t k = 0; k < 2 && status.ok(); ++k) {
		const auto operand = makeId<OperandTag>(k);
		SplitMesh mesh;
		status = extractSubSurfaces(arrangement, parts, operand, monitor, mesh);
		out.subSurfaces[k] = parts.surfaces.ofOperand[operand].size();
	}
	out.stages.emplace_back("sub-surface meshes", stage.lap());
	std::vector<SplitMesh> boundaries(parts.blocks.all.size());
	for (std::size_t i = 0; i < boundaries.size() && status.ok(); ++i) {
		status =
		    extractSubBlock(arrangement, parts, makeId<SubBlockTag>(i), monitor, boundaries[i]);
		out.subBlockVolumes.push_back(parts.blocks.all[i].volume);
	}
	out.stages.emplace_back("sub-block meshes", stage.lap());
	if (status.ok()) {
		status = audit(arrangement, parts, boundaries, monitor, out.splitAudit);
	}
	out.auditSeconds = stage.lap();
	out.stages.emplace_back("audit", out.auditSeconds);
	return status;
}

// Where all attributes of the blocks' vertices, faces and corners come from. The blocks may get
// copies of vertices.
Status findAttributes(const Operands& operands, const Arrangement& arrangement, Monitor& monitor,
                      std::vector<Block>& blocks) {
	const GivenTriangles given = [&operands](GivenFace face) {
		const std::size_t before = face.operand == kFirst ? 0 : operands[0].points.size();
		const auto& triangle = operands[face.operand.value].triangles[face.index];
		Triangle corners;
		for (std::size_t i = 0; i < 3; ++i) {
			corners[i] = makeId<VertexTag>(before + triangle[i]);
		}
		return corners;
	};
	const SameAttributes same = [](VertexId, VertexId) { return true; };
	AttributeNeeds needs;
	needs.corners = true;
	Seams seams;
	Status status = operandSeams(arrangement, given, same, monitor, seams);
	for (std::size_t i = 0; i < blocks.size() && status.ok(); ++i) {
		AttributeSources sources;
		status = attributeSources(arrangement, {given, seams, needs}, monitor, blocks[i], sources);
	}
	return status;
}

// Copies both operands into the arrays of a run.
Status copyIn(const Operands& operands, int threads, Monitor& monitor, MeshArrays& input) {
	const Status status = joinSurfaces({viewOf(operands[0].points, operands[0].triangles),
	                                    viewOf(operands[1].points, operands[1].triangles)},
	                                   threads, monitor, input);
	for (std::size_t k = 0; k < 2 && status.ok(); ++k) {
		const std::vector<std::uint8_t>& faux = operands[k].faux;
		if (!faux.empty()) {
			input.faux.resize(input.triangles.size());
			std::copy(faux.begin(), faux.end(),
			          input.faux.begin() + input.faceOffsets.begin(makeId<OperandTag>(k)));
		}
	}
	return status;
}

// Arranges the operands for blocks, or for their parts if there are no operations.
Status arrangeThem(const Operands& operands, const Options& options, bool forParts,
                   MeshArrays input, Monitor& monitor, Arrangement& out) {
	const auto again = [&](MeshArrays& mesh) {
		return copyIn(operands, options.threads, monitor, mesh);
	};
	if (forParts) {
		return arrangeSurfaces(std::move(input), options, monitor, out);
	}
	return options.selfIntersections == SelfIntersections::Resolve
	           ? arrangeOperands(std::move(input), again, options, monitor, out)
	           : arrange(std::move(input), options, monitor, out);
}

// What is read from each arrangement. No operations: the operands are split.
struct Job {
	std::vector<Operation> operations;
	bool attributes = false;
};

Outcome runOnce(const Operands& operands, const Options& options, const Job& job,
                Monitor& monitor) {
	const std::vector<Operation>& operations = job.operations;
	Outcome outcome;
	Arrangement arrangement;
	StopWatch total, stage;
	std::optional<PageReuse> pages(std::in_place);
	MeshArrays input;
	outcome.status = copyIn(operands, options.threads, monitor, input);
	outcome.stages.emplace_back("copy in", stage.lap());
	if (outcome.status.ok()) {
		outcome.status = arrangeThem(operands, options, operations.empty(), std::move(input),
		                             monitor, arrangement);
	}
	stage.lap();
	if (outcome.status.ok()) {
		for (const StageTime& time : arrangement.stageTimes) {
			outcome.stages.emplace_back(time.stage, time.seconds);
		}
		outcome.status = operations.empty()
		                     ? readParts(arrangement, monitor, stage, outcome)
		                     : readBlocks(arrangement, operations, monitor, stage, outcome);
	}
	if (outcome.status.ok() && job.attributes) {
		outcome.status = findAttributes(operands, arrangement, monitor, outcome.blocks);
		outcome.stages.emplace_back("attributes", stage.lap());
	}
	outcome.loops = arrangement.loopCounts;
	outcome.facesCut = arrangement.refinement.cutFaces.size();
	outcome.segmentsOnFaces = arrangement.curve.faceSegments.size();
	outcome.pieces = arrangement.refinement.pieces.size();
	arrangement = {};
	pages.reset();
	outcome.stages.emplace_back("free", stage.lap());
	outcome.total = total.lap();
	return outcome;
}

// ---- many runs

double median(std::vector<double> values) {
	std::sort(values.begin(), values.end());
	const std::size_t middle = values.size() / 2;
	return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

ordered_json describeBlocks(const Outcome& outcome) {
	ordered_json blocks;
	for (std::size_t i = 0; i < outcome.blocks.size(); ++i) {
		const Block& block = outcome.blocks[i];
		const BlockMeasure& measure = outcome.audit.blocks[i];
		blocks[operationName(block.operation)] = {
		    {"faces", block.triangles.size()},
		    {"vertices", block.points.size()},
		    {"volume", measure.volume},
		    {"area", measure.area},
		    {"components", measure.components},
		    {"closed", measure.closed},
		    {"zero_area_faces_removed", block.zeroAreaFacesRemoved}};
	}
	return blocks;
}

// What decided how many signs since the last call; empty in a build that does not count.
ordered_json describeSigns() {
	const std::array<const char*, kPredicateCount> predicates{
	    "pair_sieve", "orient3d", "orient2d",   "curve_orient2d", "curve_order",
	    "slopes",     "rounding", "axis_order", "in_circle",      "distance"};
	const std::array<const char*, kDeciderCount> deciders{"double", "double_double", "integers",
	                                                      "undecided"};
	const SignCounts counts = takeSignCounts();
	ordered_json signs;
	for (std::size_t p = 0; p < kPredicateCount; ++p) {
		for (std::size_t d = 0; d < kDeciderCount; ++d) {
			if (counts[p][d] > 0) {
				signs[predicates[p]][deciders[d]] = counts[p][d];
			}
		}
	}
	return signs;
}

// A line of /proc/self/status in bytes: VmRSS, the resident memory, or VmHWM, its peak. (The peak
// of getrusage would count the process that started this one.) 0 where there is no such file.
std::size_t residentMemory(const std::string& line) {
	std::ifstream status("/proc/self/status");
	std::string word;
	std::size_t kibibytes = 0;
	while (status >> word && word != line + ":") {
	}
	status >> kibibytes;
	return kibibytes * 1024;
}

// Makes VmHWM start again from VmRSS.
void resetPeakMemory() { std::ofstream("/proc/self/clear_refs") << "5"; }

// Medians over the runs after the warm-up; blocks and loops of the last run (all are equal).
// \return a refusal's status, else Ok
Status measure(const CommandLine& commandLine, const Operands& operands,
               const std::vector<Operation>& operations, ordered_json& out) {
	const Options options = optionsOf(commandLine);
	std::vector<double> totals, withoutAudit;
	std::vector<std::pair<std::string, std::vector<double>>> stages;
	resetPeakMemory();
	double timed = 0;
	for (int run = -commandLine.warmups; run < commandLine.runs || timed < commandLine.seconds;
	     ++run) {
		takeSignCounts();
		Monitor unheard;
		const Outcome outcome =
		    runOnce(operands, options, {operations, commandLine.attributes}, unheard);
		if (const ordered_json signs = describeSigns(); !signs.empty()) {
			out["signs"] = signs;
		}
		if (!outcome.status.ok()) {
			return outcome.status;
		}
		if (run < 0) {
			continue;
		}
		timed += outcome.total;
		totals.push_back(outcome.total);
		withoutAudit.push_back(outcome.total - outcome.auditSeconds);
		stages.resize(outcome.stages.size());
		for (std::size_t i = 0; i < stages.size(); ++i) {
			stages[i].first = outcome.stages[i].first;
			stages[i].second.push_back(outcome.stages[i].second);
		}
		out["loops"] = {{"open", outcome.loops.open},
		                {"hard_closed", outcome.loops.hardClosed},
		                {"soft_closed", outcome.loops.softClosed}};
		out["arrangement"] = {{"faces_cut", outcome.facesCut},
		                      {"segments_on_faces", outcome.segmentsOnFaces},
		                      {"pieces", outcome.pieces}};
		if (operations.empty()) {
			out["sub_surfaces"] = outcome.subSurfaces;
			out["sub_blocks"] = outcome.subBlockVolumes.size();
			out["sub_blocks_closed"] = outcome.splitAudit.closed;
			out["sub_blocks_volume"] = std::accumulate(outcome.subBlockVolumes.begin(),
			                                           outcome.subBlockVolumes.end(), 0.0);
		} else {
			out["volume_law_residual"] = outcome.audit.volumeLawResidual;
			out["blocks"] = describeBlocks(outcome);
		}
	}
	out["peak_memory_bytes"] = residentMemory("VmHWM");
	out["seconds"] = median(totals);
	out["seconds_without_audit"] = median(withoutAudit);
	out["seconds_each_run"] = totals;
	for (const auto& [name, seconds] : stages) {
		out["seconds_per_stage"][name] = median(seconds);
	}
	return {};
}

// ---- the command line

void addOperandOptions(CLI::App& app, CommandLine& out) {
	CLI::Option_group& operands = *app.add_option_group("operands", "One of these");
	operands.require_option(1);
	operands.add_option("files", out.files, "Two meshes: PLY, STL, OBJ, OFF")->expected(2);
	operands
	    .add_option("--spheres", out.spheres,
	                "Two unit spheres of about this many faces, 1 apart, instead of files")
	    ->check(CLI::PositiveNumber);
	operands
	    .add_option("--cube-and-sphere", out.cubeAndSphere,
	                "A cube of side 1.6 and a unit sphere of about this many faces")
	    ->check(CLI::PositiveNumber);
	operands
	    .add_option("--terrain", out.terrain,
	                "A terrain over the unit square and a sheet that cuts it, of about this many "
	                "faces each; they are split")
	    ->check(CLI::PositiveNumber);
	operands
	    .add_option("--twin-spheres", out.twinSpheres,
	                "One unit sphere of about this many faces, twice; --transform-second moves it")
	    ->check(CLI::PositiveNumber);
	operands
	    .add_option("--plate", out.plateHoles,
	                "A plate of 12 faces and this many prisms of 128 faces that go through it")
	    ->check(CLI::PositiveNumber);
	operands.add_flag("--boxes", out.boxes, "Two cubes of 12 faces, one turned");
	operands
	    .add_option("--small-pairs", out.smallPairs,
	                "This many pairs of solids of 12 to 500 faces: the time of a call")
	    ->check(CLI::PositiveNumber);
	operands
	    .add_option("--grid-boxes", out.gridBoxes,
	                "Two cubes whose walls are cut into N x N squares, with one wall in common, "
	                "shifted in its plane: coplanar faces that overlap")
	    ->check(CLI::PositiveNumber);
	out.hardSizes.resize(kHardInputs.size());
	for (std::size_t i = 0; i < kHardInputs.size(); ++i) {
		operands.add_option(kHardInputs[i].option, out.hardSizes[i], kHardInputs[i].description)
		    ->check(CLI::PositiveNumber);
	}
}

// What the core is to do besides.
void addCoreOptions(CLI::App& app, CommandLine& out) {
	app.add_flag("--certify", out.certify,
	             "Certifies what is delivered, as hosts do; off, so that commits compare");
	app.add_flag("--attributes", out.attributes,
	             "Times also where all attributes of the blocks' elements come from");
	app.add_flag("--check-self-intersections", out.checkSelfIntersections,
	             "Times also the search of both operands for faces that meet wrongly");
	app.add_flag("--resolve", out.resolve,
	             "Searches both operands, and resolves what meets itself, as hosts do");
	app.add_option("--merge-tolerance", out.mergeTolerance,
	               "A length: merges walls that lie within it of one plane")
	    ->check(CLI::NonNegativeNumber);
}

// Exits with 2 on a usage error, with 0 after --help.
CommandLine parse(int argc, char** argv) {
	CommandLine out;
	CLI::App app{"Times the Boolean core alone, from arrays to arrays, and prints JSON.",
	             "index_boolean_bench"};
	addOperandOptions(app, out);
	app.add_flag("--split", out.split, "Times the sub-surfaces and sub-blocks, not the blocks");
	app.add_option("--place", out.placement,
	               "standard: each centred, longest side 1, the second then turned by 0.7 rad "
	               "about (1,2,3), and shifted by (0.05,0.04,0.03) if it is the same file")
	    ->check(CLI::IsMember({"none", "standard"}));
	for (std::size_t k = 0; k < 2; ++k) {
		app.add_option(k == 0 ? "--transform-first" : "--transform-second", out.transforms[k],
		               "An affine matrix, row by row: 12 numbers, or 16 of which the last 4 are "
		               "not used; separated by commas")
		    ->delimiter(',')
		    ->allow_extra_args(false);
	}
	std::map<std::string, Operation> operations;
	for (int i = 0; i < kOperationCount; ++i) {
		operations[operationName(static_cast<Operation>(i))] = static_cast<Operation>(i);
	}
	app.add_option("--operation", out.operation, "The operation that is timed on its own")
	    ->transform(CLI::CheckedTransformer(operations).description(""));
	app.add_flag("--sizes", out.sizes, "Prints how large the operands are, and times nothing");
	app.add_flag("--one-operation", out.oneOperation, "Times that operation, not the four blocks");
	addCoreOptions(app, out);
	app.add_option("--threads", out.threads, "0: as many as there are")
	    ->check(CLI::NonNegativeNumber);
	app.add_option("--runs", out.runs, "Timed runs, of which the median is taken")
	    ->check(CLI::PositiveNumber);
	app.add_option("--seconds", out.seconds, "More timed runs, until they took that long in all")
	    ->check(CLI::NonNegativeNumber);
	app.add_option("--warmups", out.warmups, "Runs before those")->check(CLI::NonNegativeNumber);
	app.add_option("--cancels", out.cancels,
	               "Times nothing but how long it takes to cancel, at this many moments of a run")
	    ->check(CLI::PositiveNumber);
	app.add_option(
	    "--save-arrays", out.saveArrays,
	    "A folder for the operands as placed: points_0.f64, triangles_0.u32, ...; of small "
	    "pairs, a folder in it for each");
	try {
		app.parse(argc, argv);
		out.split = out.split || out.terrain[0] > 0;
		for (const auto& numbers : out.transforms) {
			if (!numbers.empty() && numbers.size() != 12 && numbers.size() != 16) {
				throw CLI::ValidationError("a transform has 12 or 16 numbers");
			}
		}
	} catch (const CLI::ParseError& error) {
		std::exit(app.exit(error) == 0 ? 0 : 2);
	}
	return out;
}

// Bytes that all threads together read and write in a second when they copy what no cache holds.
double copySpeed(int threads) {
	constexpr std::size_t kBytes = std::size_t{1} << 26, kGrain = std::size_t{1} << 20;
	const std::vector<char> from(kBytes, 1);
	std::vector<char> to(kBytes);
	std::vector<double> seconds;
	Monitor monitor;
	for (int run = 0; run < 9; ++run) {
		StopWatch watch;
		const Status status =
		    parallelFor(kBytes, kGrain, threads, monitor, [&](std::size_t begin, std::size_t end) {
			    std::copy(from.begin() + static_cast<std::ptrdiff_t>(begin),
			              from.begin() + static_cast<std::ptrdiff_t>(end),
			              to.begin() + static_cast<std::ptrdiff_t>(begin));
		    });
		seconds.push_back(status.ok() ? watch.lap() : 0);
	}
	return 2 * static_cast<double>(kBytes) / median(seconds);
}

// A cube or a sphere of up to 500 faces, and a sphere across its surface, turned.
Operands makeSmallPair(std::uint32_t number) {
	Operands pair;
	const std::size_t faces = 20 + 37 * number % 481;
	pair[0] =
	    number % 4 == 0 ? index_boolean_bench::makeCube(1) : index_boolean_bench::makeSphere(faces);
	pair[1] = number % 8 == 0 ? pair[0] : index_boolean_bench::makeSphere(520 - faces);
	const double shift = 0.3 + 0.001 * number;
	transform(index_boolean_bench::standardRotation({shift, shift / 2, shift / 3}), pair[1]);
	return pair;
}

// Cancels a run at moments spread over the time that a whole one takes. Timed is what a user waits
// from the wish to the return, with all memory given back.
Status measureCancel(const CommandLine& commandLine, const Operands& operands, ordered_json& out) {
	const Options options = optionsOf(commandLine);
	const Job job{commandLine.split ? std::vector<Operation>{} : kFourBlocks,
	              commandLine.attributes};
	Monitor unheard;
	StopWatch whole;
	if (const Outcome outcome = runOnce(operands, options, job, unheard); !outcome.status.ok()) {
		return outcome.status;
	}
	const double seconds = whole.lap();
	std::vector<double> waits;
	for (std::uint32_t moment = 0; moment < commandLine.cancels; ++moment) {
		std::atomic<bool> wanted{false};
		StopWatch watch;
		std::thread user([&] {
			std::this_thread::sleep_for(
			    std::chrono::duration<double>(seconds * (moment + 1) / (commandLine.cancels + 1)));
			watch.lap();
			wanted = true;
		});
		Monitor monitor([&wanted](double, const char*) { return !wanted; });
		const Status status = runOnce(operands, options, job, monitor).status;
		user.join();
		if (status.code == StatusCode::Cancelled) {  // else it was done before
			waits.push_back(watch.lap());
		}
	}
	out["moments"] = commandLine.cancels;
	out["cancelled"] = waits.size();
	if (!waits.empty()) {
		out["seconds"] = median(waits);
		out["slowest"] = *std::max_element(waits.begin(), waits.end());
	}
	return {};
}

// Each pair once to warm up, then again, timed. \return a refusal's status, else Ok
Status measureSmallPairs(const CommandLine& commandLine, ordered_json& out) {
	const Options options = optionsOf(commandLine);
	std::vector<double> seconds, withoutAudit;
	for (std::uint32_t i = 0; i < commandLine.smallPairs; ++i) {
		const Operands pair = makeSmallPair(i);
		if (!commandLine.saveArrays.empty()) {
			saveArrays(pair, std::filesystem::path(commandLine.saveArrays) / std::to_string(i));
		}
		Monitor unheard;
		runOnce(pair, options, {{commandLine.operation}}, unheard);
		const Outcome outcome = runOnce(pair, options, {{commandLine.operation}}, unheard);
		if (!outcome.status.ok()) {
			return outcome.status;
		}
		seconds.push_back(outcome.total);
		withoutAudit.push_back(outcome.total - outcome.auditSeconds);
		out["volumes"].push_back(outcome.audit.blocks[0].volume);
	}
	out["pairs"] = seconds.size();
	out["seconds"] = median(seconds);
	out["seconds_without_audit"] = median(withoutAudit);
	out["fastest"] = *std::min_element(seconds.begin(), seconds.end());
	out["slowest"] = *std::max_element(seconds.begin(), seconds.end());
	return {};
}

// \return the exit status
int run(const CommandLine& commandLine) {
	ordered_json out;
	Operands operands;
	if (commandLine.smallPairs == 0) {
		operands = makeOperands(commandLine);
		if (!commandLine.saveArrays.empty()) {
			saveArrays(operands, commandLine.saveArrays);
		}
	}
	for (const Surface& surface : operands) {
		out["operands"].push_back(
		    {{"vertices", surface.points.size()}, {"faces", surface.triangles.size()}});
	}
	if (commandLine.sizes) {
		std::cout << out.dump(2) << '\n';
		return 0;
	}
	if (!commandLine.split) {
		out["operation"] = operationName(commandLine.operation);
	}
	out["threads"] = commandLine.threads > 0 ? commandLine.threads : mostWorkers(0);
	if (commandLine.smallPairs == 0) {
		out["copied_bytes_per_second"] = copySpeed(commandLine.threads);
	}
	out["memory_before_bytes"] = residentMemory("VmRSS");
	Status status;
	if (commandLine.smallPairs > 0) {
		status = measureSmallPairs(commandLine, out["small_pairs"]);
	} else if (commandLine.cancels > 0) {
		status = measureCancel(commandLine, operands, out["cancel"]);
	} else if (commandLine.split) {
		status = measure(commandLine, operands, {}, out["split"]);
	} else {
		status = measure(commandLine, operands, {commandLine.operation}, out["one_operation"]);
		if (status.ok() && !commandLine.oneOperation) {
			status = measure(commandLine, operands, kFourBlocks, out["four_blocks"]);
		}
	}
	out["status"] = statusName(status.code);
	if (!status.ok()) {
		out["message"] = describe(status);
		out["operand"] = status.operand;
	}
	std::cout << out.dump(2) << '\n';
	return status.ok() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
	const CommandLine commandLine = parse(argc, argv);
	try {
		return run(commandLine);
	} catch (const std::exception& error) {
		std::cerr << "index_boolean_bench: " << error.what() << '\n';
		return 1;
	}
}
