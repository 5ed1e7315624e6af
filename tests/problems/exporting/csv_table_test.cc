// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/csv_table.h"

#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <string>

#include "generic_models.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(CsvTable, HasEveryNumberWithIntervalUnitAndFrame) {
  const ExportModel model = ExportModelOf(GenericRov(), "rov.json");
  const ExportedFile file = CsvTable(model, {"rov", "a test"});
  EXPECT_THAT(file.remarks, IsEmpty());
  EXPECT_THAT(file.text, HasSubstr("# From rov.json: log tank_07, version 0.1.0\n"));
  EXPECT_THAT(file.text, HasSubstr("\nname,value,std,low_95,high_95,unit,frame,log,source\n"));
  // 40 give or take 1.96 x 0.1.
  EXPECT_THAT(file.text,
              HasSubstr("\ninertia.surge,40.0,0.1,39.804,40.196,kg,body: FRD about its "
                        "origin,tank_07,identified\n"));
  EXPECT_THAT(file.text, HasSubstr("\nthrust_gain.port,0.8,,,,1,thruster,tank_07,identified\n"));
  for (const ExportNumber& number : model.numbers) {
    EXPECT_THAT(file.text, HasSubstr("\n" + NameOf(number.entry) + ","));
  }
}

TEST(CsvTable, HasTheEffects) {
  FittedModel fitted = GenericOneDof(Dof::kSurge);
  fitted.effects = {{FindEffect("thruster_lag"), {}, {0.5}}};
  fitted.covariance = 0.01 * Eigen::MatrixXd::Identity(5, 5);
  fitted.provenance["log"] = "pool, deep end";
  EXPECT_THAT(
      CsvTable(ExportModelOf({fitted}, {"surge.json"}), {"rov", "a test"}).text,
      HasSubstr("\nthruster_lag.surge.time_constant,0.5,0.1,0.304,0.696,s,effect on surge,"));
}

}  // namespace
}  // namespace fathom
