// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/files/yaml_file.h"
#include "fathom/synthesize/experiment/input_signal.h"

namespace fathom {

// Reads one input of an experiment file (docs/file_formats.md); frequencies and holding times are
// such that a command stream of `command_rate` [Hz] can carry them. Throws InputError, naming file,
// line and key, for whatever breaks the format.
InputSignal ReadInput(const YamlMap& map, double command_rate);

}  // namespace fathom
