// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which layers a list names, what is left out of one, and the place that a refusal shows.
#include <texts/layer_list.h>
#include <texts/refusal.h>
#include <texts/text_place.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

// Ids 2, 3, 5, 7, 9, 11: two of one label, one hidden, one without faces, one that is a result.
LayerDirectory directory() {
	return LayerDirectory({{{"a", 2}, "a", true, true, false},
	                       {{"same", 3}, "same", true, true, false},
	                       {{"hidden", 5}, "hidden", false, true, false},
	                       {{"same", 7}, "same", true, true, false},
	                       {{"points", 9}, "points", true, false, false},
	                       {{"a union b", 11}, "a union b", true, true, true}});
}

std::vector<int> idsOfList(const std::string& text, std::vector<std::string>& messages) {
	std::vector<int> ids;
	for (const LayerName& name : layersOfList("layers", text, directory(), messages)) {
		ids.push_back(name.id);
	}
	return ids;
}

std::string refusalOf(const std::string& text) {
	std::vector<std::string> messages;
	try {
		idsOfList(text, messages);
	} catch (const Refusal& refusal) {
		return refusal.what();
	}
	return "";
}

TEST(LayerList, wordsStandForWhatCanBeAnOperand) {
	std::vector<std::string> messages;
	EXPECT_EQ(idsOfList("visible", messages), (std::vector<int>{2, 3, 7}));
	EXPECT_EQ(idsOfList(" all ", messages), (std::vector<int>{2, 3, 5, 7}));
	ASSERT_EQ(messages.size(), 2U);
	EXPECT_EQ(messages[0].substr(0, 53),
	          "\"all\" leaves out \"points\" (id 9), which has no faces;");
	EXPECT_NE(messages[1].find("\"a union b\" (id 11), which has been made by Index Boolean"),
	          std::string::npos);
}

TEST(LayerList, whatIsNamedIsTakenInItsOrder) {
	std::vector<std::string> messages;
	EXPECT_EQ(idsOfList("11, \"hidden\" ,2", messages), (std::vector<int>{11, 5, 2}));
	EXPECT_TRUE(messages.empty());
}

TEST(LayerList, whatDoesNotReadIsShownByItsPlace) {
	const struct {
		const char *text, *sentence, *caret;
	} cases[] = {
	    {"", "column 1: a layer's id is expected", "^"},
	    {"2 3", "column 3: a comma is missing", "  ^"},
	    {"2,", "column 3: a layer's id is expected", "  ^"},
	    {"2, 2", "column 4: this layer is named twice", "   ^"},
	    {"2, 4", "column 4: there is no layer with id 4.", "   ^"},
	    {"\"same\"",
	     "column 1: several layers have the label \"same\": name one of them by its id, "
	     "3 or 7.",
	     "^"},
	    {"\"b\"", "there is no layer with the label \"b\".", "^"},
	    {"all, 2", "column 4: nothing may stand here", "   ^"},
	    {"2, visible", "column 4: a layer's id is expected", "   ^"},
	};
	for (const auto& c : cases) {
		const std::string refusal = refusalOf(c.text);
		EXPECT_NE(refusal.find(c.sentence), std::string::npos) << refusal;
		EXPECT_EQ(refusal.substr(refusal.rfind('\n') + 1), c.caret) << refusal;
		EXPECT_NE(refusal.find(std::string("\n") + c.text + "\n"), std::string::npos) << refusal;
	}
	std::vector<std::string> messages;
	EXPECT_THROW(layersOfList("layers", "all", LayerDirectory({}), messages), Refusal);
}

TEST(TextPlace, columnsCountCharactersAndLongLinesAreCut) {
	EXPECT_EQ(messageAtPlace("Text", "\xc3\xbc\tx\ny", 4, "no."),
	          "Text, line 1, column 4: no.\n\xc3\xbc x\n   ^");
	EXPECT_EQ(messageAtPlace("Text", "\xc3\xbc\nab", 4, "no."),
	          "Text, line 2, column 2: no.\nab\n ^");
	const std::string text = std::string(100, 'a') + "!" + std::string(100, 'b');
	EXPECT_EQ(messageAtPlace("Text", text, 100, "no."),
	          "Text, line 1, column 101: no.\n..." + std::string(60, 'a') + "!" +
	              std::string(39, 'b') + "...\n" + std::string(63, ' ') + "^");
	EXPECT_EQ(shortened("\xc3\xbc\xc3\xbc\xc3\xbc", 3), "\xc3\xbc\xc3\xbc\xc3\xbc");
	EXPECT_EQ(shortened("\xc3\xbc\xc3\xbc\xc3\xbc", 2), "\xc3\xbc\xe2\x80\xa6");
}

}  // namespace
}  // namespace index_boolean
