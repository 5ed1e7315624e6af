// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/command_check.h"

#include "fathom/base/plural.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

void NoteCommand(const char* code,
                 std::string sentence,
                 std::vector<Finding>* findings,
                 std::optional<FindingPlace> where = {}) {
  findings->push_back({Severity::kNote, code, std::move(sentence), std::move(where)});
}

// The command at the stamps of the motion.
struct Sampled {
  std::vector<double> time, force, velocity;
  double duration = 0.0;  // [s]
  std::size_t num_changes = 0;
};

Sampled SampledOf(const HeldCommand& command, std::span<const Segment> segments) {
  Sampled sampled;
  for (const Segment& segment : segments) {
    const std::vector<double> force = command.At(segment.time);
    for (std::size_t i = 1; i < force.size(); ++i) {
      if (force[i] != force[i - 1]) ++sampled.num_changes;
    }
    sampled.time.insert(sampled.time.end(), segment.time.begin(), segment.time.end());
    sampled.force.insert(sampled.force.end(), force.begin(), force.end());
    sampled.velocity.insert(
        sampled.velocity.end(), segment.velocity.begin(), segment.velocity.end());
    sampled.duration += segment.time.back() - segment.time.front();
  }
  return sampled;
}

// The longest stretch of stamps at which the command has this value.
FindingPlace LongestAt(double value, const Sampled& sampled) {
  TimeInterval longest = {0.0, -1.0};
  const auto& [time, force, velocity, duration, num_changes] = sampled;
  for (std::size_t first = 0; first < force.size();) {
    std::size_t end = first;
    while (end < force.size() && force[end] == value) ++end;
    if (end > first && time[end - 1] - time[first] > longest.to - longest.from) {
      longest = {time[first], time[end - 1]};
    }
    first = end + 1;
  }
  return {"command.csv", "", longest};
}

void CheckClipping(const Sampled& sampled,
                   const std::string& force_unit,
                   std::vector<Finding>* findings) {
  constexpr std::size_t kManyValues = 20;
  constexpr double kShare = 0.1;
  const std::set<double> values(sampled.force.begin(), sampled.force.end());
  if (values.size() < kManyValues) return;
  for (const double limit : {*values.begin(), *values.rbegin()}) {
    const auto count = std::count(sampled.force.begin(), sampled.force.end(), limit);
    const double share = static_cast<double>(count) / static_cast<double>(sampled.force.size());
    if (share < kShare || limit == 0.0) continue;
    NoteCommand(
        "clipped_command",
        fmt::format("The command stands at its limit of {:.4g} {} for {:.0f} % of the time.",
                    limit,
                    force_unit,
                    100.0 * share),
        findings,
        LongestAt(limit, sampled));
  }
}

std::vector<double> SecondDifferences(const std::vector<double>& values) {
  std::vector<double> differences;
  for (std::size_t i = 2; i < values.size(); ++i) {
    differences.push_back(values[i] - 2.0 * values[i - 1] + values[i - 2]);
  }
  return differences;
}

// The correlation of a[i] and b[i - lag] of two normal variables by their signs, which single jumps
// do not move. Nothing where half of them are 0.
std::optional<double> SignCorrelation(const std::vector<double>& a,
                                      const std::vector<double>& b,
                                      int lag) {
  double sum = 0.0;
  std::size_t count = 0, num_all = 0;
  for (int i = std::max(lag, 0); i < std::ssize(a) && i - lag < std::ssize(b); ++i) {
    const double product = a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(i - lag)];
    ++num_all;
    if (product == 0.0) continue;
    sum += product > 0.0 ? 1.0 : -1.0;
    ++count;
  }
  if (2 * count < num_all || count == 0) return std::nullopt;
  return std::sin(0.5 * std::numbers::pi * sum / static_cast<double>(count));
}

// Noise of the speed that is in the command too: docs/findings.md (7).
void CheckLoop(const HeldCommand& command,
               std::span<const Segment> segments,
               std::vector<Finding>* findings) {
  constexpr std::size_t kFewest = 200;
  constexpr double kLeast = 0.4, kLeastBeside = 0.15;
  const auto longest =
      std::max_element(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
        return a.time.size() < b.time.size();
      });
  if (longest == segments.end() || longest->time.size() < kFewest) return;
  const std::vector<double> force = SecondDifferences(command.At(longest->time));
  const std::vector<double> speed = SecondDifferences(longest->velocity);
  for (const int lag : {0, 1, 2}) {
    const auto at = SignCorrelation(force, speed, lag);
    const auto before = SignCorrelation(force, speed, lag - 1);
    const auto behind = SignCorrelation(force, speed, lag + 1);
    if (!at || !before || !behind) return;
    if (*at > -kLeast || std::max(*before, *behind) < kLeastBeside) continue;
    NoteCommand(
        "closed_loop",
        fmt::format("The command follows the motion: the noise of the speed is in it, with a "
                    "correlation of {:.2f}. A controller was on.",
                    *at),
        findings);
    return;
  }
}

}  // namespace

std::vector<Finding> CheckCommand(const HeldCommand& command,
                                  std::span<const Segment> segments,
                                  const std::string& force_unit) {
  constexpr double kShort = 30.0;  // [s]
  constexpr std::size_t kFewChanges = 4;
  std::vector<Finding> findings;
  const Sampled sampled = SampledOf(command, segments);
  if (sampled.force.empty()) return findings;
  if (sampled.duration < kShort) {
    NoteCommand("short_log",
                fmt::format("The log holds {:.0f} s of motion to learn from.", sampled.duration),
                &findings);
  }
  if (sampled.num_changes > 0 && sampled.num_changes < kFewChanges) {
    NoteCommand(
        "few_changes",
        fmt::format("The command changes {} while the motion is measured.",
                    sampled.num_changes == 1 ? "once" : Plural(sampled.num_changes, "time")),
        &findings);
  }
  CheckClipping(sampled, force_unit, &findings);
  CheckLoop(command, segments, &findings);
  return findings;
}

}  // namespace fathom
