// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: what there is to know of a document's layers; out: which of them a user names, by id, by
// label, or by the words "visible" and "all". Those words stand for what can be an operand and has
// not been made by this plugin; a layer named by id or label is taken whatever it is.
#pragma once

#include "texts/layer_names.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace index_boolean {

struct ListedLayer {
	LayerName name;     // as it is called in sentences
	std::string label;  // the host's
	bool isVisible, hasFaces;
	bool isResult;  // this plugin has made it
};

enum class LayerSet : std::uint8_t { Visible, All };

// One layer that is named, or why there is none.
struct FoundLayer {
	const ListedLayer* layer;  // nullptr: there is none
	std::string problem;       // then; half a sentence
};

class LayerDirectory {
public:
	// \param layers in the order of the document
	explicit LayerDirectory(std::vector<ListedLayer> layers);

	// The layers that the word stands for. Complexity: O(n) for n layers.
	std::vector<const ListedLayer*> listed(LayerSet set) const;

	// Says which layers a word leaves out that one might have expected; none, or one for each
	// reason.
	std::vector<std::string> leftOutMessages(LayerSet set) const;

	// \param digits of an id. Complexity: O(1).
	FoundLayer byId(const std::string& digits) const;
	FoundLayer byLabel(const std::string& label) const;

private:
	std::vector<ListedLayer> layers_;
	std::unordered_map<int, std::size_t> ofId_;
	std::unordered_map<std::string, std::vector<std::size_t>> ofLabel_;
};

// The word for a set, and whether a word is one.
const char* wordOf(LayerSet set);
bool isLayerSet(const std::string& word, LayerSet& set);

// The layers of a list: one of the words, or ids and labels in double quotes, separated by commas.
// \param parameter the name of the parameter that the text is of
// \param messages  gets what the log is to say of layers left out
// Throws Refusal: it is empty, does not read, names no layer, several, or one twice.
std::vector<LayerName> layersOfList(const char* parameter, const std::string& text,
                                    const LayerDirectory& directory,
                                    std::vector<std::string>& messages);

}  // namespace index_boolean
