// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/correct_velocity.h"

#include "fathom/log/read_log.h"

#include <string>

#include "log_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::StartsWith;

// Three rates, two of them with factors in log.yaml.
LogFiles Corrected() {
  return {{"log.yaml", "name: a\ndof: roll\ncorrect: {q: 0.5, p: -1}\n"},
          {"velocity.csv", "t,p,q,r\n0.5,1,2,3\n0.6,-4,6,8\n"}};
}

TEST(ReadLog, MultipliesColumnsAsLogYamlSays) {
  const Log log = ReadLog(FolderWith(Corrected()));
  EXPECT_THAT(*log.velocity->Find("p"), ElementsAre(-1, 4));
  EXPECT_THAT(*log.velocity->Find("q"), ElementsAre(1, 3));
  EXPECT_THAT(*log.velocity->Find("r"), ElementsAre(3, 8));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("velocity.csv: p times -1, q times 0.5, as log.yaml says."));
}

TEST(ReadLog, MultipliesAColumnAsAskedInPlaceOfWhatLogYamlSays) {
  const Log log = ReadLog(FolderWith(Corrected()), {.corrections = {{"q", 3}, {"r", -1}}});
  EXPECT_THAT(*log.velocity->Find("p"), ElementsAre(-1, 4));
  EXPECT_THAT(*log.velocity->Find("q"), ElementsAre(6, 18));
  EXPECT_THAT(*log.velocity->Find("r"), ElementsAre(-3, -8));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("velocity.csv: p times -1, as log.yaml says.",
                          "velocity.csv: q times 3, r times -1, as --correct says."));
}

// Of u = 10 t and w = 3, u late by 0.25 s: at 0.3 s it is what was written at 0.55 s.
TEST(ReadLog, ReadsALateColumnOffLater) {
  const LogFiles files = {{"log.yaml", "name: a\ndof: surge\nlate: {u: 0.25}\ncorrect: {u: -1}\n"},
                          {"velocity.csv", "t,u,w\n0.3,3,3\n0.4,4,3\n0.5,5,3\n0.6,6,3\n0.7,7,3\n"}};
  const Log log = ReadLog(FolderWith(files));
  EXPECT_THAT(log.velocity->time, ElementsAre(0.3, 0.4));
  EXPECT_THAT(*log.velocity->Find("u"),
              ElementsAre(DoubleNear(-5.5, 1e-12), DoubleNear(-6.5, 1e-12)));
  EXPECT_THAT(*log.velocity->Find("w"), ElementsAre(3, 3));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("velocity.csv: u times -1 and 0.25 s earlier, as log.yaml says."));
  const Log early = ReadLog(FolderWith(files), {.corrections = {{.column = "u", .late = -0.1}}});
  EXPECT_THAT(early.velocity->time, ElementsAre(0.4, 0.5, 0.6, 0.7));
  EXPECT_THAT(early.velocity->Find("u")->front(), DoubleNear(3.0, 1e-12));
  EXPECT_THAT(TextsOf(ReadLog(FolderWith(files), {.corrections = {{"u", 1}}}).remarks),
              ElementsAre("velocity.csv: u times 1, as --correct says."));
  EXPECT_EQ(RefusalOf(files, {.corrections = {{.column = "u", .late = 9.0}}}),
            "--correct: velocity.csv is shorter than its columns are late.");
}

TEST(ReadLog, LeavesAnotherVelocityFileAsItIs) {
  LogFiles files = Corrected();
  files["other.csv"] = "t,p\n0.5,1\n0.6,2\n";
  const Log log = ReadLog(FolderWith(files), {.velocity = "other.csv"});
  EXPECT_THAT(*log.velocity->Find("p"), ElementsAre(1, 2));
}

TEST(ReadLog, RefusesCorrectionsOfWhatIsNotThere) {
  EXPECT_EQ(RefusalOf({}, {.corrections = {{"p", -1}}}),
            "--correct: corrects 'p', which is no column of velocity.csv, expected one of: u.");
  EXPECT_EQ(RefusalOf({{"log.yaml", "name: a\ndof: surge\ncorrect: {p: -1}\n"}}),
            "log.yaml: corrects 'p', which is no column of velocity.csv, expected one of: u.");
  EXPECT_THAT(
      RefusalOf({{"velocity.csv", "-"}, {"pose.csv", kReadPose}}, {.corrections = {{"u", -1}}}),
      StartsWith("--correct: corrects columns of velocity.csv, but "));
  const auto error = [](const std::string& factors) {
    return RefusalOf({{"log.yaml", "name: a\ndof: surge\ncorrect: " + factors + "\n"}});
  };
  EXPECT_EQ(error("{u: 0}"), "log.yaml:3: key 'correct.u' is 0, expected a factor that is not 0.");
  EXPECT_EQ(error("{u: .inf}"), "log.yaml:3: key 'correct.u' is '.inf', expected a finite number.");
  EXPECT_EQ(error("{up: -1}"),
            "log.yaml:3: key 'correct.up' is not known here, expected one of: u, v, w, p, q, r. "
            "Correct or remove it.");
}

}  // namespace
}  // namespace fathom
