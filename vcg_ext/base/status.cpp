// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a Status; out: a name or a sentence for people. One table, one row per code, in the order of
// the codes. Guarantee: the text does not depend on the program's locale.
#include "vcg_ext/base/status.h"

#include <locale>
#include <sstream>

namespace index_boolean {

namespace {

struct Row {
	StatusCode code;
	const char* name;
	const char* defect;  // of one operand without its name, or a whole sentence on both
	const char* one;     // after a count of 1, null where a count says nothing
	const char* many;    // after any other count
};

constexpr Row kRows[] = {
    {StatusCode::Ok, "ok", "has no defect", nullptr, nullptr},
    {StatusCode::Cancelled, "cancelled", "the run was cancelled, nothing was changed", nullptr,
     nullptr},
    {StatusCode::OutOfMemory, "out of memory", "there is not enough memory, nothing was changed",
     nullptr, nullptr},
    {StatusCode::EmptyOperand, "empty", "has no face that encloses anything",
     "pair of opposite faces cancels", "pairs of opposite faces cancel"},
    {StatusCode::NotFinite, "not finite", "has coordinates that are not finite numbers",
     "face has a corner there", "faces have a corner there"},
    {StatusCode::IndexOutOfRange, "index out of range", "refers to vertices that do not exist",
     "face has such a corner", "faces have such a corner"},
    {StatusCode::TooLarge, "too large",
     "the meshes have more than 2147483647 vertices or faces in all", "element", "elements"},
    {StatusCode::NotClosed, "not closed", "is not closed", "edge has a face on one side only",
     "edges have a face on one side only"},
    {StatusCode::NotOriented, "not consistently oriented", "is not consistently oriented",
     "edge has neighbouring faces that run the same way along it",
     "edges have neighbouring faces that run the same way along them"},
    {StatusCode::NoVolume, "no volume", "is closed but its signed volume is exactly zero", nullptr,
     nullptr},
    {StatusCode::NestedComponents, "nested components",
     "has components that are inside out or lie inside each other's solid", "component is affected",
     "components are affected"},
    {StatusCode::SelfIntersecting, "self-intersecting", "intersects itself", "face is concerned",
     "faces are concerned"},
    {StatusCode::InternalError, "internal error",
     "a check of the result failed, which is a defect of Index Boolean: please report it", nullptr,
     nullptr},
    {StatusCode::WeldTooWide, "weld too wide",
     "has vertices that chains of distances below the weld distance link, but that are more than "
     "twice it apart",
     "group of vertices is too wide", "groups of vertices are too wide"},
    {StatusCode::BeyondFloat, "beyond float",
     "has coordinates beyond 3.4e38, where single precision ends", "face has a corner there",
     "faces have a corner there"},
};

constexpr bool rowsAreInOrder() {
	std::size_t index = 0;
	for (const Row& row : kRows) {
		if (static_cast<std::size_t>(row.code) != index++) {
			return false;
		}
	}
	return index == kStatusCodeCount;
}
static_assert(rowsAreInOrder(), "one row per status code, in the order of the codes");

const Row& rowOf(StatusCode code) { return kRows[static_cast<std::size_t>(code)]; }

}  // namespace

const char* statusName(StatusCode code) { return rowOf(code).name; }

std::string describe(const Status& status) {
	const Row& row = rowOf(status.code);
	const bool counts = row.many != nullptr && status.count > 0;
	std::ostringstream text;
	text.imbue(std::locale::classic());
	text.precision(6);
	text << row.defect;
	if (counts) {
		text << ": " << status.count << ' ' << (status.count == 1 ? row.one : row.many);
	}
	if (status.hasPlace) {
		const Point& p = status.place;
		text << (counts && status.count > 1 ? ", the first near (" : ", near (") << p[0] << ", "
		     << p[1] << ", " << p[2] << ')';
	}
	return text.str();
}

}  // namespace index_boolean
