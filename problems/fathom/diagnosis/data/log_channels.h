// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/log/sampled_signal.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// What is measured along one DOF of one log, uncut.
struct LogChannels {
  const Log* log = nullptr;
  std::string name;  // which no other of the logs has
  std::optional<SampledSignal> velocity, displacement;
  std::vector<std::string> remarks;
};

// Of each of the logs, named by `names`. Throws InputError if one measures nothing along `dof`, or
// if their command units differ.
std::vector<LogChannels> ChannelsOf(std::span<const Log> logs,
                                    const std::vector<std::string>& names,
                                    Dof dof);

// Whether the displacement is short of the motion, as a remark of the log says (kLostMotion).
bool LosesMotion(const LogChannels& channels);

}  // namespace fathom
