// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as two meshes and options: a run ends with blocks that keep their promises, or with a
// refusal that has a name. An internal error is neither. (Memory that runs out and a cancel cannot
// be blamed on a mesh; nobody cancels here.)
#include "fuzz_bytes.h"
#include "property.h"
#include "support/stored_faces.h"

namespace {

using namespace index_boolean;

std::string refusalDefect(const Status& status) {
	switch (status.code) {
	case StatusCode::EmptyOperand:
	case StatusCode::NotFinite:
	case StatusCode::BeyondFloat:
	case StatusCode::IndexOutOfRange:
	case StatusCode::NotClosed:
	case StatusCode::NotOriented:
	case StatusCode::NoVolume:
	case StatusCode::NestedComponents:
	case StatusCode::SelfIntersecting:
	case StatusCode::WeldTooWide:
		return status.operand == 0 || status.operand == 1 ? "" : "a refusal of no operand";
	case StatusCode::Ok:
	case StatusCode::Cancelled:
	case StatusCode::OutOfMemory:
	case StatusCode::TooLarge:
	case StatusCode::InternalError:
		break;
	}
	return std::string("not to be expected: ") + describe(status);
}

std::string facesDefect(const Status& status, const shapes::Mesh& a, const shapes::Mesh& b) {
	const std::size_t count = (status.operand == 0 ? a : b).triangles.size();
	for (const std::uint32_t face : status.faces) {
		if (face >= count) {
			return "a refusal for a face that was not given";
		}
	}
	return {};
}

std::string blocksDefect(const shapes::BooleanRun& r) {
	for (std::size_t k = 0; k < r.blocks.size(); ++k) {
		const std::string broken = brokenPromise(r.blocks[k]);
		if (!broken.empty()) {
			return broken + " in " + operationName(r.blocks[k].operation);
		}
		if (!r.audit.blocks[k].closed) {
			return "the audit lets an open block pass";
		}
	}
	return {};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
	fuzz::ByteReader in(bytes, size);
	const Options options = fuzz::options(in);
	const shapes::Mesh a = fuzz::mesh(in), b = fuzz::mesh(in);
	const shapes::BooleanRun r = shapes::run(a, b, options);
	if (r.status.ok()) {
		fuzz::expectNone(blocksDefect(r));
	} else {
		fuzz::expectNone(refusalDefect(r.status));
		fuzz::expectNone(facesDefect(r.status, a, b));
	}
	return 0;
}
