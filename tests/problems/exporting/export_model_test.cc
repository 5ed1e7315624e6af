// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/export_model.h"

#include "fathom/exporting/export_target.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/model_file.h"

#include <filesystem>
#include <fstream>
#include <string>

#include "error_from.h"
#include "generic_models.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Path = std::filesystem::path;

Path Saved(const std::string& name, const std::string& text) {
  const Path path = TestFolder() / name;
  std::ofstream(path) << text;
  return path;
}

std::string RefusalOf(const std::vector<Path>& paths) {
  return ErrorFrom([&] { ReadExportModel(paths); });
}

TEST(ExportModel, JoinsModelsOfOneDofInTheOrderOfTheirDofs) {
  const FittedModel yaw = GenericOneDof(Dof::kYaw), heave = GenericOneDof(Dof::kHeave);
  const ExportModel joined = ReadExportModel(
      {Saved("yaw.json", FormatModel(yaw)), Saved("heave.json", FormatModel(heave))});
  EXPECT_THAT(joined.model.dofs, ElementsAre(Dof::kHeave, Dof::kYaw));
  EXPECT_EQ(joined.model.inertia(2, 2), heave.model.inertia);
  EXPECT_EQ(joined.model.quadratic_damping(5, 5), yaw.model.quadratic_damping);
  EXPECT_EQ(joined.model.net_buoyancy, heave.model.buoyancy);
  EXPECT_EQ(joined.model.offset[5], yaw.model.buoyancy);
  EXPECT_EQ(joined.model.offset[2], 0.0);
  EXPECT_TRUE(joined.is_joined);
  EXPECT_FALSE(joined.model.coriolis);
  EXPECT_THAT(joined.notes, ElementsAre(HasSubstr("identified alone")));
  EXPECT_EQ(joined.numbers.size(), 8u);
  EXPECT_NEAR(joined.numbers.front().std, 0.2, 1e-15);
  EXPECT_EQ(joined.numbers.front().log, "pool");
}

TEST(ExportModel, HoldsEveryNumberOfAModelOfSeveralDofs) {
  FittedCoupledModel fitted = GenericBoat();
  SetValue(QuadraticDampingEntry(Dof::kYaw, Dof::kSway), 0.9, &fitted.model);  // held
  const ExportModel exported = ReadExportModel({Saved("boat.json", FormatCoupledModel(fitted))});
  CoupledModel rebuilt;
  for (const ExportNumber& number : exported.numbers) {
    SetValue(number.entry, number.value, &rebuilt);
    EXPECT_EQ(number.is_identified,
              !(number.entry == QuadraticDampingEntry(Dof::kYaw, Dof::kSway)));
  }
  EXPECT_EQ(rebuilt.inertia, fitted.model.inertia);
  EXPECT_EQ(rebuilt.linear_damping, fitted.model.linear_damping);
  EXPECT_EQ(rebuilt.quadratic_damping, fitted.model.quadratic_damping);
  EXPECT_EQ(rebuilt.offset, fitted.model.offset);
  EXPECT_THAT(exported.notes, IsEmpty());
}

TEST(ExportModel, LeavesOutWhatIsOfOneRunAndSaysSo) {
  FittedCoupledModel fitted = GenericBoat();
  SetValue(RunOffsetEntry(Dof::kYaw, "dive_3"), 1.5, &fitted.model);
  const ExportModel exported = ReadExportModel({Saved("boat.json", FormatCoupledModel(fitted))});
  for (const ExportNumber& number : exported.numbers) EXPECT_FALSE(IsOfRun(number.entry));
  EXPECT_THAT(exported.notes, ElementsAre(HasSubstr("dive_3")));
}

// The whole paths stand once, in the head.
TEST(ExportModel, NamesTheLogsOfANumberInShort) {
  FittedCoupledModel fitted = GenericBoat();
  fitted.provenance["log"] = "dives/run_01/,dives/run_02,dives/run_03";
  const ExportModel exported = ExportModelOf(fitted, "boat.json");
  EXPECT_EQ(exported.numbers.front().log, "run_01 and 2 more");
  EXPECT_THAT(exported.sources,
              ElementsAre("boat.json: log dives/run_01/,dives/run_02,dives/run_03"));
}

TEST(ExportModel, HoldsTheEffects) {
  FittedModel fitted = GenericOneDof(Dof::kSurge);
  const Effect* lag = FindEffect("thruster_lag");
  ASSERT_NE(lag, nullptr);
  fitted.effects = {{lag, {}, {0.5}}};
  fitted.covariance = 0.09 * Eigen::MatrixXd::Identity(5, 5);
  const ExportModel exported = ExportModelOf({fitted}, {"surge.json"});
  ASSERT_EQ(exported.effects.size(), 1u);
  const ExportEffect& effect = exported.effects.front();
  EXPECT_EQ(effect.label, "thruster_lag");
  ASSERT_EQ(effect.values.size(), 1u);
  EXPECT_EQ(effect.values[0].name, "time_constant");
  EXPECT_EQ(effect.values[0].value, 0.5);
  EXPECT_EQ(effect.values[0].std, 0.3);
  EXPECT_EQ(effect.values[0].unit, "s");
}

// The lag of all thrusters stands once for each DOF, where formats look for it.
TEST(ExportModel, HoldsTheLagOfAModelOfSeveralDofsAsEffects) {
  FittedCoupledModel fitted = GenericBoat();
  fitted.model.thruster_lag = 0.4;
  const ExportModel exported = ExportModelOf(fitted, "boat.json");
  ASSERT_EQ(exported.effects.size(), fitted.model.dofs.size());
  for (std::size_t k = 0; k < exported.effects.size(); ++k) {
    EXPECT_EQ(exported.effects[k].name, "thruster_lag");
    EXPECT_EQ(exported.effects[k].dof, fitted.model.dofs[k]);
    ASSERT_EQ(exported.effects[k].values.size(), 1u);
    EXPECT_EQ(exported.effects[k].values[0].value, 0.4);
  }
  for (const ExportNumber& number : exported.numbers) EXPECT_FALSE(IsLateness(number.entry));
}

TEST(ExportModel, RefusesTwoModelsOfOneDof) {
  const std::string text = FormatModel(GenericOneDof(Dof::kSurge));
  const Path a = Saved("a.json", text), b = Saved("b.json", text);
  EXPECT_EQ(
      RefusalOf({a, b}),
      b.string() + ": is a model of surge, as " + a.string() + " is: expected each DOF once.");
}

TEST(ExportModel, RefusesUnitsThatDiffer) {
  FittedModel heave = GenericOneDof(Dof::kHeave);
  heave.force_unit = "A";
  EXPECT_THAT(RefusalOf({Saved("surge.json", FormatModel(GenericOneDof(Dof::kSurge))),
                         Saved("amperes.json", FormatModel(heave))}),
              HasSubstr("amperes.json: takes commands in A, "));
}

TEST(ExportModel, RefusesAModelOfSeveralDofsBesideAnother) {
  EXPECT_THAT(RefusalOf({Saved("surge.json", FormatModel(GenericOneDof(Dof::kSurge))),
                         Saved("boat.json", FormatCoupledModel(GenericBoat()))}),
              HasSubstr("boat.json: is a model of several DOFs: expected it alone"));
}

TEST(IdentifierOf, IsTheStemAsAnIdentifier) {
  EXPECT_EQ(IdentifierOf("out/boat.h"), "boat");
  EXPECT_EQ(IdentifierOf("my-boat 2.sdf"), "my_boat_2");
  EXPECT_EQ(IdentifierOf("2boats.m"), "model_2boats");
  EXPECT_EQ(IdentifierOf("_x.h"), "model__x");
}

}  // namespace
}  // namespace fathom
