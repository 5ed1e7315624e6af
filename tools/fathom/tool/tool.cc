// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/tool.h"

#include "fathom/base/exit_code.h"
#include "fathom/base/files/temporary.h"
#include "fathom/base/input_error.h"
#include "fathom/base/nearest.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/base/shell_word.h"
#include "fathom/tool/flag_values.h"
#include "fathom/tool/version.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>
#include <glog/logging.h>
#include <malloc.h>

namespace fathom {
namespace {

using Flag = gflags::CommandLineFlagInfo;

// Whether a flag is defined in tools/ or in tools/fathom/tool/, not by gflags or glog.
bool IsOwn(const Flag& flag) {
  const auto folder = std::filesystem::path(flag.filename).parent_path();
  return folder.filename() == "tools" ||
         (folder.filename() == "tool" && folder.parent_path().filename() == "fathom");
}

// Our own flags, by name.
std::vector<Flag> OwnFlags() {
  std::vector<Flag> flags;
  gflags::GetAllFlags(&flags);
  std::erase_if(flags, [](const Flag& flag) { return !IsOwn(flag); });
  std::sort(
      flags.begin(), flags.end(), [](const Flag& a, const Flag& b) { return a.name < b.name; });
  return flags;
}

const Flag* Find(const std::vector<Flag>& flags, std::string_view name) {
  const auto found =
      std::find_if(flags.begin(), flags.end(), [&](const Flag& flag) { return flag.name == name; });
  return found == flags.end() ? nullptr : &*found;
}

std::string_view ExpectedValue(const Flag& flag) {
  if (flag.type == "bool") return "true or false";
  if (flag.type == "double") return "a number";
  if (flag.type == "uint32" || flag.type == "uint64") return "a whole number, at least 0";
  if (flag.type == "int32" || flag.type == "int64") return "a whole number";
  return "a text";
}

void SetFlag(const Flag& flag, const std::string& value) {
  const bool is_finite = flag.type != "double" || ParseFiniteNumber(value);
  if (!is_finite || gflags::SetCommandLineOption(flag.name.c_str(), value.c_str()).empty()) {
    throw InputError(
        fmt::format("--{}: is {}, expected {}.", flag.name, Quoted(value), ExpectedValue(flag)));
  }
}

// ", did you mean --dof?", or nothing where no flag is near.
std::string Suggestion(const std::vector<Flag>& flags, const std::string& name) {
  std::vector<std::string> names;
  for (const Flag& flag : flags) names.push_back(flag.name);
  for (const char* name_of_all : {"help", "version"}) names.push_back(name_of_all);
  const std::string nearest = Nearest(name, names);
  return nearest.empty() ? "" : fmt::format(", did you mean --{}?", nearest);
}

// Whether a word that is no flag names what --log takes.
bool IsALog(const std::vector<Flag>& flags, const std::string& word) {
  std::error_code error;
  return Find(flags, "log") != nullptr && std::filesystem::exists(word, error);
}

[[noreturn]] void RefuseSecond(const Flag& flag,
                               const std::string& before,
                               const std::string& value,
                               const ToolInfo& info) {
  if (flag.name != info.positional_flag) {
    throw InputError(fmt::format("--{}: is given twice, expected once.", flag.name));
  }
  throw InputError(fmt::format(
      "--{0}: is given twice, {1} and {2}, expected once. A word that belongs to no flag "
      "is the {0} too.",
      flag.name,
      Quoted(before),
      Quoted(value)));
}

void ReadFlags(const std::vector<std::string>& arguments, const ToolInfo& info) {
  const std::string& tool = info.name;
  const std::vector<Flag> flags = OwnFlags();
  std::set<std::string> given;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool has_name = arguments[i].starts_with("-") || info.positional_flag.empty();
    const std::string argument =
        has_name ? arguments[i] : "--" + info.positional_flag + "=" + arguments[i];
    const std::size_t dashes = argument.starts_with("--") ? 2 : argument.starts_with("-") ? 1 : 0;
    if (dashes == 0 || argument.size() == dashes) {
      throw InputError(IsALog(flags, argument)
                           ? fmt::format("a log needs its flag, expected --log={}. See {} --help.",
                                         ShellWord(argument),
                                         tool)
                           : fmt::format("{}: is no flag, expected --name=value. See {} --help.",
                                         Quoted(argument),
                                         tool));
    }
    const std::size_t equals = argument.find('=');
    const std::string name =
        argument.substr(dashes, equals == std::string::npos ? std::string::npos : equals - dashes);
    const Flag* flag = Find(flags, name);
    std::string value;
    if (equals != std::string::npos) {
      value = argument.substr(equals + 1);
    } else if (flag != nullptr && flag->type == "bool") {
      value = "true";
    } else if (flag != nullptr && i + 1 < arguments.size()) {
      value = arguments[++i];
    } else if (flag != nullptr) {
      throw InputError(fmt::format("--{}: has no value, expected {}.", name, ExpectedValue(*flag)));
    } else if (name.starts_with("no")) {
      flag = Find(flags, std::string_view(name).substr(2));
      if (flag != nullptr && flag->type != "bool") flag = nullptr;
      value = "false";
    }
    if (flag == nullptr) {
      const std::string suggestion = Suggestion(flags, name);
      throw InputError(fmt::format("--{}: there is no such flag{} See {} --help.",
                                   Printable(name),
                                   suggestion.empty() ? "." : suggestion,
                                   tool));
    }
    const bool may_repeat = std::ranges::count(info.repeatable_flags, flag->name) > 0;
    if (!given.insert(flag->name).second) {
      std::string before;
      gflags::GetCommandLineOption(flag->name.c_str(), &before);
      if (!may_repeat) RefuseSecond(*flag, before, value, info);
      SetFlag(*flag, before + kBetweenValues + value);
      continue;
    }
    SetFlag(*flag, value);
  }
}

// As a person would write it: gflags gives 0.05 all seventeen digits.
std::string DefaultOf(const Flag& flag) {
  return flag.type == "double" ? fmt::format("{}", std::stod(flag.default_value))
                               : flag.default_value;
}

// Each line of the usage is one way to call the program; help2man reads "or:".
void PrintUsage(const ToolInfo& info) {
  std::istringstream lines(info.usage);
  const char* before = "Usage:";
  for (std::string line; std::getline(lines, line); before = "   or:") {
    fmt::print("{} {} {}\n", before, info.name, line);
  }
}

void PrintHelp(const ToolInfo& info) {
  fmt::print("{}\n\n", info.summary);
  PrintUsage(info);
  fmt::print("\n");
  for (const Flag& flag : OwnFlags()) {
    fmt::print("  --{}", flag.name);
    if (flag.type != "string") {
      fmt::print(" (default {})", DefaultOf(flag));
    } else if (!flag.default_value.empty()) {
      fmt::print(" (default \"{}\")", flag.default_value);
    }
    fmt::print("\n      {}\n", flag.description);
  }
  fmt::print("\nExample:\n\n  {}\n", info.example);
  if (!info.details.empty()) fmt::print("\n{}\n", info.details);
  fmt::print("\nExit code {}.\n", info.exit_codes);
}

void PrintFlags() {
  for (const Flag& flag : OwnFlags()) {
    fmt::print("--{}{}\n", flag.name, flag.type == "bool" ? "" : "=");
  }
  fmt::print("--help\n--version\n");
}

int ReadFlagsAndRun(const std::vector<std::string>& arguments,
                    const ToolInfo& info,
                    const std::function<int()>& run) {
  const auto given = [&](const char* flag) {
    return std::find(arguments.begin(), arguments.end(), flag) != arguments.end();
  };
  if (given("--help") || given("-help") || given("-h")) {
    PrintHelp(info);
    return 0;
  }
  if (given("--version") || given("-version")) {
    fmt::print("fathom {}\n", VersionWithCommit());
    return 0;
  }
  if (given("--flags")) {
    PrintFlags();
    return 0;
  }
  ReadFlags(arguments, info);
  return run();
}

std::string& CommandLineOfThis() {
  static std::string line;
  return line;
}

// Memory that was given back and is asked for again comes from the system in pages of 4 kB: a
// quarter of the CPU time of fathom_plan. Up to this much stays here instead.
void KeepMemory() {
  constexpr int kMostKept = 256 << 20, kLargestKept = 32 << 20;  // bytes; of one piece
  mallopt(M_TRIM_THRESHOLD, kMostKept);
  mallopt(M_MMAP_THRESHOLD, kLargestKept);
}

}  // namespace

const std::string& CommandLine() { return CommandLineOfThis(); }

int RunTool(int argc, char** argv, const ToolInfo& info, const std::function<int()>& run) {
  KeepMemory();
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_FATAL;  // what a solver tries and drops is no news to a user
  google::InitGoogleLogging(info.name.c_str());
  RemoveTemporariesOnInterrupt();
  CommandLineOfThis() = info.name;
  for (int i = 1; i < argc; ++i) CommandLineOfThis() += " " + ShellWord(argv[i]);
  return ReportProblems(info.name, [&] {
    return ReadFlagsAndRun({argv + std::min(argc, 1), argv + argc}, info, run);
  });
}

int ReportProblems(const std::string& name, const std::function<int()>& run) {
  int exit_code = kExitBadInput;
  std::string problem;
  try {
    exit_code = run();
  } catch (const std::bad_alloc&) {
    problem = "the memory does not suffice.";
    exit_code = kExitOutOfMemory;
  } catch (const std::exception& error) {
    problem = error.what();
    exit_code = kExitBadInput;
  }
  if (problem.empty() && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)) {
    problem = "cannot write to standard output.";
    exit_code = kExitBadInput;
  }
  if (problem.empty()) return exit_code;
  std::fflush(stdout);
  fmt::print(stderr, "{}: {}\n", name, ShownOnLines(problem));
  return exit_code;
}

const std::string& RequireFlag(const std::string& name,
                               const std::string& value,
                               const std::string& expected) {
  if (value.empty()) {
    throw InputError(fmt::format("--{}: is missing, expected {}.", name, expected));
  }
  return value;
}

}  // namespace fathom
