// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// One command for all programs: `fathom identify ...` becomes fathom_identify.

#include "fathom/base/exit_code.h"
#include "fathom/base/input_error.h"
#include "fathom/base/nearest.h"
#include "fathom/base/quoted.h"
#include "fathom/process/run_child.h"
#include "fathom/tool/completion.h"
#include "fathom/tool/programs_folder.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/version.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace fathom {
namespace {

// "identify" of fathom_identify, ...: those that tools/CMakeLists.txt builds.
std::vector<std::string> SubCommands() {
  std::istringstream names(FATHOM_SUB_COMMANDS);
  std::vector<std::string> commands;
  for (std::string name; names >> name;) commands.push_back(name);
  std::ranges::sort(commands);
  return commands;
}

std::string ProgramOf(const std::string& command) {
  return (ProgramsFolder() / ("fathom_" + command)).string();
}

// The first line of the program's help.
std::string SummaryOf(const std::string& command) {
  const ChildResult help = RunChild({.program = ProgramOf(command), .arguments = {"--help"}});
  if (help.end != ChildEnd::kExited || help.exit_code != kExitUsable) {
    return fmt::format("({} cannot be run)", ProgramOf(command));
  }
  return help.out.substr(0, help.out.find('\n'));
}

int PrintCommands() {
  fmt::print(
      "Fathom identifies motion models of underwater vehicles from their logs.\n\n"
      "Usage: fathom SUB-COMMAND [--name=value ...]\n\n");
  for (const std::string& command : SubCommands()) {
    fmt::print("  {:<12}{}\n", command, SummaryOf(command));
  }
  fmt::print(
      "\n  {:<12}{}\n", "completion", "Prints a script for a shell: fathom completion bash|zsh");
  fmt::print("  {:<12}{}\n", "help", "Shows a sub-command's help: fathom help identify");
  fmt::print(
      "\n`fathom identify` is the program fathom_identify, with its flags and exit codes.\n\n"
      "Example:\n\n  fathom identify --log=data/flatfish --dof=surge\n");
  return kExitUsable;
}

void RequireSubCommand(const std::string& given) {
  std::vector<std::string> known = SubCommands();
  if (std::ranges::count(known, given) > 0) return;
  known.insert(known.end(), {"completion", "help"});
  const std::string nearest = Nearest(given, known);
  throw InputError(fmt::format("{}: there is no such sub-command{} See fathom --help.",
                               Quoted(given),
                               nearest.empty() ? "." : ", did you mean '" + nearest + "'?"));
}

// Becomes the program: its exit code, signals and terminal are its own.
[[noreturn]] void Become(const std::string& command, std::vector<std::string> arguments) {
  RequireSubCommand(command);
  arguments.insert(arguments.begin(), "fathom_" + command);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const std::string program = ProgramOf(command);
  execv(program.c_str(), pointers.data());
  throw InputError(fmt::format("{}: cannot be run ({}), expected it beside the program fathom.",
                               program,
                               std::strerror(errno)));
}

int PrintCompletion(const std::vector<std::string>& shells) {
  if (shells.size() != 1) {
    throw InputError(fmt::format("completion: names {} shell, expected bash or zsh.",
                                 shells.empty() ? "no" : "more than one"));
  }
  const std::string& shell = shells.front();
  if (shell != "bash" && shell != "zsh") {
    throw InputError(fmt::format("completion: is {}, expected bash or zsh.", Quoted(shell)));
  }
  fmt::print("{}", shell == "bash" ? BashCompletion(SubCommands()) : ZshCompletion(SubCommands()));
  return kExitUsable;
}

int Run(const std::vector<std::string>& arguments) {
  const std::string first = arguments.empty() ? "--help" : arguments.front();
  const std::vector<std::string> rest(arguments.begin() + (arguments.empty() ? 0 : 1),
                                      arguments.end());
  if (first == "--version") {
    fmt::print("fathom {}\n", VersionWithCommit());
    return kExitUsable;
  }
  if (first == "--help" || first == "-h" || first == "help") {
    if (rest.empty()) return PrintCommands();
    if (rest.size() > 1) {
      throw InputError(fmt::format(
          "{}: is one too many, expected one sub-command after {}.", Quoted(rest[1]), first));
    }
    Become(rest.front(), {"--help"});
  }
  if (first == "completion") return PrintCompletion(rest);
  if (first.starts_with("-")) {
    throw InputError(
        fmt::format("{}: a sub-command comes first, as in fathom identify --log=LOG. See fathom "
                    "--help.",
                    Quoted(first)));
  }
  Become(first, rest);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  return fathom::ReportProblems("fathom", [&] {
    return fathom::Run({argv + std::min(argc, 1), argv + argc});
  });
}
