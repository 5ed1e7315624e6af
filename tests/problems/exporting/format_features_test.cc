// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/format_features.h"

#include <algorithm>
#include <string>

#include "error_from.h"
#include "generic_models.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

bool LeavesOutTheAngle(ExportFormat format) {
  FittedCoupledModel turned = GenericRov();
  turned.model.thrust_angle = 0.05;
  const auto remarks = RemarksOn(format, ExportModelOf(turned, "rov.json"), GenericTarget());
  return std::ranges::any_of(remarks, [](const std::string& remark) {
    return remark.starts_with("thrust_angle of 0.05 rad is left out");
  });
}

// The table promises that what is left out is named, number by number.
TEST(FormatFeatures, NamesAllThatItLeavesOut) {
  const ExportModel model = ExportModelOf(GenericRov(), "rov.json");
  const std::string table = FeatureTable();
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 27);
  for (const ExportFormat format : kExportFormats) {
    EXPECT_THAT(table, HasSubstr("`" + std::string(Name(format)) + "`"));
    EXPECT_EQ(LeavesOutTheAngle(format), format != ExportFormat::kCsv) << Name(format);
    if (format == ExportFormat::kC) continue;  // with the vehicle: c_header_test
    const auto remarks = RemarksOn(format, model, GenericTarget());
    const auto num_gains = std::count_if(remarks.begin(), remarks.end(), [](const auto& remark) {
      return remark.find("thrust_gain.port of 0.8 is left out") != std::string::npos;
    });
    const bool is_left_out =
        Held(format, ExportFeature::kThrustGain).how == HeldFeature::How::kLeftOut;
    EXPECT_EQ(num_gains, is_left_out ? 1 : 0) << Name(format);
  }
}

TEST(FormatFeatures, RefusesACommandUnitThatMakesMassesRatios) {
  ExportModel model = ExportModelOf(GenericBoat(), "boat.json");
  model.force_unit = "A";
  for (const ExportFormat format : kExportFormats) {
    const bool is_refused =
        Held(format, ExportFeature::kOtherUnit).how == HeldFeature::How::kRefused;
    if (is_refused) {
      EXPECT_THAT(ErrorFrom([&] { RemarksOn(format, model, GenericTarget()); }),
                  HasSubstr("--model: takes commands in A, so that its inertia is not in kg."));
    } else {
      EXPECT_NO_THROW(RemarksOn(format, model, GenericTarget()));
    }
  }
}

}  // namespace
}  // namespace fathom
