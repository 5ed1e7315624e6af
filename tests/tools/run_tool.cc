// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "run_tool.h"

#include "fathom/process/run_child.h"

#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

namespace fathom {

namespace {

std::string BinaryOf(const std::string& name) {
  return fmt::format("{}/{}", FATHOM_TOOLS_DIR, name);
}

ToolRun RunOf(const ChildCommand& command) {
  const ChildResult result = RunChild(command);
  if (result.end == ChildEnd::kNotStarted) {
    throw std::runtime_error("cannot run " + command.program + ": " + result.err);
  }
  return {.exit_code = result.exit_code,
          .out = result.out,
          .err = result.err,
          .peak_memory = result.peak_memory};
}

}  // namespace

ToolRun RunToolBinary(const std::string& name,
                      const std::vector<std::string>& arguments,
                      const std::function<void(int)>& on_start) {
  return RunOf({.program = BinaryOf(name), .arguments = arguments, .on_start = on_start});
}

ToolRun RunsWell(const ToolRun& run) {
  if (run.exit_code == 0) return run;
  throw std::runtime_error(fmt::format("exit code {}: {}{}", run.exit_code, run.err, run.out));
}

ToolRun RunsWell(const std::string& name, const std::vector<std::string>& arguments) {
  return RunsWell(RunToolBinary(name, arguments));
}

ToolRun RunToolBinaryOn(const std::filesystem::path& input,
                        const std::string& name,
                        const std::vector<std::string>& arguments) {
  ChildCommand shell = {
      .program = "sh",
      .arguments = {"-c", "input=$1; shift; exec \"$@\" < \"$input\"", "sh", input.string()}};
  shell.arguments.push_back(BinaryOf(name));
  shell.arguments.insert(shell.arguments.end(), arguments.begin(), arguments.end());
  return RunOf(shell);
}

std::string Flag(const std::string& name, const std::filesystem::path& value) {
  return "--" + name + "=" + value.string();
}

std::filesystem::path WriteTestFile(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path.string());
  return path;
}

}  // namespace fathom
