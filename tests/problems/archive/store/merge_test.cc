// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/store/store.h"

#include <filesystem>
#include <string>

#include "test_folder.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

RunRecord RunThat(ChildEnd end, const std::string& output) {
  RunRecord run;
  run.key = "key";
  run.program = "fathom_compare";
  run.end = end;
  run.exit_code = end == ChildEnd::kExited ? 0 : -1;
  run.output = output;
  return run;
}

// Two results files that hold a run of one key each.
class MergeTest : public testing::Test {
 protected:
  void Keep(ChildEnd ours, ChildEnd theirs) {
    folder_ = EmptyTestFolder();
    Store(folder_ / "ours.sqlite").KeepRun(RunThat(ours, "ours"));
    Store(folder_ / "theirs.sqlite").KeepRun(RunThat(theirs, "theirs"));
  }

  std::string Merged() {
    Store store(folder_ / "ours.sqlite");
    store.Merge(folder_ / "theirs.sqlite");
    return store.FindRun("key")->output;
  }

  std::string FoundBeside() {
    Store store(folder_ / "ours.sqlite");
    store.LookInto(folder_ / "theirs.sqlite");
    return store.FindRun("key")->output;
  }

  std::filesystem::path folder_;
};

TEST_F(MergeTest, TakesARunThatEndedForOneThatRanOutOfTime) {
  Keep(ChildEnd::kTimedOut, ChildEnd::kExited);
  EXPECT_EQ(FoundBeside(), "theirs");
  Keep(ChildEnd::kTimedOut, ChildEnd::kExited);
  EXPECT_EQ(Merged(), "theirs");
}

TEST_F(MergeTest, KeepsItsOwnRunOtherwise) {
  for (const ChildEnd theirs : {ChildEnd::kExited, ChildEnd::kTimedOut}) {
    Keep(ChildEnd::kExited, theirs);
    EXPECT_EQ(FoundBeside(), "ours");
    EXPECT_EQ(Merged(), "ours");
  }
  Keep(ChildEnd::kTimedOut, ChildEnd::kOutOfMemory);
  EXPECT_EQ(FoundBeside(), "ours");
  EXPECT_EQ(Merged(), "ours");
}

}  // namespace
}  // namespace fathom
