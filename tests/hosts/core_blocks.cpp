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

template <class Row>
std::vector<Row> load(const std::filesystem::path& path) {
	std::vector<Row> rows(std::filesystem::file_size(path) / sizeof(Row));
	std::ifstream file(path, std::ios::binary);
	file.exceptions(std::ios::failbit | std::ios::badbit);
	file.read(reinterpret_cast<char*>(rows.data()),
	          static_cast<std::streamsize>(rows.size() * sizeof(Row)));
	return rows;
}

template <class Array>
void save(const Array& rows, const std::filesystem::path& path) {
	std::ofstream file(path, std::ios::binary);
	file.exceptions(std::ios::failbit | std::ios::badbit);
	file.write(reinterpret_cast<const char*>(rows.data()),
	           static_cast<std::streamsize>(rows.size() * sizeof(typename Array::value_type)));
}

Status loadOperands(const std::filesystem::path& folder, Monitor& monitor, MeshArrays& out) {
	const auto points0 = load<Point>(folder / "points_0.f64");
	const auto points1 = load<Point>(folder / "points_1.f64");
	const auto triangles0 = load<IndexTriangle>(folder / "triangles_0.u32");
	const auto triangles1 = load<IndexTriangle>(folder / "triangles_1.u32");
	return joinSurfaces({viewOf(points0, triangles0), viewOf(points1, triangles1)}, 0, monitor,
	                    out);
}

// \return the first status that is not Ok, else Ok
Status run(OutputScalar scalar, const std::filesystem::path& folder) {
	Options options;
	options.outputScalar = scalar;
	Monitor monitor;
	Arrangement arrangement;
	MeshArrays operands;
	Status status = loadOperands(folder, monitor, operands);
	if (status.ok()) {
		status = arrange(std::move(operands), options, monitor, arrangement);
	}
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
