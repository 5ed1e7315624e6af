// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/left_out_dofs.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

const DofCheckup* FindEvenWithoutModel(const LogCheckup& checkup, Dof dof) {
  const auto found = std::ranges::find(checkup.dofs, dof, &DofCheckup::dof);
  return found == checkup.dofs.end() ? nullptr : &*found;
}

std::string ReasonOf(const LogCheckup& checkup, Dof dof) {
  const DofCheckup* const of_dof = FindEvenWithoutModel(checkup, dof);
  if (of_dof == nullptr) {
    return checkup.log.dofs.empty() ? "no command." : "log.yaml does not name it.";
  }
  if (!of_dof->why_not.empty()) return of_dof->why_not;
  return fmt::format("no usable model: {}", of_dof->model ? of_dof->model->message : "");
}

}  // namespace

std::vector<std::string> LeftOutDofs(std::span<const CheckedLog> logs) {
  std::vector<std::string> sentences;
  for (const Dof dof : kAllDofs) {
    const bool is_of_a_log = std::ranges::any_of(logs, [dof](const CheckedLog& log) {
      return FindEvenWithoutModel(log.checkup, dof) != nullptr;
    });
    if (!is_of_a_log) continue;
    std::vector<std::string> reasons;
    for (const CheckedLog& log : logs) {
      if (FindDof(log.checkup, dof) != nullptr) continue;
      reasons.push_back(fmt::format("{}: {}", log.path, ReasonOf(log.checkup, dof)));
    }
    if (reasons.empty()) continue;
    const std::size_t num_models = logs.size() - reasons.size();
    sentences.push_back(fmt::format(
        "{} is not compared{}. {}",
        Name(dof),
        num_models < 2 ? ": that takes two logs that give a model of it" : " in all logs",
        fmt::join(reasons, " ")));
  }
  return sentences;
}

}  // namespace fathom
