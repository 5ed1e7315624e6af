// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "test_folder.h"  // for whoever runs a program

namespace fathom {

// What a program did.
struct ToolRun {
  int exit_code = -1;        // 128 plus the signal's number if a signal ended it
  std::string out;           // all of its stdout
  std::string err;           // all of its stderr
  double peak_memory = 0.0;  // resident, at most [bytes]
};

// Runs a program of the build's tools/ folder to its end, without a shell; stdin is empty.
//
//   const ToolRun run = RunToolBinary("fathom_synthesize", {"--seed=1", "--out=" + folder});
//
// `on_start` is called with its process id.
ToolRun RunToolBinary(const std::string& name,
                      const std::vector<std::string>& arguments,
                      const std::function<void(int)>& on_start = {});

// The same of a program that has to end with exit code 0: else the test fails and ends here, with
// what it said on stderr.
ToolRun RunsWell(const std::string& name, const std::vector<std::string>& arguments);
ToolRun RunsWell(const ToolRun& run);

// As RunToolBinary, with the file `input` as stdin.
ToolRun RunToolBinaryOn(const std::filesystem::path& input,
                        const std::string& name,
                        const std::vector<std::string>& arguments);

// "--log=/a/b" of "log" and a path.
std::string Flag(const std::string& name, const std::filesystem::path& value);

// Writes a file, creating its folder, and gives its path back.
std::filesystem::path WriteTestFile(const std::filesystem::path& path, const std::string& text);

}  // namespace fathom
