// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

namespace fathom {

// The folder that the running program lies in, where Fathom's other programs are too. Empty where
// the system does not say.
std::filesystem::path ProgramsFolder();

}  // namespace fathom
