// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: pairs. The driver of the search: a frame of floats, stars certified by floats,
// then by doubles, an order, a pyramid, its descent; what that leaves is judged where it is found.
#include "vcg_ext/arrange/wrong_pairs.h"

#include "vcg_ext/arrange/near_faces.h"
#include "vcg_ext/arrange/open_stars.h"
#include "vcg_ext/arrange/pyramid_descent.h"
#include "vcg_ext/arrange/unbalanced_vertices.h"
#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/sorted_list.h"

#include <algorithm>
#include <mutex>
#include <new>

namespace index_boolean {

namespace {

// Lists what it is given.
class PairList : public WrongPairTaker {
public:
	void take(FacePair pair) override {
		const std::lock_guard<std::mutex> lock(mutex_);
		pairs_.push_back(pair);
	}

	// Gives all pairs away in order, each once. \return Ok or Cancelled
	// \param nameOf the index, below a count, by which a face is called
	template <class NameOf>
	Status giveSorted(std::size_t count, int threads, Monitor& monitor, NameOf&& nameOf,
	                  std::vector<FacePair>& out) {
		for (FacePair& pair : pairs_) {
			pair = {{nameOf(pair.a.value)}, {nameOf(pair.b.value)}};
		}
		const auto keyOf = [](const FacePair& pair) { return pair.a.value; };
		const auto before = [](const FacePair& p, const FacePair& q) {
			return p.a != q.a ? p.a < q.a : p.b < q.b;
		};
		const Status status = bucketSort(pairs_, count, keyOf, before, threads, monitor);
		pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
		out = std::move(pairs_);
		return status;
	}

private:
	std::mutex mutex_;
	std::vector<FacePair> pairs_;
};

Status search(const FacesView& faces, const WrongPairOptions& options, Monitor& monitor,
              WrongPairTaker& taker, std::vector<std::uint32_t>& zeroAreaFaces) {
	zeroAreaFaces.clear();
	if (faces.count() == 0) {
		return {};
	}
	SearchedSurface surface{faces, options.threads, options.isSuspect, {}, 0, {}, {}};
	PairJudge judge(faces, monitor, taker);
	WordsLeave left;
	FaceOrder order;
	BoxPyramid pyramid;
	Status status = inOrder(
	    [&] { return placeInFrame(surface, monitor); },
	    [&] { return options.isBalanced ? Status{} : findUnbalancedVertices(surface, monitor); },
	    [&] { return certifyStars(surface, monitor, left); },
	    [&] { return closeStars(left.openStars, monitor, judge, surface); },
	    [&] { return orderFaces(surface, monitor, order); },
	    [&] { return buildPyramid(surface, order, monitor, pyramid); },
	    [&] { return descendPyramid(surface, pyramid, monitor, judge); });
	if (status.ok() && judge.sawContradiction()) {
		status.code = StatusCode::InternalError;
	}
	std::copy_if(left.zeroAreaFaces.begin(), left.zeroAreaFaces.end(),
	             std::back_inserter(zeroAreaFaces),
	             [&surface](std::uint32_t face) { return surface.suspects(face); });
	return status;
}

// The search among the suspect faces and those near them.
Status searchNear(const FacesView& faces, const WrongPairOptions& options, Monitor& monitor,
                  WrongPairs& out) {
	const std::vector<std::uint8_t>& isSuspect = *options.isSuspect;
	std::vector<std::uint32_t> near;
	const Status status = findNearFaces(faces, isSuspect, options.threads, monitor, near);
	if (!status.ok()) {
		return status;
	}
	FacesApart apart;
	copyFaces(faces, near, apart);
	std::vector<std::uint8_t> isSuspectApart(near.size());
	std::transform(near.begin(), near.end(), isSuspectApart.begin(),
	               [&isSuspect](std::uint32_t face) { return isSuspect[face]; });
	PairList list;
	const FacesView view(apart.points, apart.triangles.data(), apart.triangles.size());
	// Among those near suspects not all that is balanced remains so.
	const auto nameOf = [&near](std::uint32_t face) { return near[face]; };
	const Status searched = inOrder(
	    [&] {
		    return search(view, {options.threads, false, &isSuspectApart}, monitor, list,
		                  out.zeroAreaFaces);
	    },
	    [&] {
		    return list.giveSorted(faces.count(), options.threads, monitor, nameOf, out.pairs);
	    });
	std::transform(out.zeroAreaFaces.begin(), out.zeroAreaFaces.end(), out.zeroAreaFaces.begin(),
	               nameOf);
	return searched;
}

// Runs a step without a guard against lack of memory outside of its parallel regions.
template <class Step>
Status guarded(Step&& step) {
	const FpEnvironmentGuard environment;
	try {
		return step();
	} catch (const std::bad_alloc&) {
		return statusOf(StatusCode::OutOfMemory);
	}
}

}  // namespace

std::vector<std::uint32_t> facesConcerned(const WrongPairs& found) {
	std::vector<std::uint32_t> faces = found.zeroAreaFaces;
	for (const FacePair& pair : found.pairs) {
		faces.push_back(pair.a.value);
		faces.push_back(pair.b.value);
	}
	sortUnique(faces);
	return faces;
}

Status findWrongPairs(const FacesView& faces, const WrongPairOptions& options, Monitor& monitor,
                      WrongPairs& out) {
	out = {};
	return guarded([&] {
		PairList list;
		const auto nameOf = [](std::uint32_t face) { return face; };
		return inOrder([&] { return search(faces, options, monitor, list, out.zeroAreaFaces); },
		               [&] {
			               return list.giveSorted(faces.count(), options.threads, monitor, nameOf,
			                                      out.pairs);
		               });
	});
}

Status findWrongPairsNearSuspects(const FacesView& faces, const WrongPairOptions& options,
                                  Monitor& monitor, WrongPairs& out) {
	out = {};
	return guarded([&] { return searchNear(faces, options, monitor, out); });
}

Status visitWrongPairs(const FacesView& faces, const WrongPairOptions& options, Monitor& monitor,
                       WrongPairTaker& taker, std::vector<std::uint32_t>& zeroAreaFaces) {
	return guarded([&] { return search(faces, options, monitor, taker, zeroAreaFaces); });
}

}  // namespace index_boolean
