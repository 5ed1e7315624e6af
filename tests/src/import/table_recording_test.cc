// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/table/table_recording.h"

#include "fathom/base/random_stream.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "scratch_file.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsNan;
using ::testing::Not;

std::string Table(int num_rows) {
  std::string text = "t [s],u [m/s]\n";
  for (int i = 0; i < num_rows; ++i) text += fmt::format("{:.1f},{:.2f}\n", 0.1 * i, 0.01 * i);
  return text;
}

std::unique_ptr<Recording> OpenText(const std::string& text, const TableOptions& options = {}) {
  return OpenTable(ScratchFile("table.csv", text), options);
}

TEST(TableRecording, ListsColumnsOfNumbersWithTheirUnits) {
  const auto recording = OpenText("t [s],u [m/s],mode\n0,1,A\n1,2,B\n2,,C\n");
  const Contents& contents = recording->contents();
  const Channel channel = ChannelNamed(contents, "table");
  EXPECT_EQ(channel.count, 3U);
  EXPECT_EQ(*channel.last, 2.0);
  ASSERT_EQ(channel.fields.size(), 2U);
  EXPECT_EQ(channel.fields[1].name, "u");
  EXPECT_EQ(channel.fields[1].unit, "m/s");
  EXPECT_THAT(contents.remarks, IsEmpty());
  const ReadSamples samples = ReadAll(*recording, {"table", {"u"}});
  EXPECT_THAT(samples.rows, ElementsAre(ElementsAre(1), ElementsAre(2), ElementsAre(IsNan())));
}

TEST(TableRecording, CountsRowsAndCellsThatItCannotUse) {
  const auto recording = OpenText("t [s],u [m/s]\n0,1\n1,2\n2,err\n3\n4,5,6\n,7\n5,8\n6,9\n");
  EXPECT_THAT(recording->contents().remarks,
              ElementsAre(HasSubstr("line 4: column 'u' is 'err': 1 cell of the column"),
                          HasSubstr("2 rows passed over, the first on line 5: expected 2 cells."),
                          HasSubstr("1 row without a stamp passed over.")));
  EXPECT_EQ(recording->contents().channels[0].count, 5U);
}

TEST(TableRecording, TellsWhereACutFileEnds) {
  const std::string text = Table(50) + "5.0";
  const auto recording = OpenText(text);
  EXPECT_FALSE(recording->contents().IsComplete());
  EXPECT_EQ(recording->contents().read_bytes, text.size() - 3);
  EXPECT_THAT(recording->contents().remarks, Contains(HasSubstr("the file ends within a row")));
}

TEST(TableRecording, StepsOverAByteOrderMark) {
  const auto recording = OpenText("\xef\xbb\xbf" + Table(5));
  EXPECT_EQ(ChannelNamed(recording->contents(), "table").count, 5U);
  EXPECT_EQ(recording->contents().channels[0].fields[0].name, "t");
}

TEST(TableRecording, DoesWhatItsOptionsSay) {
  TableOptions options;
  options.separator = ';';
  options.decimal = ',';
  options.header_line = 2;
  options.time = "clock";
  options.time_unit = "min";
  const auto recording = OpenText("units;of;course\nclock;a;b\n-;V;A\n1,5;2;3\n2,5;4;5\n", options);
  const ReadSamples samples = ReadAll(*recording, {"table", {"b"}});
  EXPECT_THAT(samples.time, ElementsAre(90.0, 150.0));
  EXPECT_THAT(samples.rows, ElementsAre(ElementsAre(3), ElementsAre(5)));
  EXPECT_EQ(recording->contents().channels[0].fields[2].unit, "A");
}

TEST(TableRecording, TakesTheFirstColumnThatGrowsForStampsOrHasNone) {
  EXPECT_TRUE(OpenText("a,b\n0,1\n1,0\n2,1\n")->contents().channels[0].first);
  EXPECT_FALSE(OpenText("a,b\n0,1\n1,0\n0,1\n")->contents().channels[0].first);
}

// A table that was saved with its index: a row is no second.
TEST(TableRecording, TakesAColumnThatIsCalledATimeBeforeACounterOfRows) {
  const auto recording =
      OpenText(",original_timestamp,u\n0,1717171717000,1\n1,1717171717100,2\n2,1717171717200,3\n");
  const ReadSamples samples = ReadAll(*recording, {"table", {"u"}});
  EXPECT_NEAR(samples.time[2] - samples.time[0], 0.2, 1e-6);
  EXPECT_FALSE(recording->contents().channels[0].clock_counts_rows);
}

// Milliseconds that are called "stamp" are seconds to us: how to say what they are.
TEST(TableRecording, TellsHowToSayTheUnitOfItsStamps) {
  EXPECT_THAT(OpenText("stamp,u\n100,1\n200,2\n300,3\n")->contents().remarks,
              Contains(AllOf(HasSubstr("column 'stamp' states no unit: its stamps are taken as "
                                       "seconds. Where they are in another"),
                             HasSubstr("'table: {time_unit: ms}'"))));
  for (const char* name : {"stamp_ms", "stamp [ms]", "stamp (ms)"}) {
    const auto recording = OpenText(std::string(name) + ",u\n100,1\n200,2\n300,3\n");
    EXPECT_NEAR(*recording->contents().channels[0].last - *recording->contents().channels[0].first,
                0.2,
                1e-9)
        << name;
  }
}

TEST(TableRecording, TakesAnyColumnThatGrowsBeforeACounterOfRows) {
  const auto recording = OpenText("n,clk,u\n7,0.5,1\n8,0.6,0\n9,0.7,1\n10,0.8,0\n");
  EXPECT_EQ(recording->contents().channels[0].clock->name, "clk");
}

TEST(TableRecording, SaysWhereOnlyACounterOfRowsCouldBeTheStamps) {
  const auto recording = OpenText("n,u\n0,1\n1,2\n2,0\n3,1\n");
  EXPECT_TRUE(recording->contents().channels[0].clock_counts_rows);
  EXPECT_THAT(recording->contents().remarks, Contains(HasSubstr("column 'n' counts the rows")));
  // A name that says time makes stamps of it.
  EXPECT_FALSE(OpenText("t,u\n0,1\n1,2\n2,0\n")->contents().channels[0].clock_counts_rows);
}

// A word of a name that says time does not make a clock of what goes up and down.
TEST(TableRecording, TakesNoColumnForStampsThatDoesNotGrow) {
  const auto recording = OpenText("a,response_time,u\n0.0,3,1\n0.1,1,2\n0.2,2,0\n");
  EXPECT_EQ(recording->contents().channels[0].clock->name, "a");
}

TEST(TableRecording, SaysThatNamesAreMoreThanCells) {
  const auto recording = OpenText("index,t,u,tau\n0,1,0\n0.1,2,0\n0.2,3,0\n");
  EXPECT_THAT(recording->contents().remarks,
              Contains(HasSubstr("line 1 has 4 names, the rows 3 cells")));
  EXPECT_THAT(OpenText("# Pool, hall 2\n0,1,0,5\n0.1,2,0,5\n0.2,3,0,5\n")->contents().remarks,
              Contains(HasSubstr("line 1 has 2 names, the rows 4 cells")));
  EXPECT_THAT(OpenText("Test of a boat\n0,1,0\n0.1,2,0\n0.2,3,0\n")->contents().remarks,
              Not(Contains(HasSubstr("names"))));
}

TEST(TableRecording, SaysThatNanosecondsLackTheirZeros) {
  std::string text = "time,u\n";
  for (int i = 0; i < 100; ++i)
    text += fmt::format("{}.{},1\n", i / 10, i % 10 * 100000000 + 20000000);
  const auto recording = OpenText(text);
  EXPECT_THAT(recording->contents().remarks,
              Contains(HasSubstr("have 8 to 9 digits behind the point")));
}

TEST(TableRecording, RefusesWhatIsNoTable) {
  EXPECT_THAT(ErrorFrom([] { OpenText("Once upon a time\nthere was an ROV\n"); }),
              HasSubstr("hold no rows of numbers"));
  EXPECT_THAT(ErrorFrom([] { OpenText(Table(5) + std::string("1,\0\n", 4)); }),
              HasSubstr("table.csv:7: holds a NUL byte"));
  EXPECT_THAT(ErrorFrom([] { OpenText("date,u\n03/05/2026,1\n03/05/2026,2\n04/05/2026,3\n"); }),
              HasSubstr("A date with slashes may have day or month first"));
  TableOptions options;
  options.time = "clock";
  EXPECT_THAT(ErrorFrom([&] { OpenText(Table(5), options); }), HasSubstr("has no column 'clock'"));
}

TEST(TableRecording, DeliversAllBeforeACut) {
  const std::string all = Table(300);
  const std::size_t head = Table(10).size();
  RandomStream random(3, "cuts");
  for (int trial = 0; trial < 100; ++trial) {
    const auto length =
        head + static_cast<std::size_t>(random.Uniform() * static_cast<double>(all.size() - head));
    const std::string cut = all.substr(0, length);
    const auto recording = OpenText(cut);
    const auto num_whole = static_cast<std::size_t>(std::count(cut.begin(), cut.end(), '\n')) - 1;
    EXPECT_GE(recording->contents().channels[0].count, num_whole);
    EXPECT_LE(recording->contents().channels[0].count, num_whole + 1);
  }
}

}  // namespace
}  // namespace fathom
