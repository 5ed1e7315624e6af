// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace fathom {

// A script that completes `fathom <command>` and `fathom_<command>` in a shell: the commands, the
// flags, which it asks of the program with --flags, and file names as their values.
//
// The text is for bash 4 or zsh 5, to be sourced; that for zsh also works as a file _fathom in
// $fpath.
std::string BashCompletion(const std::vector<std::string>& commands);
std::string ZshCompletion(const std::vector<std::string>& commands);

}  // namespace fathom
