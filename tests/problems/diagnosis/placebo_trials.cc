// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// How often a column that cannot be a cause is named. Exit 1 if any is.
//
//   placebo_trials --trials=200 --jobs=2

#include <cstddef>
#include <vector>

#include "placebo.h"
#include "side_by_side.h"
#include <fmt/format.h>
#include <gflags/gflags.h>
#include <glog/logging.h>

DEFINE_int32(trials, 200, "seeds, from 0 on");
DEFINE_int32(jobs, 2, "trials at a time");

int main(int argc, char** argv) {
  gflags::SetUsageMessage("counts how often a column that cannot be a cause is named");
  gflags::ParseCommandLineFlags(&argc, &argv, true);
  FLAGS_logtostderr = true;
  google::InitGoogleLogging(argv[0]);
  std::vector<fathom::PlaceboResult> results(static_cast<std::size_t>(FLAGS_trials));
  fathom::SideBySide(
      results.size(), FLAGS_jobs, [&](std::size_t i) { results[i] = fathom::TryPlacebo(i); });
  int num_named = 0, num_alternatives = 0, num_offered = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const fathom::PlaceboResult& result = results[i];
    num_offered += result.is_offered;
    num_named += result.is_named;
    num_alternatives += result.is_alternative && !result.is_named;
    if (result.is_alternative) fmt::print("trial {}: {}\n", i, result.text);
  }
  fmt::print("{} trials, placebos offered in {}: named in {}, said to be no worse in {} more\n",
             FLAGS_trials,
             num_offered,
             num_named,
             num_alternatives);
  return num_named == 0 && num_offered == FLAGS_trials ? 0 : 1;
}
