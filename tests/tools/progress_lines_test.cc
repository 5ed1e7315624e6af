// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/progress_lines.h"

#include <chrono>
#include <string>
#include <thread>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::StartsWith;

// A reader of the file sees at once that the program lives, and later how far it is.
TEST(ProgressLines, AreWrittenAgainWhereNothingWasDone) {
  testing::internal::CaptureStderr();
  {
    ProgressLines lines("fathom_batch", "nothing done yet", milliseconds(20));
    std::this_thread::sleep_for(milliseconds(200));
    lines.Show("log 3 of 17");
    std::this_thread::sleep_for(milliseconds(200));
  }
  const std::string written = testing::internal::GetCapturedStderr();
  EXPECT_THAT(written,
              StartsWith("fathom_batch: nothing done yet\nfathom_batch: nothing done yet\n"));
  EXPECT_THAT(written, HasSubstr("fathom_batch: log 3 of 17\nfathom_batch: log 3 of 17\n"));
}

TEST(ProgressLines, AreNoneOfShortWork) {
  testing::internal::CaptureStderr();
  { ProgressLines lines("fathom_batch", "nothing done yet", std::chrono::minutes(1)); }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace fathom
