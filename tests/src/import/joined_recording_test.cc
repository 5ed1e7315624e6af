// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/joined_recording.h"

#include "fathom/import/open_recording.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scratch_file.h"
#include "test_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

void Write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

TEST(JoinedRecording, AFolderOfTablesHasAChannelForEach) {
  const auto folder = EmptyTestFolder();
  Write(folder / "dvl.csv", "t,u\n0,1.0\n1,1.5\n2,2.0\n");
  Write(folder / "thrust.csv", "t,force\n0,10\n0.5,12\n1,14\n1.5,16\n");
  Write(folder / "readme.md", "# A dive\n");
  const auto recording = OpenRecording(folder);
  EXPECT_EQ(recording->contents().format, "csv");
  EXPECT_EQ(ChannelNamed(recording->contents(), "dvl").count, 3U);
  EXPECT_EQ(ChannelNamed(recording->contents(), "thrust").count, 4U);
  EXPECT_THAT(ReadAll(*recording, {"thrust", {"force"}}).rows[3], ElementsAre(16.0));
  EXPECT_THAT(recording->contents().remarks, Contains(HasSubstr("readme.md: is of no known")));
}

TEST(JoinedRecording, TablesOfOneNameStayApart) {
  const auto folder = EmptyTestFolder();
  Write(folder / "dvl.csv", "t,u\n0,1.0\n1,1.5\n2,2.0\n");
  Write(folder / "dvl.txt", "t,u\n0,7.0\n1,8.0\n2,9.0\n");
  const auto recording = OpenRecording(folder);
  EXPECT_EQ(ChannelNamed(recording->contents(), "dvl.csv/dvl").count, 3U);
  EXPECT_THAT(ReadAll(*recording, {"dvl.txt/dvl", {"u"}}).rows[2], ElementsAre(9.0));
}

// Two parts of one recording; the second has one sensor more, and its name sorts first.
TEST(JoinedRecording, PartsOfAChannelFollowEachOtherInTime) {
  const std::vector<Field> one = {{"a", ""}}, two = {{"b", ""}, {"a", ""}};
  class Part : public Recording {
   public:
    Part(std::vector<Field> fields, double first) : first_(first) {
      contents_.format = "test";
      contents_.channels = {{"s", "T", std::move(fields), 2, first, first + 1.0}};
    }
    const Contents& contents() const override { return contents_; }
    std::vector<std::string> Read(std::span<const Selection> selections,
                                  const SampleSink& sink) const override {
      for (std::size_t i = 0; i < selections.size(); ++i) {
        for (const double time : {first_, first_ + 1.0}) {
          std::vector<double> values;
          for (const std::string& field : selections[i].fields) {
            values.push_back(field == "a" ? time : -time);
          }
          sink(i, time, values);
        }
      }
      return {"is damaged."};
    }

   private:
    double first_;
    Contents contents_;
  };
  std::vector<RecordingPart> parts;
  parts.push_back({"dive_10", std::make_unique<Part>(two, 12.0)});
  parts.push_back({"dive_9", std::make_unique<Part>(one, 10.0)});
  const auto joined = JoinRecordings("dive", std::move(parts), {});
  const Channel channel = ChannelNamed(joined->contents(), "s");
  EXPECT_EQ(channel.count, 4U);
  EXPECT_EQ(*channel.first, 10.0);
  EXPECT_EQ(*channel.last, 13.0);
  const ReadSamples read = ReadAll(*joined, {"s", {"b", "a"}});
  EXPECT_THAT(read.time, ElementsAre(10.0, 11.0, 12.0, 13.0));
  EXPECT_TRUE(std::isnan(read.rows[0][0]));
  EXPECT_THAT(read.rows[3], ElementsAre(-13.0, 13.0));
  EXPECT_THAT(read.remarks, ElementsAre("dive_9: is damaged.", "dive_10: is damaged."));
}

TEST(JoinedRecording, AFolderWithoutRecordingsAndALogAreRefused) {
  const auto folder = EmptyTestFolder();
  EXPECT_THAT(ErrorFrom([&] { OpenRecording(folder); }), HasSubstr("holds no recording"));
  Write(folder / "notes.md", "no table");
  EXPECT_THAT(ErrorFrom([&] { OpenRecording(folder); }), HasSubstr("notes.md: is of no known"));
  Write(folder / "log.yaml", "name: dive\n");
  EXPECT_THAT(ErrorFrom([&] { OpenRecording(folder); }), HasSubstr("is a log already"));
}

TEST(ContentOfRecording, ChangesWithTheNamesAndBytesOfAFolder) {
  const auto folder = EmptyTestFolder();
  Write(folder / "a.csv", "t,u\n0,1\n1,2\n");
  const std::string before = ContentOfRecording(folder);
  EXPECT_EQ(ContentOfRecording(folder), before);
  std::filesystem::rename(folder / "a.csv", folder / "b.csv");
  const std::string renamed = ContentOfRecording(folder);
  EXPECT_NE(renamed, before);
  Write(folder / "b.csv", "t,u\n0,1\n1,3\n");
  EXPECT_NE(ContentOfRecording(folder), renamed);
}

}  // namespace
}  // namespace fathom
