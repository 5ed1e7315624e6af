// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/map_with_when.h"

#include "fathom/base/input_error.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "constant_recording.h"
#include "scratch_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

const std::string kStreams =
    "command:\n  channel: \"{channel}\"\n  tau_surge: {field: push, unit: N}\n";

Contents Table(const std::vector<std::pair<std::string, std::vector<std::string>>>& channels) {
  Contents contents;
  contents.format = "table";
  for (const auto& [name, fields] : channels) {
    Channel channel;
    channel.name = name;
    for (const std::string& field : fields) channel.fields.push_back({field, "", 0});
    contents.channels.push_back(channel);
  }
  return contents;
}

std::optional<SuggestedMap> Fitted(const MapWithWhen& map, const Contents& contents) {
  return map.For(ConstantRecording(contents, 12.0), std::nullopt);
}

std::string ProblemOf(const std::string& text) {
  return ErrorFrom([&] { MapWithWhen("lab.yaml", text); });
}

TEST(MapWithWhen, IsForARecordingThatMeetsEveryCondition) {
  const MapWithWhen map("lab.yaml",
                        "# Of the lab.\nwhen:\n  format: [table, mcap]\n  channels: [pose]\n"
                        "  fields: [push,\n           u]\n" +
                            kStreams);
  const auto fits = Fitted(map, Table({{"pose", {"x"}}, {"run", {"push", "u", "w"}}}));
  ASSERT_TRUE(fits.has_value());
  EXPECT_EQ(fits->text,
            "# Of the lab.\ncommand:\n  channel: \"run\"\n  tau_surge: {field: push, unit: N}\n");
  EXPECT_FALSE(fits->is_ready);
  EXPECT_FALSE(Fitted(map, Table({{"run", {"push", "u"}}})).has_value())
      << "no channel of that name";
  EXPECT_FALSE(Fitted(map, Table({{"pose", {"u"}}, {"run", {"push"}}})).has_value())
      << "no channel with both fields";
  Contents other = Table({{"pose", {"x"}}, {"run", {"push", "u"}}});
  other.format = "ulog";
  EXPECT_FALSE(Fitted(map, other).has_value());
}

TEST(MapWithWhen, NamesNoChannelWhereThereIsOneOnly) {
  const MapWithWhen map("lab.yaml", "when: {fields: [push], ready: true}\n" + kStreams);
  const auto fits = Fitted(map, Table({{"run", {"push"}}}));
  ASSERT_TRUE(fits.has_value());
  EXPECT_EQ(fits->text, "command:\n  tau_surge: {field: push, unit: N}\n");
  EXPECT_TRUE(fits->is_ready);
}

TEST(MapWithWhen, QuotesTheNameOfAChannel) {
  const MapWithWhen map("lab.yaml", "when: {fields: [push]}\n" + kStreams);
  const auto fits = Fitted(map, Table({{"a \"run\"\n", {"push"}}, {"pose", {"x"}}}));
  ASSERT_TRUE(fits.has_value());
  EXPECT_THAT(fits->text, HasSubstr("channel: \"a \\\"run\\\"\\x0a\"\n"));
}

// Two logs of one velocity, the second longer, and a battery.
Contents TwoLogs() {
  Contents contents = Table({{"dvl", {"u", "v"}}, {"dvl 2", {"u"}}, {"battery", {"volts"}}});
  for (Channel& channel : contents.channels) channel.count = 10;
  contents.channels[0].type = "lab/msg/Dvl";
  contents.channels[1].type = "lab/Dvl_m";
  contents.channels[1].count = 20;
  return contents;
}

std::string TextOf(const std::string& when, const std::string& lines) {
  const MapWithWhen map("lab.yaml", "when:\n  format: table\n" + when + lines);
  const auto fitted = Fitted(map, TwoLogs());
  return fitted ? fitted->text : "another recording";
}

TEST(MapWithWhen, FindsChannelsByTheirTypes) {
  const std::string find =
      "  find:\n    speed: [{type: lab/Imu}, {type: lab/Dvl, text: way.}]\n"
      "    sideways: [{type: lab/Dvl, field: v}]\n";
  const std::string lines =
      "#if speed\n{speed}, {speed.type}, {speed.text}{speed.others}, {x}\n#end\n";
  EXPECT_EQ(TextOf(find, lines), "dvl, lab/msg/Dvl, way.; 1 other may be it, {x}\n");
  EXPECT_EQ(TextOf("  take: most\n" + find, lines),
            "dvl 2, lab/Dvl_m, way.; 1 other may be it, {x}\n");
  EXPECT_EQ(TextOf("  take: most\n" + find, "#if sideways\n{sideways}{sideways.others}\n#end\n"),
            "dvl\n");
  EXPECT_EQ(TextOf("  has: [sideways.alone]\n" + find, lines).substr(0, 4), "dvl,");
  EXPECT_EQ(TextOf("  has: [speed.alone]\n" + find, lines), "another recording");
}

TEST(MapWithWhen, LooksAtTheNumbersOfAChannel) {
  // Every number of the recording is 12.
  const auto is_there = [](const std::string& limits) {
    return TextOf("  find: {supply: [{name: battery, field: volts, " + limits + "}]}\n",
                  "#if supply\nyes\n#else\nno\n#end\n");
  };
  EXPECT_EQ(is_there("above: 11.9"), "yes\n");
  EXPECT_EQ(is_there("above: 12"), "no\n");
  EXPECT_EQ(is_there("above: 0, below: 12"), "no\n");
  EXPECT_EQ(is_there("above: 0, below: 12.1"), "yes\n");
}

TEST(MapWithWhen, ShowsTheLinesWhoseConditionsHold) {
  const std::string find = "  find: {gps: [{type: lab/Gps}], speed: [{type: lab/Dvl}]}\n";
  EXPECT_EQ(TextOf(find,
                   "#if speed gps\na\n#else\nb\n#if !gps speed.v\nc\n#end\n#if gps\nd\n#if speed\n"
                   "e\n#else\nf\n#end\n#end\n#if speed.w\ng\n#end\n#end\nh\n"),
            "b\nc\nh\n");
}

TEST(MapWithWhen, IsReadyWhereItsConditionsHold) {
  const std::string head = "when:\n  format: table\n  find: {speed: [{type: lab/Dvl}]}\n";
  const auto is_ready = [&](const std::string& ready) {
    return Fitted(MapWithWhen("lab.yaml", head + "  ready: " + ready + "\n#if speed\n#end\n"),
                  TwoLogs())
        ->is_ready;
  };
  EXPECT_TRUE(is_ready("true"));
  EXPECT_FALSE(is_ready("false"));
  EXPECT_TRUE(is_ready("[speed]"));
  EXPECT_FALSE(is_ready("[speed, speed.alone]"));
}

TEST(MapWithWhen, SaysWhatIsWrong) {
  const std::string when = "when:\n  format: table\n";
  EXPECT_THAT(ProblemOf(when + "#if gps\n#end\n"), HasSubstr("lab.yaml:3: 'find' holds no 'gps'."));
  EXPECT_THAT(ProblemOf(when + "  has: [\"!gps\"]\n"), HasSubstr("'find' holds no '!gps'."));
  EXPECT_THAT(ProblemOf(when + "  ready: yes\n"), HasSubstr("'find' holds no 'yes'."));
  EXPECT_THAT(ProblemOf(when + "#if vehicle\n"), HasSubstr("an #if has no #end"));
  EXPECT_THAT(ProblemOf(when + "#if vehicle\n#end\n#end\n"), HasSubstr("lab.yaml:5: #end without"));
  EXPECT_THAT(ProblemOf(when + "  find: {vehicle: [{type: a}]}\n"), HasSubstr("of its own"));
  EXPECT_THAT(ProblemOf(when + "  take: last\n"), HasSubstr("neither 'first' nor 'most'"));
  EXPECT_THAT(ProblemOf(when + "  find: {gps: [{text: a}]}\n"),
              HasSubstr("says nothing of the channel"));
  EXPECT_THAT(ProblemOf(when + "  find: {gps: [{type: a, above: 0}]}\n"),
              HasSubstr("names no field"));
  EXPECT_THAT(ProblemOf(kStreams), HasSubstr("lab.yaml"));
  EXPECT_THAT(ProblemOf("when: {ready: true}\n" + kStreams),
              HasSubstr("names no condition, expected some of format, channels, fields"));
  EXPECT_THAT(ProblemOf("when: {formats: table}\n" + kStreams), HasSubstr("formats"));
  EXPECT_THAT(ProblemOf("when: {format: table}\n"), HasSubstr("names no stream"));
}

TEST(MapWithWhen, OfALabGoesBeforeWhatIsSuggestedOtherwise) {
  const std::filesystem::path file =
      ScratchFile("lab_maps/b.yaml", "when: {fields: [push]}\n" + kStreams);
  ScratchFile("lab_maps/a.yaml", "when: {fields: [pull]}\n" + kStreams);
  const std::vector<MapWithWhen> maps = ReadMapsWithWhen(file.parent_path());
  ASSERT_EQ(maps.size(), 2U);
  const auto recording = OpenRecording(ScratchFile("run.csv", "t,push,u\n0,1,2\n1,1,2\n2,1,2\n"));
  EXPECT_THAT(SuggestMap(*recording, std::nullopt).text, HasSubstr("By the names"));
  EXPECT_EQ(SuggestMap(*recording, std::nullopt, maps).text,
            "command:\n  tau_surge: {field: push, unit: N}\n");
  EXPECT_THROW(ReadMapsWithWhen(file.parent_path() / "none"), InputError);
}

}  // namespace
}  // namespace fathom
