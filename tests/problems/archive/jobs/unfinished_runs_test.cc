// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/unfinished_runs.h"

#include "fathom/base/exit_code.h"

#include <tuple>

#include <gtest/gtest.h>

namespace fathom {
namespace {

RunRecord Ended(ChildEnd end, int exit_code) {
  RunRecord run;
  run.key = "key";
  run.end = end;
  run.exit_code = exit_code;
  return run;
}

TEST(UnfinishedRuns, AreThoseThatALimitOrASignalEnded) {
  for (const auto& [end, exit_code, is_final] :
       {std::tuple{ChildEnd::kExited, kExitUsable, true},
        std::tuple{ChildEnd::kExited, kExitBadInput, true},
        std::tuple{ChildEnd::kExited, kExitNoFit, true},
        std::tuple{ChildEnd::kExited, kExitOutOfMemory, false},
        std::tuple{ChildEnd::kSignalled, 137, false},
        std::tuple{ChildEnd::kTimedOut, 137, false},
        std::tuple{ChildEnd::kOutOfMemory, 4, false},
        std::tuple{ChildEnd::kNotStarted, -1, false}}) {
    UnfinishedRuns runs;
    const RunBook book = runs.Watch(
        {.find = [](const auto&) { return std::nullopt; }, .keep = [](const RunRecord&) {}});
    book.keep(Ended(end, exit_code));
    EXPECT_EQ(runs.IsEmpty(), is_final) << static_cast<int>(end) << " " << exit_code;
  }
}

TEST(UnfinishedRuns, AreFinishedWhenTheyAreMadeAgain) {
  UnfinishedRuns runs;
  const RunBook book =
      runs.Watch({.find = [](const auto&) { return Ended(ChildEnd::kTimedOut, 137); },
                  .keep = [](const RunRecord&) {}});
  book.find("key");
  EXPECT_FALSE(runs.IsEmpty());
  book.keep(Ended(ChildEnd::kExited, kExitUsable));
  EXPECT_TRUE(runs.IsEmpty());
}

}  // namespace
}  // namespace fathom
