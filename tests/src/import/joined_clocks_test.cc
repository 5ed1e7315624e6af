// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/joined_clocks.h"

#include "fathom/import/open_recording.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "dataflash_writer.h"
#include "scratch_file.h"
#include "test_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using namespace dataflash;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

void WriteBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

// A log of one start of the vehicle: ATT at 0, 1, 2 and 3 s. Its GPS, if it has a fix, tells that
// it began `start` seconds into week 2418.
std::string LogOfAStart(std::optional<int> start, double roll) {
  std::string bytes = Fmt(128, 89, "FMT", "BBnNZ", "Type,Length,Name,Format,Columns") + FmtOfAtt() +
                      Fmt(40, 18, "GPS", "QBIH", "TimeUS,Status,GMS,GWk");
  for (int second = 0; second < 4; ++second) bytes += Att(second * 1000000, roll, second, 0.0F);
  if (start) {
    bytes += Message(40,
                     Bytes<std::uint64_t>(2000000) + Bytes<std::uint8_t>(3) +
                         Bytes<std::uint32_t>((*start + 2) * 1000) + Bytes<std::uint16_t>(2418));
  }
  return bytes;
}

TEST(JoinedClocks, TwoStartsLieAsFarApartAsTheirUtcTells) {
  const auto folder = EmptyTestFolder();
  WriteBytes(folder / "1.BIN", LogOfAStart(200, 2.0));
  WriteBytes(folder / "2.BIN", LogOfAStart(100, 1.0));
  const auto recording = OpenRecording(folder);
  const ReadSamples read = ReadAll(*recording, {"ATT", {"Roll"}});
  EXPECT_THAT(read.time, ElementsAre(0.0, 1.0, 2.0, 3.0, 100.0, 101.0, 102.0, 103.0));
  EXPECT_THAT(read.rows[3], ElementsAre(1.0));
  EXPECT_THAT(read.rows[4], ElementsAre(2.0));
  EXPECT_EQ(*ChannelNamed(recording->contents(), "ATT").last, 103.0);
  // Week 2418 begins on 2026-05-10; GPS is 18 s ahead.
  EXPECT_EQ(*recording->contents().utc_of_zero, 1778371200.0 + 100.0 - 18.0);
  EXPECT_THAT(
      recording->contents().remarks,
      Contains(AllOf(HasSubstr("1.BIN: its stamps are moved by 100.000 s"), HasSubstr("2.BIN"))));
}

TEST(JoinedClocks, TwoStartsWithoutUtcAreRefusedByName) {
  for (const std::optional<int> start : {std::optional<int>(), std::optional(100)}) {
    const auto folder = EmptyTestFolder();
    WriteBytes(folder / "1.BIN", LogOfAStart(start, 1.0));
    WriteBytes(folder / "2.BIN", LogOfAStart(std::nullopt, 2.0));
    const auto recording = OpenRecording(folder);
    EXPECT_THAT(recording->contents().remarks, Contains(HasSubstr("1.BIN and 2.BIN count")));
    EXPECT_THAT(ErrorFrom([&] {
                  ReadAll(*recording, {"ATT", {"Roll"}});
                }),
                AllOf(HasSubstr("1.BIN and 2.BIN count their stamps from two starts"),
                      HasSubstr("'ATT'"),
                      HasSubstr("Import each by itself.")));
  }
}

Contents ContentsWith(const std::string& format,
                      std::optional<double> utc_of_zero,
                      double first,
                      double last) {
  Contents contents;
  contents.format = format;
  contents.channels = {{"s", "T", {}, 10, first, last}};
  contents.utc_of_zero = utc_of_zero;
  return contents;
}

TEST(JoinedClocks, PartsOfOneStartAreNotMovedByTheErrorOfGps) {
  const Contents one = ContentsWith("dataflash", 1.7e9 + 0.4, 0.0, 60.0);
  const Contents two = ContentsWith("dataflash", 1.7e9, 60.1, 90.0);
  const JoinedClocks joined = JoinClocks({{"1", &one}, {"2", &two}});
  EXPECT_THAT(joined.shifts, ElementsAre(0.0, 0.0));
  EXPECT_THAT(joined.remarks, IsEmpty());
}

TEST(JoinedClocks, ABootClockIsMovedToTheStampsOfAStation) {
  const Contents boot = ContentsWith("dataflash", 1.7e9, 0.0, 60.0);
  const Contents station = ContentsWith("tlog", 0.0, 1.7e9, 1.7e9 + 70.0);
  const JoinedClocks joined = JoinClocks({{"a.BIN", &boot}, {"a.tlog", &station}});
  EXPECT_THAT(joined.shifts, ElementsAre(1.7e9, 0.0));
  EXPECT_EQ(*joined.utc_of_zero, 0.0);
}

TEST(JoinedClocks, AFileWithoutUtcMayFollowOneOfTheSameStart) {
  const Contents one = ContentsWith("ulog", std::nullopt, 0.0, 60.0);
  const Contents two = ContentsWith("ulog", 1.7e9, 60.5, 90.0);
  const JoinedClocks joined = JoinClocks({{"1", &one}, {"2", &two}});
  EXPECT_THAT(joined.shifts, ElementsAre(0.0, 0.0));
  EXPECT_THAT(joined.conflicts, IsEmpty());
  EXPECT_FALSE(joined.utc_of_zero);
  // With a third, of another start, it may be of either.
  const Contents three = ContentsWith("ulog", 1.7e9 + 500.0, 0.0, 30.0);
  const auto conflicts = JoinClocks({{"1", &one}, {"2", &two}, {"3", &three}}).conflicts;
  ASSERT_EQ(conflicts.size(), 2U);
  EXPECT_THAT(conflicts[0].why, HasSubstr("1 and 2"));
  EXPECT_THAT(conflicts[1].why, HasSubstr("1 and 3"));
}

TEST(JoinedClocks, TablesAreNotMoved) {
  const Contents one = ContentsWith("csv", std::nullopt, 0.0, 60.0);
  const Contents two = ContentsWith("csv", std::nullopt, 0.0, 60.0);
  EXPECT_THAT(JoinClocks({{"1", &one}, {"2", &two}}).conflicts, IsEmpty());
}

}  // namespace
}  // namespace fathom
