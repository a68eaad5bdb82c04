// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// core_blocks double|float FOLDER: the core alone, for comparison with what hosts deliver.
// in: FOLDER/points_0.f64, triangles_0.u32 and the same with 1, raw arrays with three numbers a
// row; out: FOLDER/<block>_points.f64 and <block>_triangles.u32 for all blocks, and on standard
// output a line for each: its name and how many zero-area faces were cleaned away.
// Exit status: 0 done, 1 refused, 2 usage; an unreadable file ends it.
#include <vcg_ext/index_boolean.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <utility>

namespace {

using namespace index_boolean;
using IndexRow = std::array<std::uint32_t, 3>;

template <class Row>
std::vector<Row> load(const std::filesystem::path& path) {
	std::vector<Row> rows(std::filesystem::file_size(path) / sizeof(Row));
	std::ifstream file(path, std::ios::binary);
	file.exceptions(std::ios::failbit | std::ios::badbit);
	file.read(reinterpret_cast<char*>(rows.data()),
	          static_cast<std::streamsize>(rows.size() * sizeof(Row)));
	return rows;
}

template <class Row>
void save(const std::vector<Row>& rows, const std::filesystem::path& path) {
	std::ofstream file(path, std::ios::binary);
	file.exceptions(std::ios::failbit | std::ios::badbit);
	file.write(reinterpret_cast<const char*>(rows.data()),
	           static_cast<std::streamsize>(rows.size() * sizeof(Row)));
}

MeshArrays loadOperands(const std::filesystem::path& folder) {
	MeshArrays arrays;
	for (std::size_t k = 0; k < 2; ++k) {
		const std::string suffix = "_" + std::to_string(k);
		const auto points = load<Point>(folder / ("points" + suffix + ".f64"));
		const auto begin = static_cast<std::uint32_t>(arrays.points.size());
		arrays.points.insert(arrays.points.end(), points.begin(), points.end());
		for (const IndexRow& t : load<IndexRow>(folder / ("triangles" + suffix + ".u32")))
			arrays.triangles.push_back({makeId<VertexTag>(begin + t[0]),
			                            makeId<VertexTag>(begin + t[1]),
			                            makeId<VertexTag>(begin + t[2])});
		for (std::size_t end = k + 1; end < 3; ++end) {
			arrays.vertexBegin[end] = static_cast<std::uint32_t>(arrays.points.size());
			arrays.faceBegin[end] = static_cast<std::uint32_t>(arrays.triangles.size());
		}
	}
	return arrays;
}

// \return the first status that is not Ok, else Ok
Status run(OutputScalar scalar, const std::filesystem::path& folder) {
	Options options;
	options.outputScalar = scalar;
	Monitor monitor;
	Arrangement arrangement;
	Status status = arrange(loadOperands(folder), options, monitor, arrangement);
	for (int i = 0; i < kOperationCount && status.ok(); ++i) {
		Block block;
		status = extractBlock(arrangement, static_cast<Operation>(i), monitor, block);
		const std::string name = operationName(static_cast<Operation>(i));
		save(block.points, folder / (name + "_points.f64"));
		save(block.triangles, folder / (name + "_triangles.u32"));
		std::cout << name << ' ' << block.zeroAreaFacesRemoved << '\n';
	}
	return status;
}

}  // namespace

int main(int argc, char** argv) {
	const std::string scalar = argc == 3 ? argv[1] : "";
	if (scalar != "double" && scalar != "float") {
		std::cerr << "usage: core_blocks double|float FOLDER\n";
		return 2;
	}
	const Status status =
	    run(scalar == "float" ? OutputScalar::Float : OutputScalar::Double, argv[2]);
	if (!status.ok()) {
		std::cerr << describe(status) << '\n';
		return 1;
	}
	return 0;
}
