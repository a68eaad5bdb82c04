// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words of a list are those of expressions (expression_tokens.h of the core).
#include "texts/layer_list.h"

#include "texts/messages.h"
#include "texts/refusal.h"
#include "texts/text_place.h"

#include <algorithm>
#include <charconv>
#include <set>

namespace index_boolean {

namespace {

constexpr std::array<const char*, 2> kWords{{"visible", "all"}};

bool isOf(LayerSet set, const ListedLayer& layer) {
	return set == LayerSet::All || layer.isVisible;
}

}  // namespace

const char* wordOf(LayerSet set) { return kWords[static_cast<std::size_t>(set)]; }

bool isLayerSet(const std::string& word, LayerSet& set) {
	const auto found = std::find(kWords.begin(), kWords.end(), word);
	set = found == kWords.begin() ? LayerSet::Visible : LayerSet::All;
	return found != kWords.end();
}

LayerDirectory::LayerDirectory(std::vector<ListedLayer> layers) : layers_(std::move(layers)) {
	for (std::size_t i = 0; i < layers_.size(); ++i) {
		ofId_.emplace(layers_[i].name.id, i);
		ofLabel_[layers_[i].label].push_back(i);
	}
}

std::vector<const ListedLayer*> LayerDirectory::listed(LayerSet set) const {
	std::vector<const ListedLayer*> all;
	for (const ListedLayer& layer : layers_) {
		if (isOf(set, layer) && layer.hasFaces && !layer.isResult) {
			all.push_back(&layer);
		}
	}
	return all;
}

std::vector<std::string> LayerDirectory::leftOutMessages(LayerSet set) const {
	std::vector<LayerName> empty, results;
	for (const ListedLayer& layer : layers_) {
		if (isOf(set, layer) && (!layer.hasFaces || layer.isResult)) {
			(layer.hasFaces ? results : empty).push_back(layer.name);
		}
	}
	std::vector<std::string> messages;
	if (!empty.empty()) {
		messages.push_back(leftOutMessage(wordOf(set), empty, "no faces"));
	}
	if (!results.empty()) {
		messages.push_back(leftOutMessage(wordOf(set), results, "been made by Index Boolean"));
	}
	return messages;
}

FoundLayer LayerDirectory::byId(const std::string& digits) const {
	int id = -1;
	const char* const end = digits.data() + digits.size();
	const bool isNumber = std::from_chars(digits.data(), end, id).ec == std::errc();
	const auto found = isNumber ? ofId_.find(id) : ofId_.end();
	if (found == ofId_.end()) {
		return {nullptr, "there is no layer with id " + digits};
	}
	return {&layers_[found->second], {}};
}

FoundLayer LayerDirectory::byLabel(const std::string& label) const {
	const auto found = ofLabel_.find(label);
	if (found == ofLabel_.end()) {
		return {nullptr, "there is no layer with the label \"" + label + "\""};
	}
	if (found->second.size() > 1) {
		std::vector<int> ids;
		for (const std::size_t i : found->second) {
			ids.push_back(layers_[i].name.id);
		}
		return {nullptr, severalLayersProblem(label, ids)};
	}
	return {&layers_[found->second.front()], {}};
}

namespace {

class ListReader {
public:
	ListReader(const char* parameter, const std::string& text, const LayerDirectory& directory)
	    : parameter_(parameter), text_(text), directory_(directory), tokens_(tokensOf(text)) {}

	std::vector<LayerName> read(std::vector<std::string>& messages) {
		LayerSet set{};
		if (tokens_[0].kind == TokenKind::Name && isLayerSet(tokens_[0].text, set)) {
			next_ = 1;
			expectEnd();
			readSet(set, messages);
		} else {
			readItems();
		}
		return std::move(layers_);
	}

private:
	[[noreturn]] void refuse(const Token& token, const std::string& problem) const {
		throw Refusal(messageAtPlace(parameter_, text_, token.begin, problem));
	}

	void expectEnd() const {
		if (tokens_[next_].kind != TokenKind::End) {
			refuse(tokens_[next_], "nothing may stand here.");
		}
	}

	void readSet(LayerSet set, std::vector<std::string>& messages) {
		messages = directory_.leftOutMessages(set);
		for (const ListedLayer* layer : directory_.listed(set)) {
			layers_.push_back(layer->name);
		}
		if (layers_.empty()) {
			refuse(tokens_[0], emptySetProblem(wordOf(set)) + ".");
		}
	}

	void readItems() {
		for (;; ++next_) {
			readItem(tokens_[next_++]);
			if (!tokens_[next_].is(',')) {
				break;
			}
		}
		if (tokens_[next_].kind != TokenKind::End) {
			refuse(tokens_[next_], "a comma is missing here, or this is too much.");
		}
	}

	void readItem(const Token& token) {
		if (token.kind != TokenKind::Digits && token.kind != TokenKind::Label) {
			refuse(token, "a layer's id is expected here, or its label in double quotes; or "
			              "\"visible\" or \"all\" alone.");
		}
		const FoundLayer found = token.kind == TokenKind::Digits ? directory_.byId(token.text)
		                                                         : directory_.byLabel(token.text);
		if (found.layer == nullptr) {
			refuse(token, found.problem + ".");
		}
		if (!taken_.insert(found.layer->name.id).second) {
			refuse(token, "this layer is named twice.");
		}
		layers_.push_back(found.layer->name);
	}

	const char* parameter_;
	const std::string& text_;
	const LayerDirectory& directory_;
	std::vector<Token> tokens_;
	std::size_t next_ = 0;
	std::set<int> taken_;
	std::vector<LayerName> layers_;
};

}  // namespace

std::vector<LayerName> layersOfList(const char* parameter, const std::string& text,
                                    const LayerDirectory& directory,
                                    std::vector<std::string>& messages) {
	return ListReader(parameter, text, directory).read(messages);
}

}  // namespace index_boolean
