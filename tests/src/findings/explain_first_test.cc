// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/explain_first.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(ExplainFirst, CountsWhatIsRed) {
  const Finding note = {Severity::kNote, "gap", "4 gaps."},
                red = {Severity::kWarning, "passivity", "It gains energy."};
  EXPECT_EQ(ExplainFirst({note}), "");
  EXPECT_EQ(ExplainFirst({note, red}),
            "One red finding has to be explained before a model of this log can be believed.");
  EXPECT_EQ(ExplainFirst({red, red}),
            "2 red findings have to be explained before a model of this log can be believed.");
}

}  // namespace
}  // namespace fathom
