// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Logs of MOOS, written here as pLogger writes them, and two of a kayak.

#include "fathom/import/moos/alog_recording.h"

#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "real_data.h"
#include "scratch_file.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using RealAlogs = OnRealData;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kAlogHead =
    "%%%%%%%%%%%%%%%%%%%%\n"
    "%% LOG FILE:       ./run.alog\n"
    "%% FILE OPENED ON  Thu Jan  1 00:00:12 1970\n"
    "%% LOGSTART           1700000000.25\n"
    "%%%%%%%%%%%%%%%%%%%%\n";

// Columns as wide as pLogger makes them; a longer name touches the next one.
template <typename Value>
std::string AlogLine(double time,
                     const std::string& variable,
                     const Value& value,
                     const std::string& source = "uSim") {
  return fmt::format("{:<15.3f} {:<20} {:<10} {} \n", time, variable, source, value);
}

std::vector<double> ValuesOf(const Recording& recording, const std::string& variable) {
  std::vector<double> values;
  for (const auto& row : ReadAll(recording, {variable, {"value"}}).rows) {
    values.push_back(row.front());
  }
  return values;
}

TEST(Alog, IsReadByVariablesWhoseStampsCountFromLogstart) {
  const auto recording = OpenRecording(ScratchFile(
      "run.log",
      kAlogHead + AlogLine(0.5, "NAV_X", 1.5) + AlogLine(0.625, "NAV_Y", "-2e-05") +
          AlogLine(1, "A_NAME_THAT_IS_LONGER_THAN_ITS_COLUMN", 7, "pHelmIvP:HELM_STARTUP_MSG") +
          AlogLine(1.5, "NAV_X", 2.5)));
  const Contents& contents = recording->contents();
  EXPECT_EQ(contents.format, "alog");
  EXPECT_TRUE(contents.IsComplete());
  EXPECT_EQ(contents.utc_of_zero, 1700000000.25);
  EXPECT_THAT(contents.remarks, IsEmpty());
  ASSERT_EQ(contents.channels.size(), 3U);
  const Channel x = ChannelNamed(contents, "NAV_X");
  EXPECT_EQ(x.count, 2U);
  EXPECT_EQ(x.first, 0.5);
  EXPECT_EQ(x.last, 1.5);
  EXPECT_THAT(ReadAll(*recording, {"NAV_X", {"value"}}).time, ElementsAre(0.5, 1.5));
  EXPECT_THAT(ValuesOf(*recording, "NAV_X"), ElementsAre(1.5, 2.5));
  EXPECT_THAT(ValuesOf(*recording, "NAV_Y"), ElementsAre(-2e-5));
  EXPECT_THAT(ValuesOf(*recording, "A_NAME_THAT_IS_LONGER_THAN_ITS_COLUMN"), ElementsAre(7));
}

TEST(Alog, CountsTextsAndReadsTheNumbersBesideThem) {
  const auto recording = OpenRecording(
      ScratchFile("run.alog",
                  kAlogHead + AlogLine(1, "MODE", 3) + AlogLine(2, "MODE", "PARK, x = 1!@#y") +
                      AlogLine(3, "MODE", "") + AlogLine(4, "MODE", 5) +
                      AlogLine(4, "MOOS_DEBUG", "YAW_PID_KP             = 0.500")));
  EXPECT_THAT(ValuesOf(*recording, "MODE"), ElementsAre(3, 5));
  EXPECT_EQ(recording->contents().channels.size(), 1U);
  EXPECT_TRUE(recording->contents().IsComplete());
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre("values that are texts are not read: MODE 2 of 4.",
                          "variables of texts alone are not read: MOOS_DEBUG 1."));
}

TEST(Alog, HasNoNumberWhereTheVehicleHadNone) {
  const auto recording = OpenRecording(
      ScratchFile("run.alog", kAlogHead + AlogLine(1, "A", "nan") + AlogLine(2, "A", "-inf")));
  const auto values = ValuesOf(*recording, "A");
  ASSERT_EQ(values.size(), 2U);
  EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[1]));
}

// pLogger marks them where its MarkDataType is on: a text may then look like a number.
TEST(Alog, TellsNumbersAndTextsByTheirMarks) {
  const auto recording =
      OpenRecording(ScratchFile("run.alog",
                                "%% LOGSTART 1700000000\n%% DATATYPE MARKING ON\n" +
                                    AlogLine(1, "A", "D:1.5") + AlogLine(2, "A", "S:2.5")));
  EXPECT_THAT(ValuesOf(*recording, "A"), ElementsAre(1.5));
  EXPECT_THAT(recording->contents().remarks, Contains(HasSubstr("A 1 of 2")));
}

TEST(Alog, ReadsALineThatStandsTwiceOnce) {
  const std::string block = AlogLine(0.1, "A", 1) + AlogLine(0.2, "A", 1) + AlogLine(0.2, "B", 4);
  const auto recording = OpenRecording(
      ScratchFile("run.alog", kAlogHead + block + block + AlogLine(0.2, "A", 1, "pOther")));
  EXPECT_THAT(ReadAll(*recording, {"A", {"value"}}).time, ElementsAre(0.1, 0.2, 0.2));
  EXPECT_EQ(ChannelNamed(recording->contents(), "B").count, 1U);
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre("3 lines of the same time, variable, source and value as an earlier one: "
                          "read once."));
}

TEST(Alog, SaysThatNoLogstartTellsTheUtc) {
  const auto recording =
      OpenRecording(ScratchFile("run.alog", "%% LOG FILE:  ./run.alog\n" + AlogLine(1, "A", 3)));
  EXPECT_EQ(recording->contents().utc_of_zero, std::nullopt);
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre("there is no LOGSTART in seconds: the UTC of the stamps is not known."));
  // Nor does a file without any head, which its name tells.
  const auto headless = OpenRecording(ScratchFile("bare.alog", AlogLine(1, "A", 3)));
  EXPECT_EQ(headless->contents().format, "alog");
  EXPECT_EQ(headless->contents().utc_of_zero, std::nullopt);
}

TEST(Alog, KnowsStampsThatAreUtcThemselves) {
  const auto recording =
      OpenRecording(ScratchFile("run.alog", kAlogHead + AlogLine(1700000001, "A", 3)));
  EXPECT_EQ(recording->contents().utc_of_zero, 0.0);
}

TEST(Alog, IsReadUpToALineThatIsCut) {
  const std::string sound = kAlogHead + AlogLine(1, "A", 3);
  const auto recording = OpenRecording(ScratchFile("run.alog", sound + "2.000   A   uSim   3.1"));
  EXPECT_THAT(ValuesOf(*recording, "A"), ElementsAre(3));
  EXPECT_EQ(recording->contents().read_bytes, sound.size());
  EXPECT_THAT(
      recording->contents().remarks,
      ElementsAre(fmt::format("the log is cut or damaged at byte {}: what is before it is read.",
                              sound.size())));
}

TEST(Alog, IsReadUpToWhatIsNoText) {
  const std::string sound = kAlogHead + AlogLine(1, "A", 3);
  const auto recording = OpenRecording(
      ScratchFile("run.alog", sound + std::string(5, '\0') + "\n" + AlogLine(2, "A", 4)));
  EXPECT_THAT(ValuesOf(*recording, "A"), ElementsAre(3));
  EXPECT_EQ(recording->contents().read_bytes, sound.size());
  EXPECT_THAT(recording->contents().remarks,
              Contains(HasSubstr(fmt::format("damaged at byte {}", sound.size()))));
}

TEST(Alog, PassesOverLinesOfAnotherFormAndNamesTheFirst) {
  for (const std::string end : {"\n", "\r\n"}) {
    const std::string sound = "%% LOGSTART 1700000000" + end + "1 A uSim 3" + end;
    const std::string damage = "2 A" + end + "oops NAV_X uSim 4" + end;
    const std::string bytes = sound + damage + end + "3 A uSim 5" + end;
    const auto recording = OpenRecording(ScratchFile("run.alog", bytes));
    EXPECT_THAT(ValuesOf(*recording, "A"), ElementsAre(3, 5));
    EXPECT_EQ(recording->contents().read_bytes, bytes.size() - damage.size());
    EXPECT_THAT(recording->contents().remarks,
                ElementsAre(fmt::format("2 lines not of the form 'time variable source value', the "
                                        "first at byte {}: passed over.",
                                        sound.size())));
  }
}

TEST(Alog, WithoutANumberIsRefused) {
  const auto file = ScratchFile("run.alog", kAlogHead + AlogLine(1, "MODE", "PARK"));
  EXPECT_THAT(ErrorFrom([&] { OpenRecording(file); }),
              HasSubstr("run.alog: holds no line with a number, expected an .alog of MOOS"));
}

// Of the table that pLogger writes beside it the head is the same.
TEST(Alog, IsNotTheTableOfTheSameLogger) {
  EXPECT_TRUE(LooksLikeAlog(kAlogHead));
  EXPECT_FALSE(LooksLikeAlog(kAlogHead + "%%   (1) TIME \n%%   (2) NAV_X\n"));
  EXPECT_FALSE(LooksLikeAlog("%% a cell of MATLAB\nx = 1;\n"));
}

// A vehicle that heads east and moves there at 2 m/s, with the rudder at 10 deg.
std::string AlogDive(const std::vector<std::pair<std::string, double>>& headings) {
  std::string bytes = kAlogHead;
  for (int i = 0; i < 10; ++i) {
    const double time = 0.25 * i;
    bytes += AlogLine(time, "NAV_X", 2.0 * time) + AlogLine(time, "NAV_Y", 3) +
             AlogLine(time, "NAV_SPEED", 2) + AlogLine(time, "NAV_DEPTH", 4) +
             AlogLine(time, "DESIRED_THRUST", i % 2 == 0 ? 50 : 60) +
             AlogLine(time, "DESIRED_RUDDER", 10);
    for (const auto& [variable, value] : headings) bytes += AlogLine(time, variable, value);
  }
  return bytes;
}

void ExpectTheDiveOf(const std::vector<std::pair<std::string, double>>& headings) {
  const auto file = ScratchFile("dive.alog", AlogDive(headings));
  const auto recording = OpenRecording(file);
  const SuggestedMap map = SuggestMap(*recording, {});
  EXPECT_FALSE(map.is_ready);
  EXPECT_THAT(map.text, AllOf(HasSubstr("yours to know"), HasSubstr("Over ground, not surge")));
  const Log log =
      ImportLog(file, *recording, ParseImportMap("map.yaml", map.text), std::nullopt).log;
  EXPECT_EQ(log.start, 1700000000.25);
  EXPECT_EQ(log.command_unit, "%");
  EXPECT_THAT(log.command->columns, ElementsAre("tau_surge"));
  EXPECT_EQ(log.command->Find("tau_surge")->at(1), 60.0);
  EXPECT_DOUBLE_EQ(log.fins->Find("fin_rudder")->at(1), std::numbers::pi / 18.0);
  EXPECT_EQ(log.velocity->Find("u")->at(2), 2.0);
  EXPECT_NEAR(log.pose->Find("x")->at(2), 3.0, 1e-12);
  EXPECT_NEAR(log.pose->Find("y")->at(2), 1.0, 1e-12);
  EXPECT_NEAR(log.pose->Find("z")->at(2), 4.0, 1e-12);
  // A quarter turn about z, down: cos and sin of an eighth.
  EXPECT_NEAR(log.pose->Find("qz")->at(2), std::numbers::sqrt2 / 2.0, 1e-6);
  EXPECT_NEAR(log.pose->Find("qw")->at(2), std::numbers::sqrt2 / 2.0, 1e-6);
}

TEST(MoosMap, TurnsEastAndNorthAndTheCompassIntoOurAxes) {
  ExpectTheDiveOf({{"NAV_HEADING", 90.0}, {"NAV_YAW", 0.0}});
}

TEST(MoosMap, TakesTheYawThatCountsTheOtherWayWhereThereIsNoHeading) {
  ExpectTheDiveOf({{"NAV_YAW", -1.5707963}});
}

TEST(MoosMap, NamesNoPositionWithoutAnAttitude) {
  const SuggestedMap map = SuggestMap(*OpenRecording(ScratchFile("dive.alog", AlogDive({}))), {});
  EXPECT_THAT(map.text, AllOf(HasSubstr("no NAV_HEADING or NAV_YAW"), Not(HasSubstr("NAV_X"))));
  EXPECT_TRUE(ParseImportMap("map.yaml", map.text).pose->Find("z") != nullptr);
}

TEST(MoosMap, IsACommentWhereNothingIsKnown) {
  const auto recording =
      OpenRecording(ScratchFile("a.alog", kAlogHead + AlogLine(1, "A", 1) + AlogLine(2, "A", 1)));
  EXPECT_FALSE(SuggestMap(*recording, {}).NamesAStream());
}

// Counted and read by hand: realdata/formats/moos/README.md.
TEST_F(RealAlogs, OfAKayakHoldWhatTheirReadmeSays) {
  for (const auto& [name, num_rudders] :
       {std::pair{"kayak_2008_start.alog", 4U}, {"kayak_2008_clip.alog", 3U}}) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(folder_ / "formats" / "moos" / name);
    const Contents& contents = recording->contents();
    EXPECT_EQ(contents.format, "alog");
    EXPECT_TRUE(contents.IsComplete());
    EXPECT_EQ(contents.utc_of_zero, 1212385118.5);
    EXPECT_EQ(ChannelNamed(contents, "NAV_X").count, 52U);
    EXPECT_EQ(ChannelNamed(contents, "NAV_Y").count, 52U);
    EXPECT_EQ(ChannelNamed(contents, "NAV_X").first, 0.625);
    EXPECT_EQ(ChannelNamed(contents, "NAV_X").last, 13.451);
    EXPECT_EQ(ChannelNamed(contents, "DESIRED_THRUST").count, 3U);
    EXPECT_EQ(ChannelNamed(contents, "DESIRED_RUDDER").count, num_rudders);
    EXPECT_THAT(ReadAll(*recording, {"DESIRED_THRUST", {"value"}}).time,
                ElementsAre(1.226, 6.037, 10.842));
    EXPECT_THAT(ValuesOf(*recording, "DESIRED_THRUST"), ElementsAre(0, 0, 0));
    EXPECT_THAT(ValuesOf(*recording, "NAV_X"), Each(0));  // the kayak was not under way
    EXPECT_THAT(contents.remarks,
                ElementsAre("variables of texts alone are not read: MOOS_DEBUG 12."));
  }
}

}  // namespace
}  // namespace fathom
