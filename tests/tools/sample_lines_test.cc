// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/sample_lines.h"

#include "fathom/base/input_error.h"

#include <sstream>
#include <string>
#include <vector>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::StartsWith;

// Each sample as t, tau, v; then what was wrong, if something was.
struct Taken {
  std::vector<std::vector<double>> samples;
  std::string problem;
  std::vector<std::string> not_read;
};

Taken Take(const std::string& text) {
  std::istringstream in(text);
  SampleLines lines("stdin", &in);
  Taken taken;
  try {
    while (const auto sample = lines.Next()) {
      taken.samples.push_back({sample->t, sample->force, sample->velocity});
    }
  } catch (const InputError& error) {
    taken.problem = error.what();
  }
  taken.not_read = lines.not_read();
  return taken;
}

TEST(SampleLines, AreTakenWithNamesAndWithout) {
  const auto both = ElementsAre(ElementsAre(0.5, -2.0, 0.25), ElementsAre(1.0, 3.0, 0.5));
  EXPECT_THAT(Take("0.5,-2,0.25\n1,3,.5\n").samples, both);
  EXPECT_THAT(Take("t,tau,v\n0.5,-2,0.25\n1,3,.5").samples, both) << "no line feed at the end";
  EXPECT_THAT(Take(" v , t,tau\n0.25,0.5 ,-2\n.5,1,3\n").samples, both);
  const Taken wide = Take("t,mode,tau,v\n0.5,AUTO,-2,0.25\n1,,3,.5\n");
  EXPECT_THAT(wide.samples, both);
  EXPECT_THAT(wide.not_read, ElementsAre("mode"));
}

TEST(SampleLines, PassOverBlankLinesAndComments) {
  EXPECT_THAT(Take("\n# a dive\n \nt,tau,v\n#\n0.5,-2,0.25\n\n").samples,
              ElementsAre(ElementsAre(0.5, -2.0, 0.25)));
  EXPECT_THAT(Take("").samples, ElementsAre());
}

TEST(SampleLines, SayLineColumnFoundAndExpected) {
  const std::string advice =
      ", expected a finite number. Remove the line or repair it upstream; this reader does not "
      "guess.";
  EXPECT_EQ(Take("t,tau,v\n\n0,1,2\n1,x,3\n").problem, "stdin:4: column 'tau' is 'x'" + advice);
  EXPECT_EQ(Take("0,1,nan\n").problem, "stdin:1: column 'v' is 'nan'" + advice);
  EXPECT_EQ(Take("0,,1\n").problem, "stdin:1: column 'tau' is empty" + advice);
  EXPECT_EQ(Take("0,1,2\nt,tau,v\n").problem, "stdin:2: column 't' is 't'" + advice);
  EXPECT_EQ(Take("0,1,2\n1,2\n").problem, "stdin:2: the line has 2 cells, expected 3.");
  EXPECT_EQ(Take("0;1;2\n").problem,
            "stdin:1: column 't' is missing, found 0;1;2; expected t, tau, v.");
  EXPECT_EQ(Take("t,tau,u\n").problem,
            "stdin:1: column 'v' is missing, found t, tau, u; expected t, tau, v.");
  EXPECT_EQ(Take("t,tau,v,t\n").problem, "stdin:1: column 't' stands twice, expected once.");
  EXPECT_THAT(Take("0,1,2\r\n").problem,
              StartsWith("stdin:1: the line ends in a carriage return, expected a line feed"));
  EXPECT_EQ(Take("0,1,2\n" + std::string(5000, '1')).problem,
            "stdin:2: the line has more than 4095 bytes, expected t,tau,v.");
}

TEST(SampleLines, RefuseStampsThatDoNotRise) {
  const Taken back = Take("3,1,2\n2.5,1,2\n");
  EXPECT_EQ(back.samples.size(), 1u);
  EXPECT_EQ(back.problem, "stdin:2: column 't' goes back from 3 to 2.5, expected rising stamps.");
  EXPECT_EQ(Take("3,1,2\n3,1,2\n").problem,
            "stdin:2: column 't' does not rise from 3 to 3, expected rising stamps.");
}

TEST(SampleLines, PassOverAStreamUpToWhereTheyGoOn) {
  std::istringstream in("4,1,2\n5,1,2\n5.5,1,2\n6,1,2\n7,1,2\n");
  SampleLines lines("stdin", &in);
  lines.GoOnBehind({5.5, 1.0, 2.0}, "s.json");
  EXPECT_EQ(lines.Next()->t, 6.0);
  EXPECT_EQ(lines.num_passed_over(), 3);
  EXPECT_EQ(lines.Next()->t, 7.0);
  EXPECT_FALSE(lines.Next());
}

TEST(SampleLines, RefuseToGoOnInAnotherStream) {
  // Other stamps, and the same ones with other values.
  for (const char* text : {"5,1,2\n6,1,2", "5.5,1,3\n6,1,2"}) {
    std::istringstream in(text);
    SampleLines lines("stdin", &in);
    lines.GoOnBehind({5.5, 1.0, 2.0}, "s.json");
    EXPECT_EQ(ErrorFrom([&] { lines.Next(); }),
              "stdin:2: t = 6 comes without a line 5.5,1,2 before it, the last sample of s.json. "
              "Expected the same stream again, or one that begins behind it.");
  }
}

}  // namespace
}  // namespace fathom
