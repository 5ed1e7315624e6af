// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_streams.h"

#include "fathom/log/read_log.h"

#include <string>

#include "error_from.h"
#include "log_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr char kDetections[] =
    "t,tag_id,u0,v0,u1,v1,u2,v2,u3,v3\n"
    "0.5,4,1,2,3,4,5,6,7,8\n0.5,2,1,2,3,4,5,6,7,9\n0.6,4,1,2,3,4,5,6,7,10\n"
    "0.7,4,1,2,3,4,5,6,7,11\n0.7,2,1,2,3,4,5,6,7,12\n";

TEST(ReadLog, ReadsALogOfNothingButDetections) {
  const Log log = ReadLog(FolderWith({{"velocity.csv", "-"}, {"detections.csv", kDetections}}));
  ASSERT_TRUE(log.detections);
  EXPECT_FALSE(log.velocity || log.pose);
  EXPECT_THAT(log.detections->time, ElementsAre(0.5, 0.5, 0.6, 0.7, 0.7));
  EXPECT_THAT(*log.detections->Find("v3"), ElementsAre(8, 9, 10, 11, 12));
  EXPECT_THAT(TextsOf(log.remarks), IsEmpty());
}

TEST(ReadLog, RefusesDetectionsItCannotUse) {
  std::string text = kDetections;
  text.replace(text.find("0.6,4"), 5, "0.6,4.5");
  EXPECT_EQ(RefusalOf({{"detections.csv", text}}),
            "detections.csv:4: column 'tag_id' is 4.5, expected a whole number from 0 on.");
  text = kDetections;
  text.replace(text.find("0.6,4"), 5, "0.6,-1");
  EXPECT_EQ(RefusalOf({{"detections.csv", text}}),
            "detections.csv:4: column 'tag_id' is -1, expected a whole number from 0 on.");
  EXPECT_EQ(RefusalOf({{"detections.csv", "t,tag_id,u0\n1,2,3\n"}}),
            "detections.csv:1: column 'v0' is missing, found t, tag_id, u0; expected t, tag_id, "
            "u0, v0, u1, v1, u2, v2, u3, v3.");
  text = kDetections;
  text.replace(text.find("0.7,4"), 5, "0.4,4");
  EXPECT_THAT(RefusalOf({{"detections.csv", text}}),
              StartsWith("detections.csv:5: column 't' goes back from 0.6 to 0.4"));
  text = "t,tag_id,u0,v0,u1,v1,u2,v2,u3,v3\n5,4,1,2,3,4,5,6,7,8\n5,3,1,2,3,4,5,6,7,8\n";
  EXPECT_EQ(RefusalOf({{"detections.csv", text}}),
            "detections.csv: column 't' is 5 in every row, expected at least two frames.");
  text = "t,tag_id,u0,v0,u1,v1,u2,v2,u3,v3\n50,4,1,2,3,4,5,6,7,8\n51,4,1,2,3,4,5,6,7,8\n";
  EXPECT_THAT(RefusalOf({{"detections.csv", text}}), HasSubstr("expected some time in common"));
}

TEST(ReadLog, RefusesCommandsThatAreUnclear) {
  EXPECT_EQ(RefusalOf({{"command.csv", "t,tau_surge,thruster_1\n0,1,2\n1,1,2\n"}}),
            "command.csv:1: holds both tau_* and thruster_* columns, expected forces or "
            "thrusters. Remove the one that was not commanded.");
  EXPECT_EQ(
      RefusalOf({{"command.csv", "t,thruster_1,thruster_3\n0,1,2\n1,1,2\n"}}),
      "command.csv:1: column 'thruster_2' is missing, expected thruster_1 to thruster_2 for 2 "
      "columns.");
  EXPECT_EQ(
      RefusalOf({{"command.csv", "t,force\n0,1\n1,1\n"}}),
      "command.csv:1: no column to read, found t, force; expected t and at least one of "
      "tau_surge, tau_sway, tau_heave, tau_roll, tau_pitch, tau_yaw, thruster_1, thruster_2, ..., "
      "fin_<name>, shaft_<name>.");
}

TEST(ReadLog, RefusesPosesThatAreNone) {
  EXPECT_EQ(RefusalOf({{"pose.csv", "t,x,y,z,qw,qx,qy\n0,1,2,3,1,0,0\n1,1,2,3,1,0,0\n"}}),
            "pose.csv:1: column 'qz' is missing, expected all of qx, qy, qz, qw for an attitude.");
  EXPECT_EQ(RefusalOf({{"pose.csv", "t,x,qx,qy,qz,qw\n0,1,0,0,0,1\n1,1,0,0,0,1\n"}}),
            "pose.csv:1: column 'y' is missing, expected all of x, y, z for a position.");
  EXPECT_THAT(RefusalOf({{"pose.csv", "t,roll\n0,1\n1,1\n"}}),
              HasSubstr("at least one of x, y, z, qx, qy, qz, qw"));
  EXPECT_EQ(RefusalOf({{"pose.csv", "t,z\n0.5,1\n0.6,1\n"}}), "no error");
  EXPECT_EQ(RefusalOf({{"pose.csv", "t,qx,qy,qz,qw\n0.5,0,0,0,1\n0.6,0,0,0,1\n"}}), "no error");
  const std::string header = "t,x,y,z,qx,qy,qz,qw\n0.5,1,2,3,0,0,0,1\n";
  EXPECT_EQ(
      RefusalOf({{"pose.csv", header + "0.6,1,2,3,0,0.6,0,0.7\n"}}),
      "pose.csv:3: columns 'qx', 'qy', 'qz', 'qw' have length 0.921954, expected a unit quaternion "
      "(within 0.001). Check the order of the columns.");
  EXPECT_EQ(RefusalOf({{"pose.csv", header + "0.6,1,2,3,0,0,0,0\n"}}),
            "pose.csv:3: columns 'qx', 'qy', 'qz', 'qw' have length 0, expected a unit quaternion "
            "(within "
            "0.001). Check the order of the columns.");
  EXPECT_EQ(RefusalOf({{"pose.csv", header + "0.6,1,2,3,0,0,0,1.0009\n"}}), "no error");
  EXPECT_THAT(RefusalOf({{"pose.csv", header + "0.6,1,2,3,0,0,0,1.0011\n"}}), HasSubstr("1.0011"));
  EXPECT_THAT(RefusalOf({{"pose.csv", header + "0.6,1,2,3,1e300,1e300,1e300,1e300\n"}}),
              HasSubstr("pose.csv:3: columns 'qx', 'qy', 'qz', 'qw' have length 2e+300"));
}

TEST(ReadLog, RefusesClocksWithNoTimeInCommon) {
  EXPECT_EQ(
      RefusalOf({{"command.csv", "t,tau_surge\n1433350623.5,1\n1433350624.5,2\n"}}),
      "command.csv: column 't' runs from 1433350623.5 to 1433350624.5, but that of velocity.csv "
      "from 0.5 to 0.7, expected some time in common. Put both on one clock.");
  EXPECT_THAT(
      RefusalOf({{"pose.csv", "t,x,y,z,qx,qy,qz,qw\n50,1,2,3,0,0,0,1\n51,1,2,3,0,0,0,1\n"}}),
      AllOf(StartsWith("command.csv: column 't' runs from 0 to 2, but that of pose.csv from 50")));
}

TEST(ReadLog, RefusesStampsThatAreNotSeconds) {
  EXPECT_EQ(
      RefusalOf({{"velocity.csv", "t,u\n500,0\n600,0.1\n700,0.2\n"}}),
      "velocity.csv: the median step of column 't' is 100, expected between 1e-5 and 10 seconds. "
      "Is it in ms, us or ns? Convert t to seconds.");
  EXPECT_EQ(
      RefusalOf({{"velocity.csv", "t,u\n0,0\n2e-6,0.1\n4e-6,0.2\n"}}),
      "velocity.csv: the median step of column 't' is 2e-06, expected between 1e-5 and 10 seconds. "
      "Is it in hours or days? Convert t to seconds.");
  EXPECT_EQ(RefusalOf({{"command.csv", "t,tau_surge\n0,1\n1000,2\n2000,0\n"}}),
            "command.csv: the median step of column 't' is 1000, expected between 1e-5 and 10 "
            "seconds. Is "
            "it in ms, us or ns? Convert t to seconds.");
  EXPECT_THAT(RefusalOf({{"command.csv", "t,tau_surge\n0,1\n1e-6,2\n1,0\n"}}), "no error");
  EXPECT_THAT(RefusalOf({{"command.csv", "t,tau_surge\n0.5,1\n0.500001,2\n0.500002,0\n"}}),
              StartsWith("command.csv: the median step of column 't' is 1"));
}

TEST(ReadLog, AllowsACommandThatIsHeldForLong) {
  EXPECT_EQ(RefusalOf({{"command.csv", "t,tau_surge\n0,1\n30,2\n60,0\n"},
                       {"velocity.csv", "t,u\n0,0\n9,0.1\n18,0.2\n27,0.2\n36,0\n"}}),
            "no error");
}

TEST(ReadLog, RefusesAFolderInPlaceOfAStream) {
  const auto folder = FolderWith({{"velocity.csv", "-"}});
  std::filesystem::create_directories(folder / "velocity.csv");
  EXPECT_EQ(ErrorFrom([&] { ReadLog(folder); }),
            (folder / "velocity.csv").string() + ": is a folder, expected a file.");
}

TEST(ReadLog, ReportsABadCellWithFileLineAndColumn) {
  EXPECT_EQ(
      RefusalOf({{"velocity.csv", "t,u\n0.5,0\n0.6,nan\n"}}),
      "velocity.csv:3: column 'u' is 'nan', expected a finite number. Remove the row or repair it "
      "upstream; this reader does not guess.");
}

}  // namespace
}  // namespace fathom
