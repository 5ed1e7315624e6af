// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/table.h"

#include "fathom/report/table_html.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;

TEST(FormatTable, AlignsTextAtTheLeftAndNumbersAtTheirPlusMinus) {
  Table table;
  table.columns = {{"DOF"}, {"inertia [kg]", true}, {"MAE", true}, {"remark"}};
  table.rows = {{{"surge", "890.3 ± 4.2", "0.012", "ok"}, RowFlag::kBest},
                {{"heave", "12350 ± 230", "0.5", ""}},
                {{"yaw", "-", "10", "no data"}, RowFlag::kUnusable}};
  EXPECT_EQ(FormatTable(table),
            "  DOF    inertia [kg]    MAE  remark\n"
            "  -----  ------------  -----  -------\n"
            "* surge   890.3 ± 4.2  0.012  ok\n"
            "  heave   12350 ± 230    0.5\n"
            "! yaw         -           10  no data\n");
}

TEST(FormatTable, HasNoRoomForMarksWhereNoRowIsMarked) {
  Table table;
  table.caption = "Logs";
  table.columns = {{"name"}, {"s", true}};
  table.rows = {{{"dive", "1"}}};
  EXPECT_EQ(FormatTable(table),
            "Logs\n"
            "name  s\n"
            "----  -\n"
            "dive  1\n");
}

TEST(FormatTable, CountsCharactersNotBytes) {
  Table table;
  table.columns = {{"a"}, {"b"}};
  table.rows = {{{"größe", "x"}}, {{"length", "y"}}};
  EXPECT_EQ(FormatTable(table),
            "a       b\n"
            "------  -\n"
            "größe   x\n"
            "length  y\n");
}

TEST(FormatTable, KeepsACellWithALineBreakOnItsLine) {
  Table table;
  table.columns = {{"a"}};
  table.rows = {{{"one\ntwo"}}};
  EXPECT_THAT(FormatTable(table), HasSubstr("one two\n"));
}

// 5 + 2 + 5 + 2 + 5 + 2 + 5 = 26 columns in all.
Table FourColumns() {
  Table table;
  table.columns = {{"name1"}, {"rank2", false, 2}, {"rank1", false, 1}, {"also2", false, 2}};
  table.rows = {{{"a", "b", "c", "d"}}};
  return table;
}

std::vector<std::string> HeadingsAt(std::size_t width, std::vector<std::string>* left_out) {
  std::vector<std::string> headings;
  for (const auto& column : Narrowed(FourColumns(), width, left_out).columns) {
    headings.push_back(column.heading);
  }
  return headings;
}

TEST(Narrowed, LeavesOutTheHighestRankFirstAndOfOneRankTheLast) {
  using Headings = std::vector<std::string>;
  Headings left_out;
  EXPECT_EQ(HeadingsAt(26, &left_out), (Headings{"name1", "rank2", "rank1", "also2"}));
  EXPECT_TRUE(left_out.empty());
  EXPECT_EQ(HeadingsAt(25, nullptr), (Headings{"name1", "rank2", "rank1"}));
  EXPECT_EQ(HeadingsAt(18, nullptr), (Headings{"name1", "rank1"}));
  EXPECT_EQ(HeadingsAt(1, &left_out), (Headings{"name1"}));
  EXPECT_EQ(left_out, (Headings{"rank2", "rank1", "also2"}));
}

TEST(TableHtml, LabelsFlaggedRowsAndNoOther) {
  Table table;
  table.columns = {{"family"}};
  table.rows = {{{"first"}, RowFlag::kBest}, {{"second"}}, {{"third"}, RowFlag::kUnusable}};
  const std::string html = TableHtml(table);
  EXPECT_THAT(html, HasSubstr(R"(<tr class="best"><td>first <span class="flag">best</span></td>)"));
  EXPECT_THAT(html, HasSubstr(R"(<tr class=""><td>second</td>)"));
  EXPECT_THAT(html, HasSubstr(R"(<td>third <span class="flag">unusable</span></td>)"));
}

}  // namespace
}  // namespace fathom
