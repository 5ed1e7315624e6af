// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// The first lines of a plan's experiment.yaml: name, duration [s] and the rate of its command, of
// which a force lasts `hold` [s].
std::string ExperimentHead(std::string_view name, double duration, double hold);

}  // namespace fathom
