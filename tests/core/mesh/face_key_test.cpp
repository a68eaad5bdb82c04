// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A face's key: one for all orders of its corners, with the way round it.
#include <vcg_ext/mesh/face_key.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace index_boolean;

TEST(FaceKey, isOneForAllOrdersOfTheCorners) {
	std::array<VertexId, 3> t{VertexId{2}, VertexId{5}, VertexId{9}};
	const FaceKey<VertexId> key = faceKeyOf(t);
	int ascending = 0;
	do {
		EXPECT_EQ(faceKeyOf(t), key);
		EXPECT_EQ(hashOf(faceKeyOf(t)), hashOf(key));
		const bool isRotation = (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
		EXPECT_EQ(faceKeyOf(t).ascending, isRotation);
		ascending += isRotation ? 1 : 0;
	} while (std::next_permutation(t.begin(), t.end()));
	EXPECT_EQ(ascending, 3);
	EXPECT_NE(faceKeyOf(std::array<std::uint32_t, 3>{2, 5, 8}),
	          faceKeyOf(std::array<std::uint32_t, 3>{2, 5, 9}));
}
