// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <string>

namespace fathom {

// What log.yaml says about a log: everything in Log but the streams, with corrections that
// are not yet made. `name` stands for the file in messages. Throws InputError, naming file, line
// and key.
Log ParseLogYaml(const std::string& name, const std::string& text);

}  // namespace fathom
