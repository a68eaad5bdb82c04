// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Errors are values: every stage returns a Status that says what is wrong, in which operand, how
// often and where. Nothing in the core prints, asserts on input, exits or lets an exception out.
#pragma once

#include "vcg_ext/base/point.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace index_boolean {

enum class StatusCode : std::uint8_t {
	Ok,
	Cancelled,         // the monitor's callback answered false
	OutOfMemory,       // an allocation failed; nothing was changed
	EmptyOperand,      // an operand has no face (left)
	NotFinite,         // faces with a coordinate that is NaN or infinite
	IndexOutOfRange,   // faces that name a vertex which does not exist
	TooLarge,          // more than 2^31 - 1 vertices or faces in all
	NotClosed,         // edges with one face only (or an odd number of faces)
	NotOriented,       // closed, but neighbouring faces run the same way along an edge
	NoVolume,          // closed, but encloses nothing: the signed volume is exactly zero
	NestedComponents,  // components of one operand inside out, or inside each other's solid
	SelfIntersecting,  // faces of one operand meet wrongly, or winding numbers contradict the curve
	InternalError,     // a check of our own failed; a defect of this library, never an answer
	WeldTooWide,       // vertices linked by distances below weldDistance are too far apart
	BeyondFloat,       // faces with a coordinate that a float as output cannot hold
};
constexpr int kStatusCodeCount = 15;

// What happened. `operand` is 0 or 1, or -1 where both or none are meant. `faces` are indices into
// that operand's triangles as given to the core. `count` is the number of defects (edges for
// NotClosed and NotOriented, components for NestedComponents, groups of vertices for WeldTooWide,
// else faces).
struct [[nodiscard]] Status {
	StatusCode code = StatusCode::Ok;
	int operand = -1;
	std::size_t count = 0;
	bool hasPlace = false;
	Point place{};               // one point at the first defect, if hasPlace
	double closingDistance = 0;  // NotClosed: a weldDistance that closes the operand, if known
	std::vector<std::uint32_t> faces;

	bool ok() const { return code == StatusCode::Ok; }
};

// A status that has no more to say than its code.
inline Status statusOf(StatusCode code) {
	Status status;
	status.code = code;
	return status;
}

// Calls steps, functions without parameters that return a Status, one after another until one is
// not Ok. \return that status, or Ok
template <class... Steps>
Status inOrder(Steps&&... steps) {
	Status status;
	static_cast<void>(((status = steps(), status.ok()) && ...));
	return status;
}

// A short name such as "not closed"; never null, never freed. Complexity: O(1).
const char* statusName(StatusCode code);

// One sentence on the defect with count and place, without the operand's name: "is not closed: 12
// edges have a face on one side only, the first near (0, 1, 2)". Complexity: O(1).
std::string describe(const Status& status);

}  // namespace index_boolean
