// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Most meshes have no duplicates, so two passes over the faces first rule out nearly all of them: a
// table of 64-bit words, of which a face sets two bits in the word of its vertices' mean number.
// Only faces that find both set, and those that share bits with such a face, are compared.
#include "vcg_ext/arrange/duplicate_faces.h"

#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/groups.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/boundary_checksum.h"
#include "vcg_ext/mesh/face_key.h"

#include <algorithm>
#include <functional>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;  // faces between polls

using SuspectFace = KeyedFace<VertexId>;

// The bits that faces have set, by the mean number of their vertices: neighbouring faces use words
// near to each other, and the many faces of one vertex do not share a word.
class FaceFilter {
public:
	// A word for each two faces: a closed surface has half as many vertices as faces.
	explicit FaceFilter(std::size_t faceCount) {
		std::size_t size = 16;
		while (size < faceCount / 2) {
			size *= 2;
		}
		words_.assign(size, 0);
	}

	bool has(const Triangle& t) const {
		const Bits bits = bitsOf(t);
		return (words_[bits.word] & bits.mask) == bits.mask;
	}

	// \return whether the face's bits had been set before
	bool add(const Triangle& t) {
		const Bits bits = bitsOf(t);
		const bool had = (words_[bits.word] & bits.mask) == bits.mask;
		words_[bits.word] |= bits.mask;
		return had;
	}

	void clear() { std::fill(words_.begin(), words_.end(), 0); }

private:
	struct Bits {
		std::size_t word;
		std::uint64_t mask;
	};

	// The same for any order of the corners.
	Bits bitsOf(const Triangle& t) const {
		const std::uint32_t a = t[0].value, b = t[1].value, c = t[2].value;
		const std::uint64_t sum = std::uint64_t{a} + b + c;
		const std::uint64_t hash = (sum << 32 | (a ^ b ^ c)) * 0xd6e8feb86659fd93U;
		constexpr std::uint64_t kOne = 1;
		return {static_cast<std::size_t>(sum / 3) & (words_.size() - 1),
		        kOne << (hash >> 58) | kOne << (hash >> 52 & 63)};
	}

	std::vector<std::uint64_t> words_;
};

// The duplicates of one operand: faces of the arrays, in no order.
struct Duplicates {
	std::vector<std::uint32_t> cancelling;  // pairs of opposite faces
	std::vector<std::uint32_t> firsts;      // the first of each set of equal faces
	std::vector<std::uint32_t> repeated;    // the others of these sets
};

// Faces that may be duplicates, by corners, then by index.
std::vector<SuspectFace> suspects(const MeshArrays& mesh, OperandId operand, Monitor& monitor) {
	const std::uint32_t begin = mesh.faceOffsets.begin(operand),
	                    end = mesh.faceOffsets.end(operand);
	FaceFilter filter(end - begin);
	std::vector<std::uint32_t> repeated;
	std::vector<SuspectFace> result;
	// \return false if the run is cancelled
	const auto forEachFace = [&](auto&& look) {
		for (std::uint32_t face = begin; face < end; ++face) {
			if ((face - begin) % kGrain == 0 && pollCancelled(monitor)) {
				return false;
			}
			look(face);
		}
		return true;
	};
	const bool isSeen = forEachFace([&](std::uint32_t face) {
		if (filter.add(mesh.triangles[face])) {
			repeated.push_back(face);
		}
	});
	if (repeated.empty() || !isSeen) {
		return result;
	}
	filter.clear();
	for (const std::uint32_t face : repeated) {
		filter.add(mesh.triangles[face]);
	}
	const bool isDone = forEachFace([&](std::uint32_t face) {
		if (filter.has(mesh.triangles[face])) {
			result.push_back({faceKeyOf(mesh.triangles[face]), face});
		}
	});
	if (!isDone) {
		return result;
	}
	std::sort(result.begin(), result.end(), [](const SuspectFace& p, const SuspectFace& q) {
		return p.key != q.key ? p.key < q.key : p.face < q.face;
	});
	return result;
}

// Takes the faces [begin, end) on the same corners: of each opposite pair the later faces go, of
// what is left all but the first are repeated.
void judge(const SuspectFace* begin, const SuspectFace* end, Duplicates& out) {
	const auto forward =
	    std::count_if(begin, end, [](const SuspectFace& f) { return f.key.ascending; });
	const auto backward = end - begin - forward;
	const bool majority = forward >= backward;
	const auto left = std::max(forward, backward) - std::min(forward, backward);
	auto keep = left;
	for (; begin != end; ++begin) {
		if (begin->key.ascending != majority || keep == 0) {
			out.cancelling.push_back(begin->face);
			continue;
		}
		if (left > 1) {
			(keep == left ? out.firsts : out.repeated).push_back(begin->face);
		}
		--keep;
	}
}

// Takes the faces [begin, end) on the same corners: all but one of them are repeated. If they are
// turned both ways, it is one that runs through its corners in lexicographic order.
void takeOnce(const MeshArrays& mesh, const SuspectFace* begin, const SuspectFace* end,
              Duplicates& out) {
	const auto isAscending = [&mesh](const SuspectFace& f) {
		const Triangle& t = mesh.triangles[f.face];
		std::array<Point, 3> c{at(mesh.points, t[0]), at(mesh.points, t[1]), at(mesh.points, t[2])};
		std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
		return c[1] < c[2];
	};
	const SuspectFace* const ascending = std::find_if(begin, end, isAscending);
	const SuspectFace* const kept = ascending == end ? begin : ascending;
	for (const SuspectFace* f = begin; f != end; ++f) {
		(f == kept ? out.firsts : out.repeated).push_back(f->face);
	}
}

// Calls judgeFaces(begin, end, out) for all faces of an operand on the same corners.
template <class JudgeFaces>
void findDuplicates(const MeshArrays& mesh, OperandId operand, Monitor& monitor,
                    JudgeFaces&& judgeFaces, Duplicates& out) {
	const std::vector<SuspectFace> faces = suspects(mesh, operand, monitor);
	forEachGroup(
	    faces.data(), faces.data() + faces.size(),
	    [](const SuspectFace& p, const SuspectFace& q) { return p.key == q.key; },
	    [&](const SuspectFace* first, const SuspectFace* last) {
		    if (last - first > 1) {
			    judgeFaces(first, last, out);
		    }
	    });
}

// The same for both operands, each on a thread.
template <class JudgeFaces>
Status findAllDuplicates(const Arrangement& arrangement, Monitor& monitor, JudgeFaces&& judgeFaces,
                         PerOperand<Duplicates>& out) {
	const MeshArrays& mesh = arrangement.mesh;
	const int threads = threadsForHalves(mesh.triangles.size(), arrangement.options.threads);
	return parallelFor(out.size(), 1, threads, monitor, [&](std::size_t begin, std::size_t end) {
		for (std::size_t k = begin; k < end; ++k) {
			const auto operand = makeId<OperandTag>(k);
			findDuplicates(mesh, operand, monitor, judgeFaces, out[operand]);
		}
	});
}

// Equal faces without which the operand is open: the winding numbers on their two sides differ by
// two or more, so the operand overlaps itself on one of them.
Status refuse(const Arrangement& arrangement, OperandId operand, const Duplicates& duplicates) {
	const MeshArrays& mesh = arrangement.mesh;
	const std::uint32_t first = duplicates.firsts.front();
	std::vector<FaceId> faces;
	for (const auto* list : {&duplicates.firsts, &duplicates.repeated}) {
		for (const std::uint32_t face : *list) {
			faces.push_back({face});
		}
	}
	return selfIntersecting(arrangement, operand, faces, at(mesh.points, mesh.triangles[first][0]));
}

// Decides whether the repeated faces of an operand go, stay because the operand is open anyway, or
// mean that it overlaps itself, as a soup's operand may. Cancelling faces make no difference to
// closedness.
Status judgeRepeated(const Arrangement& arrangement, OperandId operand, Monitor& monitor,
                     Duplicates& duplicates) {
	if (duplicates.repeated.empty()) {
		return {};
	}
	const MeshArrays& mesh = arrangement.mesh;
	const Triangle* triangles = mesh.triangles.data();
	Triangles repeated;
	for (const std::uint32_t face : duplicates.repeated) {
		repeated.push_back(triangles[face]);
	}
	std::uint64_t all = 0, ofRepeated = 0;
	const int threads = arrangement.options.threads;
	Status status =
	    boundaryChecksum(triangles + mesh.faceOffsets.begin(operand),
	                     triangles + mesh.faceOffsets.end(operand), threads, monitor, all);
	if (status.ok()) {
		status = boundaryChecksum(repeated.data(), repeated.data() + repeated.size(), threads,
		                          monitor, ofRepeated);
	}
	if (!status.ok() || all == ofRepeated) {
		return status;
	}
	if (all == 0 && !arrangement.isSoup) {
		return refuse(arrangement, operand, duplicates);
	}
	duplicates.repeated.clear();
	return status;
}

// Drops faces, in any order, from the arrays. \return Ok
Status drop(std::vector<std::uint32_t> faces, Arrangement& arrangement) {
	if (faces.empty()) {
		return {};
	}
	std::sort(faces.begin(), faces.end());
	MeshArrays& mesh = arrangement.mesh;
	std::vector<std::uint32_t> given;
	given.reserve(mesh.triangles.size() - faces.size());
	auto dropped = faces.begin();
	OperandOffsets offsets(mesh.operands().count());
	for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
		if (dropped != faces.end() && *dropped == face) {
			++dropped;
			continue;
		}
		mesh.triangles[given.size()] = mesh.triangles[face];
		if (!mesh.faux.empty()) {
			mesh.faux[given.size()] = mesh.faux[face];
		}
		given.push_back(arrangement.givenFace({face}));
		offsets.setEnd(mesh.operandOf({face}), given.size());
	}
	mesh.triangles.resize(given.size());
	mesh.faux.resize(mesh.faux.empty() ? 0 : given.size());
	mesh.faceOffsets = std::move(offsets);
	arrangement.faceGiven = std::move(given);
	return {};
}

}  // namespace

Status removeDuplicateFaces(Arrangement& arrangement, Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	PerOperand<Duplicates> found(mesh.operands().count());
	std::vector<std::uint32_t> faces;
	const auto judgeOperand = [&](OperandId operand) {
		const Status status = judgeRepeated(arrangement, operand, monitor, found[operand]);
		std::vector<std::uint32_t>& cancelling = found[operand].cancelling;
		const std::vector<std::uint32_t>& repeated = found[operand].repeated;
		if (cancelling.size() == mesh.faceOffsets.size(operand)) {
			cancelling.clear();
		}
		arrangement.duplicates.cancelledPairs[operand] = cancelling.size() / 2;
		arrangement.duplicates.takenOnce[operand] = repeated.size();
		faces.insert(faces.end(), cancelling.begin(), cancelling.end());
		faces.insert(faces.end(), repeated.begin(), repeated.end());
		return status;
	};
	const Status status =
	    inOrder([&] { return findAllDuplicates(arrangement, monitor, judge, found); },
	            [&] { return forEachOperand(mesh.operands(), judgeOperand); });
	return status.ok() ? drop(std::move(faces), arrangement) : status;
}

Status takeRepeatedFacesOnce(Arrangement& arrangement, Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	PerOperand<Duplicates> found(mesh.operands().count());
	std::vector<std::uint32_t> faces;
	const auto judgeOperand = [&](OperandId operand) {
		if (arrangement.closed[operand]) {
			return Status{};
		}
		const Status status = judgeRepeated(arrangement, operand, monitor, found[operand]);
		const std::vector<std::uint32_t>& repeated = found[operand].repeated;
		arrangement.duplicates.takenOnce[operand] = repeated.size();
		arrangement.closed[operand] = !repeated.empty();
		faces.insert(faces.end(), repeated.begin(), repeated.end());
		return status;
	};
	const Status status =
	    inOrder([&] { return findAllDuplicates(arrangement, monitor, judge, found); },
	            [&] { return forEachOperand(mesh.operands(), judgeOperand); });
	return status.ok() ? drop(std::move(faces), arrangement) : status;
}

Status takeDuplicateFacesOnce(Arrangement& arrangement, Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	const auto judgeFaces = [&mesh](const SuspectFace* begin, const SuspectFace* end,
	                                Duplicates& out) { takeOnce(mesh, begin, end, out); };
	PerOperand<Duplicates> found(mesh.operands().count());
	const Status status = findAllDuplicates(arrangement, monitor, judgeFaces, found);
	std::vector<std::uint32_t> faces;
	if (!status.ok()) {
		return status;
	}
	for (const OperandId operand : mesh.operands()) {
		const std::vector<std::uint32_t>& repeated = found[operand].repeated;
		arrangement.duplicates.takenOnce[operand] = repeated.size();
		faces.insert(faces.end(), repeated.begin(), repeated.end());
	}
	return drop(std::move(faces), arrangement);
}

std::size_t cancellingPairs(const MeshArrays& mesh, OperandId operand, bool inAnyWay) {
	std::vector<FaceKey<VertexId>> keys;
	for (std::uint32_t f = mesh.faceOffsets.begin(operand); f < mesh.faceOffsets.end(operand);
	     ++f) {
		keys.push_back(faceKeyOf(mesh.triangles[f]));
	}
	std::sort(keys.begin(), keys.end());
	bool areAll = true;
	forEachGroup(keys.begin(), keys.end(), std::equal_to<>(), [&](auto first, auto last) {
		const auto ascending =
		    std::count_if(first, last, [](const auto& k) { return k.ascending; });
		areAll = areAll && (inAnyWay ? (last - first) % 2 == 0 : 2 * ascending == last - first);
	});
	return areAll ? keys.size() / 2 : 0;
}

}  // namespace index_boolean
