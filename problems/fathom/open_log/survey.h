// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Whether a log can identify a DOF.
struct SurveyedDof {
  Dof dof = Dof::kSurge;
  std::string why_not;    // empty: it can
  bool may_help = false;  // together with other logs it may, though not alone
};

// A DOF that moves though the log cannot identify it: nothing drives it, or log.yaml leaves it out.
struct UndrivenDof {
  Dof dof = Dof::kSurge;
  std::string why;  // "moves by 0.05 rad/s, and nothing commands it."
};

// What a batch has to know of a log before it runs the programs on it.
struct Survey {
  std::string dive;                                            // as log.yaml says; may be empty
  std::string vehicle;                                         // likewise
  double start = std::numeric_limits<double>::quiet_NaN();     // [s since 1970]: log.yaml's, or the
                                                               // first stamp where that is an epoch
  double duration = std::numeric_limits<double>::quiet_NaN();  // of the motion, or the command [s]
  bool needs_tracking = false;    // its motion is in images only: fathom_track comes first
  std::vector<SurveyedDof> dofs;  // those that log.yaml names, else those that are commanded
  std::vector<UndrivenDof> undriven;
};

// Looks at the command and the motion of each DOF. A DOF cannot be identified where its motion
// never changes or is no more than white noise, or less than 20 samples or 3 s of it are there.
// Where the command never changes it cannot either, but several such logs with different commands
// can. Undriven are the DOFs whose column of velocity.csv is more than white noise, and that have
// no command but 0, or are not among `dofs`.
//
// `dof`: of a single CSV. `default_vehicle` as in OpenLog(); Survey::vehicle stays what log.yaml
// says, or empty. Throws InputError as OpenLog() does.
Survey SurveyLog(const std::filesystem::path& path,
                 std::optional<Dof> dof,
                 const std::filesystem::path& default_vehicle = {});

// The same of a log that was opened already, with what it holds out.
Survey SurveyOf(Log log);

// As JSON, schema "fathom-survey-1", and back. ParseSurvey throws InputError if it is none.
std::string FormatSurvey(const Survey& survey);
Survey ParseSurvey(std::string_view text);

}  // namespace fathom
