// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

// A file name as a shell takes it for one word.
std::string ShellWord(const std::string& word);

// How long the run is that tools advise after a log of so many seconds: 60 to 300 s, of whole tens.
double HintedDuration(double log_duration);

}  // namespace fathom
