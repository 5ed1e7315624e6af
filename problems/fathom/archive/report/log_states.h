// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// The states of logs as sentences tell them, from "ok" on, in the order in which they are told.
const std::vector<std::string>& StatesInOrder();

// Whether a log of this state gave a model of at least one DOF. A state that is not known did not.
bool GivesModel(std::string_view state);

// "nothing to identify" of "nothing_to_identify".
std::string StateText(std::string_view state);

// What the state means, for the heading of a list: "The program stopped with an error of its own."
// Empty if the state is not known.
std::string_view StateMeaning(std::string_view state);

}  // namespace fathom
