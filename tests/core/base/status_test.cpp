// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statuses in words.
#include <vcg_ext/base/status.h>

#include <gtest/gtest.h>

#include <locale>
#include <set>

using namespace index_boolean;

namespace {

Status makeStatus(StatusCode code, std::size_t count) {
	Status status;
	status.code = code;
	status.count = count;
	return status;
}

Status makeStatus(StatusCode code, std::size_t count, Point place) {
	Status status = makeStatus(code, count);
	status.hasPlace = true;
	status.place = place;
	return status;
}

class CommaForPoint : public std::numpunct<char> {
protected:
	char do_decimal_point() const override { return ','; }
	char do_thousands_sep() const override { return '.'; }
	std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST(Status, everyCodeHasItsOwnNameAndSentence) {
	std::set<std::string> names, sentences;
	for (int code = 0; code < kStatusCodeCount; ++code) {
		const auto status = makeStatus(static_cast<StatusCode>(code), 0);
		names.insert(statusName(status.code));
		sentences.insert(describe(status));
		EXPECT_NE(describe(status), "");
	}
	EXPECT_EQ(names.size(), static_cast<std::size_t>(kStatusCodeCount));
	EXPECT_EQ(sentences.size(), static_cast<std::size_t>(kStatusCodeCount));
	EXPECT_STREQ(statusName(StatusCode::Ok), "ok");
	EXPECT_STREQ(statusName(StatusCode::NotClosed), "not closed");
	EXPECT_STREQ(statusName(StatusCode::InternalError), "internal error");
}

TEST(Status, sentenceNamesDefectCountAndPlace) {
	EXPECT_EQ(describe(makeStatus(StatusCode::NotClosed, 12, {0, 1, 2})),
	          "is not closed: 12 edges have a face on one side only, the first near (0, 1, 2)");
	EXPECT_EQ(describe(makeStatus(StatusCode::EmptyOperand, 0)),
	          "has no face that encloses anything");
}

TEST(Status, oneDefectIsSingular) {
	EXPECT_EQ(describe(makeStatus(StatusCode::NotClosed, 1, {0, 1, 2})),
	          "is not closed: 1 edge has a face on one side only, near (0, 1, 2)");
	EXPECT_EQ(describe(makeStatus(StatusCode::NotFinite, 1)),
	          "has coordinates that are not finite numbers: 1 face has a corner there");
}

TEST(Status, placeHasSixSignificantDigits) {
	const std::string text =
	    describe(makeStatus(StatusCode::SelfIntersecting, 0, {1.0 / 3, -123456.789, 1e-30}));
	EXPECT_EQ(text, "intersects itself, near (0.333333, -123457, 1e-30)");
}

TEST(Status, textDoesNotDependOnTheLocale) {
	const Status status = makeStatus(StatusCode::NotOriented, 12345, {0.5, 1234.5, 0});
	const std::string text = describe(status);
	const std::locale before =
	    std::locale::global(std::locale(std::locale::classic(), new CommaForPoint));
	EXPECT_EQ(describe(status), text);
	std::locale::global(before);
}
