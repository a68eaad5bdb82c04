// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// cgal_self_intersections FILE [--soup]: a second opinion on a surface, by CGAL alone.
// in: two 64-bit counts, of points and of faces, then the points (three doubles each) and the faces
// (three 64-bit indices each), equal points given once; out: the faces that meet others in more
// than common corners and edges, or have no area, a line each. Where the faces make a manifold,
// CGAL's own search is asked; where they do not, or with --soup, all pairs of faces whose boxes
// meet are tried by CGAL's exact predicates. Exit status: 0 done, 2 usage; an unreadable file ends
// it.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using Face = std::array<std::size_t, 3>;
using Mesh = CGAL::Surface_mesh<Point>;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

struct Soup {
	std::vector<Point> points;
	std::vector<Face> faces;

	Triangle triangle(std::size_t face) const {
		const Face& corners = faces[face];
		return {points[corners[0]], points[corners[1]], points[corners[2]]};
	}
};

template <class Row>
std::vector<Row> read(std::ifstream& file, std::int64_t count) {
	std::vector<Row> rows(static_cast<std::size_t>(count));
	file.read(reinterpret_cast<char*>(rows.data()),
	          static_cast<std::streamsize>(rows.size() * sizeof(Row)));
	return rows;
}

Soup load(const char* path) {
	std::ifstream file;
	file.exceptions(std::ios::failbit | std::ios::badbit);
	file.open(path, std::ios::binary);
	const auto counts = read<std::int64_t>(file, 2);
	Soup soup;
	for (const auto& p : read<std::array<double, 3>>(file, counts[0])) {
		soup.points.emplace_back(p[0], p[1], p[2]);
	}
	for (const auto& f : read<std::array<std::int64_t, 3>>(file, counts[1])) {
		soup.faces.push_back({static_cast<std::size_t>(f[0]), static_cast<std::size_t>(f[1]),
		                      static_cast<std::size_t>(f[2])});
	}
	return soup;
}

// The corners of two faces, those in common first and in the same order.
struct Corners {
	Face a, b;
	int common = 0;
};

Corners matched(Face a, Face b) {
	Corners corners{a, b, 0};
	for (std::size_t i = 0; i < 3; ++i) {
		for (std::size_t j = static_cast<std::size_t>(corners.common); j < 3; ++j) {
			if (corners.a[i] == corners.b[j]) {
				const auto k = static_cast<std::size_t>(corners.common++);
				std::swap(corners.a[i], corners.a[k]);
				std::swap(corners.b[j], corners.b[k]);
				break;
			}
		}
	}
	return corners;
}

// Whether two faces, both with an area, have more in common than corners and edges of both.
bool meetWrongly(const Soup& soup, std::size_t first, std::size_t second) {
	const Corners c = matched(soup.faces[first], soup.faces[second]);
	const auto a = [&](std::size_t i) { return soup.points[c.a[i]]; };
	const auto b = [&](std::size_t i) { return soup.points[c.b[i]]; };
	switch (c.common) {
	case 0:
		return CGAL::do_intersect(soup.triangle(first), soup.triangle(second));
	case 1:
		return CGAL::do_intersect(soup.triangle(first), Segment(b(1), b(2))) ||
		       CGAL::do_intersect(soup.triangle(second), Segment(a(1), a(2)));
	case 2:
		return CGAL::coplanar(a(0), a(1), a(2), b(2)) &&
		       CGAL::coplanar_orientation(a(0), a(1), a(2), b(2)) == CGAL::POSITIVE;
	default:
		return true;
	}
}

std::set<std::size_t> searchSoup(const Soup& soup) {
	std::set<std::size_t> found;
	std::vector<Box> boxes;
	for (std::size_t face = 0; face < soup.faces.size(); ++face) {
		const Triangle triangle = soup.triangle(face);
		if (triangle.is_degenerate()) {
			found.insert(face);
		} else {
			boxes.emplace_back(triangle.bbox(), face);
		}
	}
	CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
		if (meetWrongly(soup, a.info(), b.info())) {
			found.insert({a.info(), b.info()});
		}
	});
	return found;
}

std::set<std::size_t> searchManifold(const Soup& soup) {
	Mesh mesh;
	processing::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
	std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
	processing::self_intersections(mesh, std::back_inserter(pairs));
	std::set<std::size_t> found;
	for (const auto& [a, b] : pairs) {
		found.insert({a.idx(), b.idx()});
	}
	return found;
}

// CGAL's own search takes no flat face.
bool isForManifolds(const Soup& soup) {
	for (std::size_t face = 0; face < soup.faces.size(); ++face) {
		if (soup.triangle(face).is_degenerate()) {
			return false;
		}
	}
	return processing::is_polygon_soup_a_polygon_mesh(soup.faces);
}

}  // namespace

int main(int argc, char** argv) {
	const bool soupOnly = argc == 3 && std::string(argv[2]) == "--soup";
	if (argc != 2 && !soupOnly) {
		std::cerr << "usage: cgal_self_intersections FILE [--soup]\n";
		return 2;
	}
	const Soup soup = load(argv[1]);
	const bool manifold = !soupOnly && isForManifolds(soup);
	for (const std::size_t face : manifold ? searchManifold(soup) : searchSoup(soup)) {
		std::cout << face << '\n';
	}
	return 0;
}
