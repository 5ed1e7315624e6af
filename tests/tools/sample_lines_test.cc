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
  const std::string advice = " Remove the line or repair it upstream; this reader does not guess.";
  const std::string finite = ", expected a finite number." + advice;
  const std::string number = ", expected a number such as -0.25." + advice;
  EXPECT_EQ(Take("t,tau,v\n\n0,1,2\n1,x,3\n").problem, "stdin:4: column 'tau' is 'x'" + number);
  EXPECT_EQ(Take("0,1,nan\n").problem, "stdin:1: column 'v' is 'nan'" + finite);
  EXPECT_EQ(Take("0,-Inf,1\n").problem, "stdin:1: column 'tau' is '-Inf'" + finite);
  EXPECT_EQ(Take("0,,1\n").problem, "stdin:1: column 'tau' is empty" + finite);
  EXPECT_EQ(Take("0,1,2\nt,tau,v\n").problem, "stdin:2: column 't' is 't'" + number);
  EXPECT_EQ(Take("0,1,2\n1,2\n").problem,
            "stdin:2: the line has 2 cells, '1,2', expected 3: t,tau,v.");
  EXPECT_EQ(Take("# a dive\nt,u,tau,v\n1\n").problem,
            "stdin:3: the line has 1 cell, '1', expected 4 as on line 2.");
  EXPECT_EQ(Take("t,tau,u\n").problem,
            "stdin:1: column 'v' is missing, found t, tau, u; expected t, tau, v.");
  EXPECT_EQ(Take("t,tau,v,t\n").problem,
            "stdin:1: column 't' stands twice, as column 1 and 4. Remove or rename one.");
  EXPECT_EQ(Take("0,1,2\n" + std::string(5000, '1')).problem,
            "stdin:2: the line has more than 4095 bytes, expected t,tau,v.");
}

TEST(SampleLines, SayWhatSeparatesInsteadOfCommas) {
  const std::string expected = ", expected commas: t,tau,v.";
  EXPECT_EQ(Take("0;1;2\n").problem, "stdin:1: the cells are separated by ';'" + expected);
  EXPECT_EQ(Take("t\ttau\tv\n").problem, "stdin:1: the cells are separated by tabs" + expected);
  EXPECT_EQ(Take("t,tau,v\n0 1 2\n").problem,
            "stdin:2: the cells are separated by spaces" + expected);
}

TEST(SampleLines, RefuseNamesWithUnits) {
  EXPECT_EQ(Take("t_ms,tau,v\n").problem,
            "stdin:1: column 't_ms' is the time with a unit, expected SI units and plain names. "
            "Convert to SI and name the column 't'.");
  EXPECT_EQ(Take("t,tau [kN],v\n").problem,
            "stdin:1: column 'tau [kN]' is 'tau' with a unit, expected SI units and plain names. "
            "Convert to SI and name the column 'tau'.");
  // Beside the column itself it is one more that is not read.
  EXPECT_THAT(Take("t,t_ms,tau,v\n0.5,500,-2,0.25\n").samples,
              ElementsAre(ElementsAre(0.5, -2.0, 0.25)));
}

TEST(SampleLines, RefuseWhatIsNoPlainText) {
  EXPECT_THAT(Take("0,1,2\r\n").problem,
              StartsWith("stdin:1: the line ends in a carriage return, expected a line feed"));
  EXPECT_EQ(Take("\xef\xbb\xbft,tau,v\n").problem,
            "stdin:1: starts with a UTF-8 byte order mark, expected t,tau,v. Send the stream "
            "through sed '1s/^\\xEF\\xBB\\xBF//'.");
  EXPECT_THAT(Take("\xff\xfet").problem, StartsWith("stdin:1: is UTF-16, expected plain text."));
  EXPECT_THAT(Take(std::string("0,1,2\n1,\0,2\n", 12)).problem,
              StartsWith("stdin:2: a NUL byte amid the text, expected t,tau,v."));
}

TEST(SampleLines, RefuseStampsThatDoNotRise) {
  const Taken back = Take("3,1,2\n2.5,1,2\n");
  EXPECT_EQ(back.samples.size(), 1u);
  EXPECT_EQ(back.problem,
            "stdin:2: column 't' goes back from 3 to 2.5, expected rising stamps. Sort the lines, "
            "or begin anew, with another --state, where the clock was reset.");
  EXPECT_EQ(Take("3,1,2\n\n3,1,2\n").problem,
            "stdin:3: column 't' is 3 as on line 1, expected rising stamps. Leave out one of the "
            "two lines, or print t with more digits.");
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
