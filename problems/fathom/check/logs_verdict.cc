// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/logs_verdict.h"

#include "fathom/base/short_number.h"
#include "fathom/check/unusual_mass.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// A spread that logs that agree show once in a thousand times.
bool IsApart(const Spread& spread) { return spread.freedom > 0 && spread.p_value < 1e-3; }

bool GivesAnyModel(const CheckedLog& log) {
  return std::ranges::any_of(
      log.checkup.dofs, [](const DofCheckup& dof) { return dof.model && dof.model->is_usable; });
}

bool FitsPoorly(const CheckedLog& log) {
  return std::ranges::any_of(log.checkup.dofs,
                             [](const DofCheckup& dof) { return Has(dof.findings, "poor_fit"); });
}

// "dive/run_1 gives no model", "3 of 12 logs give no model"; empty where it is of none.
template <typename Is>
std::string ClauseOn(std::span<const CheckedLog> logs,
                     const Is& is,
                     const char* of_one,
                     const char* of_several) {
  constexpr std::size_t kMostNamed = 3;
  std::vector<std::string> paths;
  for (const CheckedLog& log : logs) {
    if (is(log)) paths.push_back(log.path);
  }
  if (paths.empty()) return "";
  if (paths.size() > kMostNamed) {
    return fmt::format("{} of {} logs {}", paths.size(), logs.size(), of_several);
  }
  return fmt::format("{} {}", fmt::join(paths, ", "), paths.size() == 1 ? of_one : of_several);
}

std::string ClauseOnInertia(std::span<const CheckedLog> logs, Dof dof) {
  std::vector<double> masses;
  double usual = 0.0;
  for (const CheckedLog& log : logs) {
    const DofCheckup* const of_dof = FindDof(log.checkup, dof);
    if (of_dof == nullptr) continue;
    const auto unusual = UnusualMassOf(log.checkup.log, dof, *of_dof->model);
    if (!unusual) continue;
    masses.push_back(unusual->inertia);
    usual = std::max(usual, unusual->usual);
  }
  if (masses.empty()) return "";
  const auto [least, most] = std::ranges::minmax(masses);
  const std::string low = ShortNumber(least, 2), high = ShortNumber(most, 2);
  return fmt::format(
      "the inertia in {} is {} times the dry mass in {} of {} logs (up to {} is usual)",
      Name(dof),
      low == high ? low : low + " to " + high,
      masses.size(),
      logs.size(),
      ShortNumber(usual, 2));
}

// What is to be known beside red findings, a clause each.
std::vector<std::string> Against(std::span<const CheckedLog> logs) {
  std::vector<std::string> clauses = {ClauseOn(
                                          logs,
                                          [](const CheckedLog& log) { return !GivesAnyModel(log); },
                                          "gives no model",
                                          "give no model"),
                                      ClauseOn(logs, FitsPoorly, "fits poorly", "fit poorly")};
  for (const Dof dof : kAllDofs) {
    if (!IsAngular(dof)) clauses.push_back(ClauseOnInertia(logs, dof));
  }
  std::erase(clauses, "");
  return clauses;
}

}  // namespace

std::vector<std::string> Disagreements(const DofOfLogs& of_dof) {
  std::vector<std::string> sentences;
  for (std::size_t p = 0; p < kNumParameters; ++p) {
    const Spread& spread = of_dof.agreement.spreads[p];
    if (!IsApart(spread)) continue;
    std::string name(kParameterInfo[p].name);
    std::ranges::replace(name, '_', ' ');
    sentences.push_back(
        fmt::format("The logs disagree on the {} in {}: it scatters {:.1f} times as far as the "
                    "logs know it (chi-square {:.3g} of {}). They are not of one vehicle in one "
                    "state, or a model of four numbers misses something.",
                    name,
                    Name(of_dof.dof),
                    std::sqrt(spread.chi_squared / spread.freedom),
                    spread.chi_squared,
                    spread.freedom));
  }
  return sentences;
}

std::string LogsVerdict(std::span<const CheckedLog> logs, std::span<const DofOfLogs> dofs) {
  const auto num_red =
      std::ranges::count_if(logs, [](const CheckedLog& log) { return HasRed(log.checkup); });
  const auto num_judged = std::ranges::count_if(logs, GivesAnyModel);
  std::vector<std::string> against = Against(logs);
  if (num_red > 0) {
    std::string text =
        fmt::format("{} of {} logs {} red findings, which have to be explained first.",
                    num_red,
                    logs.size(),
                    num_red == 1 ? "has" : "have");
    if (!against.empty()) text += fmt::format(" Besides, {}.", fmt::join(against, "; "));
    return text;
  }
  if (num_judged == 0) return fmt::format("None of these {} logs gives a model.", logs.size());
  const bool agree = std::ranges::all_of(
      dofs, [](const DofOfLogs& of_dof) { return Disagreements(of_dof).empty(); });
  if (against.empty()) {
    return agree ? fmt::format("Nothing speaks against these {} logs.", logs.size())
                 : fmt::format("Nothing speaks against any of these {} logs, but they disagree.",
                               logs.size());
  }
  if (!agree) against.emplace_back("the logs disagree");
  return fmt::format("Nothing red speaks against {} of {} logs, but {}.",
                     num_judged,
                     logs.size(),
                     fmt::join(against, "; "));
}

}  // namespace fathom
