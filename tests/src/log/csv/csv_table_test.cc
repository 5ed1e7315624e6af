// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/csv/csv_table.h"

#include "fathom/base/files/output_file.h"

#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const CsvSpec kVelocity = {.required = {},
                           .at_least_one_of = {"u", "v", "w", "p", "q", "r"},
                           .numbered = "",
                           .allow_equal_stamps = false};
const CsvSpec kCommand = {.required = {},
                          .at_least_one_of = {"tau_surge", "tau_yaw"},
                          .numbered = "thruster_",
                          .allow_equal_stamps = false};
const CsvSpec kPose = {.required = {"x", "y", "qw"},
                       .at_least_one_of = {},
                       .numbered = "",
                       .allow_equal_stamps = false};

std::string Error(const std::string& text, const CsvSpec& spec = kVelocity) {
  return ErrorFrom([&] { ParseCsvTable("velocity.csv", text, spec); });
}

TEST(CsvTable, KeepsEveryNumberAndTheLineItStandsOn) {
  const CsvTable table = ParseCsvTable(
      "a.csv", "w,t,u\n-1.5,1433350639.315205,2e-3\n.25,1433350639.415340,-7\n", kVelocity);
  EXPECT_THAT(table.stream.columns, ElementsAre("w", "u"));
  EXPECT_THAT(table.stream.time, ElementsAre(1433350639.315205, 1433350639.415340));
  EXPECT_THAT(table.stream.values, ElementsAre(ElementsAre(-1.5, 0.25), ElementsAre(0.002, -7.0)));
  EXPECT_THAT(table.line_of_row, ElementsAre(2, 3));
  EXPECT_THAT(table.not_read, IsEmpty());
  EXPECT_EQ(table.Remark(), "");
}

TEST(CsvTable, AllowsQuotesAndSpacesAroundACellAndNoLineFeedAtTheEnd) {
  const CsvTable table = ParseCsvTable("a.csv", "\"t\", u\n0, \"1\"\n1 ,2", kVelocity);
  EXPECT_THAT(table.stream.time, ElementsAre(0, 1));
  EXPECT_THAT(table.stream.values, ElementsAre(ElementsAre(1, 2)));
}

TEST(CsvTable, ReadsNumberedColumns) {
  const CsvTable table =
      ParseCsvTable("a.csv", "t,thruster_2,thruster_10,thruster_x\n0,1,2,3\n1,4,5,6\n", kCommand);
  EXPECT_THAT(table.stream.columns, ElementsAre("thruster_2", "thruster_10"));
  EXPECT_THAT(table.not_read, ElementsAre("thruster_x"));
}

TEST(CsvTable, RemarksOnEveryColumnThatIsNotRead) {
  const CsvTable several =
      ParseCsvTable("log/velocity.csv", "t,u,du,sync\n0,0,a,1\n1,0,,1\n", kVelocity);
  EXPECT_EQ(several.Remark(), "velocity.csv: 2 further columns are not read: du, sync.");
  const CsvTable one = ParseCsvTable("log/velocity.csv", "t,u,du\n0,0,a\n1,0,\n", kVelocity);
  EXPECT_EQ(one.Remark(), "velocity.csv: 1 further column is not read: du.");
}

TEST(CsvTable, CutsAListOfVeryManyColumns) {
  std::string header = "t,u";
  std::string row = ",0";
  for (int i = 1; i <= 50; ++i) {
    header += ",s" + std::to_string(i);
    row += ",0";
  }
  const CsvTable table =
      ParseCsvTable("a.csv", header + "\n0" + row + "\n1" + row + "\n", kVelocity);
  EXPECT_THAT(table.Remark(), StartsWith("a.csv: 50 further columns are not read: s1, s2, "));
  EXPECT_THAT(table.Remark(), HasSubstr(", s40, ... (50 in all)."));
}

TEST(CsvTable, RefusesAFileThatCannotBeRead) {
  EXPECT_EQ(ErrorFrom([] { ReadCsvTable("no/such.csv", kVelocity); }),
            "no/such.csv: there is no such file. Check the path.");
  EXPECT_EQ(ErrorFrom([] { ReadCsvTable(FATHOM_DATA_DIR, kVelocity); }),
            FATHOM_DATA_DIR ": is a folder, expected a file.");
}

TEST(CsvTable, RefusesAnEmptyFileAndOneWithoutRows) {
  EXPECT_EQ(Error(""),
            "velocity.csv: is empty, expected a line of column names and rows of numbers.");
  EXPECT_EQ(Error("t,u\n"),
            "velocity.csv:1: no row after the column names, expected at least two rows.");
  EXPECT_EQ(Error("t,u\n0,1\n"),
            "velocity.csv:2: only one row after the column names, expected at least two rows.");
}

TEST(CsvTable, ListsFoundAndExpectedColumnsWhenOneIsMissing) {
  EXPECT_EQ(
      Error("u,v\n1,2\n"),
      "velocity.csv:1: column 't' is missing, found u, v; expected t and at least one of u, v, "
      "w, p, q, r.");
  EXPECT_EQ(
      Error("t,speed\n1,2\n"),
      "velocity.csv:1: no column to read, found t, speed; expected t and at least one of u, v, "
      "w, p, q, r.");
  EXPECT_EQ(Error("t,x,qw\n1,2,3\n", kPose),
            "velocity.csv:1: column 'y' is missing, found t, x, qw; expected t, x, y, qw.");
  EXPECT_EQ(Error("t,motor\n1,2\n", kCommand),
            "velocity.csv:1: no column to read, found t, motor; expected t and at least one of "
            "tau_surge, tau_yaw, thruster_1, thruster_2, ....");
}

TEST(CsvTable, RefusesAHeaderThatIsNone) {
  EXPECT_EQ(
      Error("0.0,1.5\n0.1,1.6\n"),
      "velocity.csv:1: the first line holds numbers, expected the column names t and at least "
      "one of u, v, w, p, q, r.");
  EXPECT_EQ(Error("t;u\n0;1\n"),
            "velocity.csv:1: the columns are separated by ';', expected commas.");
  EXPECT_EQ(Error("t\tu\n0\t1\n"),
            "velocity.csv:1: the columns are separated by tabs, expected commas.");
  EXPECT_EQ(Error("t,,u\n0,1,2\n"), "velocity.csv:1: column 2 has no name, expected one.");
}

TEST(CsvTable, RefusesARepeatedColumnName) {
  EXPECT_EQ(Error("t,u,v,u\n0,1,2,3\n"),
            "velocity.csv:1: column 'u' stands twice, as column 2 and 4. Remove or rename one.");
  EXPECT_EQ(Error("t,u,note,note\n0,1,2,3\n"),
            "velocity.csv:1: column 'note' stands twice, as column 3 and 4. Remove or rename one.");
}

TEST(CsvTable, NamesLineAndColumnOfWhatIsNoFiniteNumber) {
  const std::string advice = "Remove the row or repair it upstream; this reader does not guess.";
  const auto error = [](const std::string& cell) {
    return Error("t,u,v\n0,1,2\n1,1," + cell + "\n");
  };
  EXPECT_EQ(error("fast"),
            "velocity.csv:3: column 'v' is 'fast', expected a number such as -0.25. " + advice);
  EXPECT_EQ(error("1.2.3"),
            "velocity.csv:3: column 'v' is '1.2.3', expected a number such as -0.25. " + advice);
  for (const std::string cell : {"nan", "NaN", "-nan", "inf", "-inf", "Infinity", "+inf"}) {
    EXPECT_EQ(error(cell),
              "velocity.csv:3: column 'v' is '" + cell + "', expected a finite number. " + advice);
  }
  EXPECT_THAT(error("1e999"),
              StartsWith("velocity.csv:3: column 'v' is '1e999', expected a number"));
  EXPECT_EQ(error(""), "velocity.csv:3: column 'v' is empty, expected a finite number. " + advice);
  EXPECT_EQ(error("\"\""),
            "velocity.csv:3: column 'v' is empty, expected a finite number. " + advice);
  EXPECT_THAT(Error("t,u\nnow,1\n2,1\n"),
              StartsWith("velocity.csv:2: column 't' is 'now', expected"));
}

TEST(CsvTable, RefusesTimeThatGoesBack) {
  EXPECT_EQ(
      Error("t,u\n0,1\n0.5,1\n0.25,1\n"),
      "velocity.csv:4: column 't' goes back from 0.5 to 0.25, expected rising stamps. Sort the "
      "rows, or split the log where its clock was reset.");
}

TEST(CsvTable, RefusesAStampThatStandsTwice) {
  EXPECT_EQ(Error("t,u\n0,1\n0.5,1\n0.5,2\n"),
            "velocity.csv:4: column 't' is 0.5 as on line 3, expected rising stamps. Remove one of "
            "the two rows, or write t with more digits.");
}

TEST(CsvTable, AllowsEqualStampsWhereTheFormatHasThemButNoneThatGoBack) {
  CsvSpec tags = {
      .required = {"tag_id"}, .at_least_one_of = {}, .numbered = "", .allow_equal_stamps = true};
  EXPECT_THAT(ParseCsvTable("d.csv", "t,tag_id\n0,1\n0,2\n", tags).stream.time, ElementsAre(0, 0));
  EXPECT_THAT(Error("t,tag_id\n1,1\n0,2\n", tags), HasSubstr("goes back from 1 to 0"));
}

TEST(CsvTable, RefusesARowOfAnotherLength) {
  EXPECT_EQ(Error("t,u,v\n0,1,2\n1,1\n"),
            "velocity.csv:3: the row has 2 cells, expected 3 as on line 1.");
  EXPECT_EQ(Error("t,u,v\n0,1,2,\n1,1,2\n"),
            "velocity.csv:2: the row has 4 cells, expected 3 as on line 1.");
  EXPECT_EQ(Error("t,u\n0,1\n\n1,1\n"),
            "velocity.csv:3: the line is empty, expected a row. Remove the line.");
}

TEST(CsvTable, RefusesUnitsBehindTheNames) {
  const auto error = [](const std::string& column, const CsvSpec& spec) {
    return Error("t," + column + ",u,tau_surge\n0,1,2,3\n1,1,2,3\n", spec);
  };
  const auto expected = [](const std::string& column, const std::string& name) {
    return "velocity.csv:1: column '" + column + "' is " +
           (name == "t" ? "the time" : "'" + name + "'") +
           " with a unit, expected SI units and plain names. Convert to SI and name the column '" +
           name + "'.";
  };
  for (const std::string column :
       {"t_ms", "t_s", "t [ms]", "time_s", "timestamp", "Time", "time_us"}) {
    EXPECT_EQ(error(column, kVelocity), expected(column, "t"));
  }
  for (const std::string column : {"u_cms", "u [cm/s]", "u_cm/s", "u(knots)", "U_mps", "u_m_s"}) {
    EXPECT_EQ(error(column, kVelocity), expected(column, "u"));
  }
  EXPECT_EQ(error("r_deg", kVelocity), expected("r_deg", "r"));
  EXPECT_EQ(error("tau_surge_kN", kCommand), expected("tau_surge_kN", "tau_surge"));
  EXPECT_EQ(error("tau_yaw [N m]", kCommand), expected("tau_yaw [N m]", "tau_yaw"));
  EXPECT_EQ(error("thruster_12_rpm", kCommand), expected("thruster_12_rpm", "thruster_12"));
}

TEST(CsvTable, TakesOtherSuffixesForOtherColumns) {
  for (const std::string column : {"u_std", "tide", "u2", "tau_surge_shifted", "raw", "title"}) {
    EXPECT_EQ(Error("t,u," + column + "\n0,1,2\n1,1,2\n"), "no error") << column;
  }
}

TEST(CsvTable, RefusesCarriageReturns) {
  EXPECT_EQ(
      Error("t,u\r\n0,1\r\n"),
      "velocity.csv:1: the line ends in a carriage return, expected a line feed only. Convert "
      "the file with dos2unix.");
  EXPECT_THAT(Error("t,u\n0,1\n1,2\r\n"),
              StartsWith("velocity.csv:3: the line ends in a carriage"));
}

TEST(CsvTable, RefusesAByteOrderMark) {
  EXPECT_EQ(Error("\xef\xbb\xbft,u\n0,1\n1,2\n"),
            "velocity.csv:1: starts with a UTF-8 byte order mark, expected the first column name. "
            "Strip it (sed -i '1s/^\\xEF\\xBB\\xBF//' velocity.csv).");
}

TEST(CsvTable, RefusesUtf16WithTheCommandThatConvertsIt) {
  EXPECT_EQ(Error("\xff\xfet"),
            "velocity.csv:1: is UTF-16, expected plain text. Convert it (iconv -f UTF-16 -t UTF-8 "
            "velocity.csv > converted.csv).");
  EXPECT_THAT(Error(std::string("\0t\0,\0u", 6)), HasSubstr("iconv -f UTF-16BE"));
  EXPECT_THAT(Error(std::string("t\0,\0u\0", 6)), HasSubstr("iconv -f UTF-16LE"));
}

// dos2unix would leave it as it is.
TEST(CsvTable, NamesTheCommandThatMendsLoneCarriageReturns) {
  EXPECT_THAT(Error("t,u\r0,1\r1,2\r"),
              HasSubstr("Convert the file (tr '\\r' '\\n' < velocity.csv > converted.csv)."));
}

TEST(CsvTable, NamesTheTailOfNulBytesThatAPowerCutLeaves) {
  EXPECT_EQ(Error(std::string("t,u\n0,1\n1,2\n") + std::string(37, '\0')),
            "velocity.csv:4: 37 NUL bytes from this line to the end of the file, expected text. A "
            "power cut leaves such a tail. Cut it off (tr -d '\\0' < velocity.csv > cut.csv) and "
            "remove the last row if it is incomplete.");
}

TEST(CsvTable, RefusesNulBytesAmidTheText) {
  EXPECT_EQ(Error(std::string("t,u\n0,\0001\n1,\0002\n", 14)),
            "velocity.csv:2: a NUL byte amid the text (2 in the file), expected text. The file is "
            "corrupt or not a CSV file; restore it from its source.");
}

TEST(CsvTable, RefusesQuotesThatAreOpenOrMisplaced) {
  EXPECT_EQ(Error("t,u\n0,\"1\n1,2\n"),
            "velocity.csv:2: a quote (\") is opened and not closed on this line.");
  EXPECT_EQ(Error("t,u\n0,1\n1,\"2"),
            "velocity.csv:3: a quote (\") is opened and not closed on this line.");
  EXPECT_EQ(
      Error("t,u\n0,1\"2\n1,2\n"),
      "velocity.csv:2: a quote (\") stands inside a cell, expected it around the whole cell.");
}

TEST(CsvTable, RefusesOverlongLines) {
  EXPECT_EQ(Error("t,u\n0," + std::string(70000, '1') + "\n"),
            "velocity.csv:2: the line has 70002 bytes, expected at most 65536. Is this CSV?");
}

}  // namespace
}  // namespace fathom
