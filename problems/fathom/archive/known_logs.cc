// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/known_logs.h"

#include "fathom/base/input_error.h"

#include <filesystem>
#include <string>
#include <system_error>

namespace fathom {

KnownLog KnownLogOf(const LogOutcome& outcome, const std::vector<BatchDof>& dofs) {
  KnownLog known;
  known.row = {.log = outcome.path,
               .status = std::string(Name(outcome.state)),
               .survey = outcome.survey ? FormatSurvey(*outcome.survey) : "",
               .made_by = outcome.made_by};
  for (const BatchDof& dof : dofs) {
    known.dofs.push_back(
        {outcome.path, std::string(Name(dof.dof)), dof.why_left_out, dof.own_nmae});
  }
  return known;
}

std::optional<LogOutcome> OutcomeOf(const KnownLog& known,
                                    const HashedLog& log,
                                    const LogJobOptions& options) {
  const std::optional<LogState> state = LogStateFromName(known.row.status);
  if (!state) return std::nullopt;
  LogOutcome outcome = OutcomeOfFound(log.log, log.content);
  outcome.state = *state;
  if (!known.row.made_by.empty()) {
    TakeMadeLog(known.row.made_by, options, &outcome);
    std::error_code error;
    if (!std::filesystem::is_directory(outcome.place, error)) return std::nullopt;
  }
  try {
    if (!known.row.survey.empty()) outcome.survey = ParseSurvey(known.row.survey);
  } catch (const InputError&) {
    return std::nullopt;
  }
  return outcome;
}

std::vector<BatchDof> DofsOf(const KnownLog& known) {
  std::vector<BatchDof> dofs;
  for (const KnownDofRow& row : known.dofs) {
    dofs.push_back({ParseDof(row.dof), row.why_left_out, row.own_nmae});
  }
  return dofs;
}

}  // namespace fathom
