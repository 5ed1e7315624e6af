// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/log_states.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fathom {
namespace {

using Entry = std::pair<std::string_view, std::string_view>;

constexpr std::array<Entry, 11> kStates = {{
    {"ok", "Every DOF that was excited has a model."},
    {"partial", "Some of the DOFs that were excited have a model."},
    {"nothing_to_identify", "The log holds no stretch that could identify a DOF."},
    {"no_map", "The recording needs a map that says what its channels are."},
    {"no_model", "No fit of the log is usable."},
    {"refused", "The checks of the data refused the log."},
    {"crashed", "A program ended abnormally on the log."},
    {"timed_out", "A program took longer than it was allowed to."},
    {"out_of_memory", "A program needed more memory than it was allowed to."},
    {"unreadable", "The files of the log could not be read."},
    {"duplicate", "The log holds the same data as another log, which is counted instead."},
}};

}  // namespace

const std::vector<std::string>& StatesInOrder() {
  static const std::vector<std::string> states = [] {
    std::vector<std::string> names;
    names.reserve(kStates.size());
    for (const auto& [name, meaning] : kStates) names.emplace_back(name);
    return names;
  }();
  return states;
}

bool GivesModel(std::string_view state) { return state == "ok" || state == "partial"; }

std::string StateText(std::string_view state) {
  std::string text(state.empty() ? "no state" : state);
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string_view StateMeaning(std::string_view state) {
  const auto found = std::ranges::find(kStates, state, &Entry::first);
  return found == kStates.end() ? "" : found->second;
}

}  // namespace fathom
