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

std::string ProblemOf(const std::string& text) {
  try {
    MapWithWhen("lab.yaml", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MapWithWhen, IsForARecordingThatMeetsEveryCondition) {
  const MapWithWhen map("lab.yaml",
                        "# Of the lab.\nwhen:\n  format: [table, mcap]\n  channels: [pose]\n"
                        "  fields: [push,\n           u]\n" +
                            kStreams);
  const auto fits = map.For(Table({{"pose", {"x"}}, {"run", {"push", "u", "w"}}}));
  ASSERT_TRUE(fits.has_value());
  EXPECT_EQ(fits->text,
            "# Of the lab.\ncommand:\n  channel: \"run\"\n  tau_surge: {field: push, unit: N}\n");
  EXPECT_FALSE(fits->is_ready);
  EXPECT_FALSE(map.For(Table({{"run", {"push", "u"}}})).has_value()) << "no channel of that name";
  EXPECT_FALSE(map.For(Table({{"pose", {"u"}}, {"run", {"push"}}})).has_value())
      << "no channel with both fields";
  Contents other = Table({{"pose", {"x"}}, {"run", {"push", "u"}}});
  other.format = "ulog";
  EXPECT_FALSE(map.For(other).has_value());
}

TEST(MapWithWhen, NamesNoChannelWhereThereIsOneOnly) {
  const MapWithWhen map("lab.yaml", "when: {fields: [push], ready: true}\n" + kStreams);
  const auto fits = map.For(Table({{"run", {"push"}}}));
  ASSERT_TRUE(fits.has_value());
  EXPECT_EQ(fits->text, "command:\n  tau_surge: {field: push, unit: N}\n");
  EXPECT_TRUE(fits->is_ready);
}

TEST(MapWithWhen, QuotesTheNameOfAChannel) {
  const MapWithWhen map("lab.yaml", "when: {fields: [push]}\n" + kStreams);
  const auto fits = map.For(Table({{"a \"run\"\n", {"push"}}, {"pose", {"x"}}}));
  ASSERT_TRUE(fits.has_value());
  EXPECT_THAT(fits->text, HasSubstr("channel: \"a \\\"run\\\"\\x0a\"\n"));
}

TEST(MapWithWhen, SaysWhatIsWrong) {
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
