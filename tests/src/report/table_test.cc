// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/table.h"

#include "fathom/report/table_html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
