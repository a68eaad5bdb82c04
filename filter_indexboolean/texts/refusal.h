// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a run ends that gives no layers: inside this folder as an exception with the user's sentence;
// each host's adapter turns it into what the host shows.
#pragma once

#include "texts/messages.h"

#include <stdexcept>
#include <string>

namespace index_boolean {

class Refusal : public std::runtime_error {
public:
	using std::runtime_error::runtime_error;
};

// The sentence for the exception that is being handled: a refusal's own, or that of an error which
// no input should lead to. To be called in a catch clause.
inline std::string messageOfCaught() {
	try {
		throw;
	} catch (const Refusal& refusal) {
		return refusal.what();
	} catch (const std::exception& error) {
		return unexpectedMessage(error.what());
	} catch (...) {
		return unexpectedMessage("unknown exception");
	}
}

}  // namespace index_boolean
