// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/free_decay/log_decay.h"
#include "fathom/log/log.h"
#include "fathom/report/page.h"

#include <span>
#include <string>

namespace fathom {

// Where a tool writes what it says of a free decay.
struct FreeDecayOutputs {
  std::string lacks;  // what the tool gives otherwise: "no diagnosis"
  std::string logs;   // as the user names them
  std::string json;   // a file; empty: none
  std::string page;   // a file; empty: none
  PageOrigin origin;  // of the page
};

// What a tool for models says of logs that nothing drives, in place of a model: the ratios that
// their decay tells, to stdout and into the files. The exit code of the tool: kExitNoFit where
// nothing decays, and then no JSON.
int TellFreeDecay(std::span<const Log> logs,
                  const LogDecay& decay,
                  const FreeDecayOutputs& outputs);

}  // namespace fathom
