// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/run_program.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/input_error.h"
#include "fathom/log/log_content.h"

#include <atomic>
#include <csignal>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

std::string LimitsText(const ChildLimits& limits) {
  return fmt::format("{} s, {} bytes", limits.wall_time, limits.memory);
}

bool MayBeUsedAgain(const RunRecord& run, const ProgramSettings& settings) {
  const bool has_todays_limits = run.limits == LimitsText(settings.limits);
  switch (run.end) {
    case ChildEnd::kExited:
      return IsFinal(run) || has_todays_limits;
    case ChildEnd::kSignalled:
      return run.signal != SIGKILL && run.signal != SIGTERM && run.signal != SIGINT &&
             run.signal != SIGHUP;
    case ChildEnd::kTimedOut:
    case ChildEnd::kOutOfMemory:
      return has_todays_limits;
    case ChildEnd::kNotStarted:
      return false;
  }
  return false;
}

// The last line that says something, without the program's name before it.
std::string LastLineOf(std::string_view text, const std::string& program) {
  constexpr std::size_t kLongest = 1000;
  constexpr std::string_view kSpace = " \r\n\t";
  const std::size_t end = text.find_last_not_of(kSpace);
  if (end == std::string_view::npos) return "";
  text = text.substr(0, end + 1);
  const std::size_t newline = text.rfind('\n');
  if (newline != std::string_view::npos) text.remove_prefix(newline + 1);
  const std::string prefix = program + ": ";
  if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
  return CleanText(text.substr(0, kLongest));
}

std::string TakeFile(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return "";
  std::string text = ReadFile(file);
  fs::remove(file, error);
  return text;
}

bool TakesVehicle(const ProgramCall& call, const ProgramSettings& settings) {
  return call.takes_vehicle && !settings.vehicle.empty();
}

}  // namespace

std::string KeyOf(const ProgramCall& call, const ProgramSettings& settings) {
  std::vector<std::string> contents = call.contents;
  if (TakesVehicle(call, settings)) contents.push_back(settings.vehicle_content);
  return DigestOf(
      {call.program, settings.version, DigestOf(contents), DigestOf(call.flags), call.output});
}

RunRecord RunProgram(const ProgramCall& call,
                     const ProgramSettings& settings,
                     const RunBook& book) {
  RunRecord run;
  run.key = KeyOf(call, settings);
  if (auto known = book.find(run.key); known && MayBeUsedAgain(*known, settings)) return *known;

  static std::atomic<int> counter = 0;
  const fs::path file = settings.work / fmt::format("{}.json", ++counter);
  ChildCommand command = {.program = (settings.tools / call.program).string(),
                          .arguments = call.flags,
                          .limits = settings.limits,
                          .most_output = std::size_t{16} << 20};
  command.arguments.insert(command.arguments.end(), call.places.begin(), call.places.end());
  if (TakesVehicle(call, settings)) {
    command.arguments.push_back("--default_vehicle=" + settings.vehicle.string());
  }
  run.arguments = CleanText(fmt::format("{}", fmt::join(command.arguments, " ")));
  if (!call.output.empty()) {
    command.arguments.push_back(fmt::format("--{}={}", call.output, file.string()));
  }
  const ChildResult result = RunChild(command);
  run.program = call.program;
  run.version = settings.version;
  run.limits = LimitsText(settings.limits);
  run.end = result.end;
  run.exit_code = result.exit_code;
  run.signal = result.signal;
  run.seconds = result.seconds;
  run.peak_mb = result.peak_memory / 1e6;
  run.output = call.output.empty() ? result.out : TakeFile(file);
  run.message = LastLineOf(result.err, call.program);
  book.keep(run);
  return run;
}

}  // namespace fathom
