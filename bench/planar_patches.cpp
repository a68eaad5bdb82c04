// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// planar_patches FOLDER TOLERANCE: CGAL's remeshing of almost planar patches, for merged.py.
// in: FOLDER/points.f64 and triangles.u32; out: there remeshed_points.f64 and
// remeshed_triangles.u32, and the seconds of the remeshing alone, printed. Exit status 1: CGAL says
// that it cannot, and hands back what it was given.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/region_growing.h>
#include <CGAL/Polygon_mesh_processing/remesh_planar_patches.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangle = std::array<std::uint32_t, 3>;

template <class Item>
std::vector<Item> readAll(const std::string& path) {
	std::ifstream file(path, std::ios::binary | std::ios::ate);
	std::vector<Item> items(static_cast<std::size_t>(file.tellg()) / sizeof(Item));
	file.seekg(0);
	file.read(reinterpret_cast<char*>(items.data()),
	          static_cast<std::streamsize>(items.size() * sizeof(Item)));
	return items;
}

template <class Item>
void writeAll(const std::string& path, const std::vector<Item>& items) {
	std::ofstream file(path, std::ios::binary);
	file.write(reinterpret_cast<const char*>(items.data()),
	           static_cast<std::streamsize>(items.size() * sizeof(Item)));
}

Mesh readMesh(const std::string& folder) {
	std::vector<Kernel::Point_3> points;
	for (const auto& p : readAll<std::array<double, 3>>(folder + "/points.f64")) {
		points.emplace_back(p[0], p[1], p[2]);
	}
	const auto triangles = readAll<Triangle>(folder + "/triangles.u32");
	Mesh mesh;
	processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
	return mesh;
}

void writeMesh(const std::string& folder, const Mesh& mesh) {
	std::vector<std::array<double, 3>> points;
	std::vector<std::uint32_t> number(mesh.number_of_vertices() +
	                                  mesh.number_of_removed_vertices());
	for (const auto v : mesh.vertices()) {
		const Kernel::Point_3& p = mesh.point(v);
		number[v] = static_cast<std::uint32_t>(points.size());
		points.push_back({p.x(), p.y(), p.z()});
	}
	std::vector<Triangle> triangles;
	for (const auto f : mesh.faces()) {
		Triangle triangle{};
		std::size_t corner = 0;
		for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
			triangle[corner++] = number[v];
		}
		triangles.push_back(triangle);
	}
	writeAll(folder + "/remeshed_points.f64", points);
	writeAll(folder + "/remeshed_triangles.u32", triangles);
}

// The recipe of CGAL's manual: regions within a distance and an angle of a plane, their corners,
// and new triangles between these. The angle is as wide as the manual's.
bool remesh(const Mesh& mesh, double tolerance, Mesh& out) {
	const auto region = mesh.property_map<Mesh::Face_index, std::size_t>("f:region").value();
	const auto corner = mesh.property_map<Mesh::Vertex_index, std::size_t>("v:corner").value();
	const auto border = mesh.property_map<Mesh::Edge_index, bool>("e:border").value();
	const auto limits = CGAL::parameters::maximum_distance(tolerance).cosine_of_maximum_angle(0.98);
	const std::size_t regions = processing::region_growing_of_planes_on_faces(mesh, region, limits);
	const std::size_t corners =
	    processing::detect_corners_of_regions(mesh, region, regions, corner,
	                                          CGAL::parameters::cosine_of_maximum_angle(0.98)
	                                              .maximum_distance(tolerance)
	                                              .edge_is_constrained_map(border));
	return processing::remesh_almost_planar_patches(mesh, out, regions, corners, region, corner,
	                                                border);
}

}  // namespace

int main(int argc, char** argv) {
	if (argc != 3) {
		std::cerr << "usage: planar_patches FOLDER TOLERANCE\n";
		return 2;
	}
	const std::string folder = argv[1];
	Mesh mesh = readMesh(folder), remeshed;
	mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region");
	mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:corner");
	mesh.add_property_map<Mesh::Edge_index, bool>("e:border", false);
	const auto start = std::chrono::steady_clock::now();
	const bool done = remesh(mesh, std::strtod(argv[2], nullptr), remeshed);
	const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
	writeMesh(folder, remeshed);
	std::cout << seconds.count() << "\n";
	return done ? 0 : 1;
}
