// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/mss.h"

#include "fathom/exporting/comment_text.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "generic_models.h"
#include "octave.h"
#include "test_folder.h"
#include "written_out_rate.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Path = std::filesystem::path;

ExportTarget TargetOf(const std::string& name) { return {name, "a test"}; }

std::string RowVector(const Eigen::VectorXd& values) {
  std::string row = "[";
  for (const double value : values) row += LiteralOf(value) + " ";
  return row + "]";
}

Eigen::Matrix3d RotationOf(const Eigen::Vector3d& angles) {
  return (Eigen::AngleAxisd(angles[2], Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(angles[1], Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles[0], Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

// Compares xdot with the equations at drawn states, in Octave.
void ExpectRatesInOctave(const FittedCoupledModel& fitted, const std::string& name) {
  if (!HasOctave()) GTEST_SKIP() << "octave-cli is not installed";
  const Path folder = TestFolder();
  std::ofstream(folder / (name + ".m"))
      << MssFunction(ExportModelOf(fitted, name + ".json"), TargetOf(name)).text;
  std::vector<DrawnState> states = DrawnStates(fitted.model, 10, true);
  std::vector<Eigen::Vector3d> angles;
  std::string script = fmt::format("addpath('{}');\n", folder.string());
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto at = static_cast<double>(k);
    angles.emplace_back(0.3 + 0.5 * at, 1.2 * std::sin(1.0 + at), -1.0 + 0.7 * at);
    states[k].world_from_body = RotationOf(angles[k]);
    Eigen::VectorXd x(12);
    x << states[k].nu, 1.0, -2.0, 3.0, angles[k];
    script += fmt::format(
        "printf('%.17g\\n', {}({}', {}'));\n", name, RowVector(x), RowVector(states[k].tau));
  }
  std::ofstream(folder / "compare.m") << script;
  const ChildResult run = RunInOctave(folder / "compare.m");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::istringstream out(run.out);
  double largest = 0.0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    Eigen::VectorXd xdot(12);
    for (double& value : xdot) ASSERT_TRUE(out >> value) << run.out << run.err;
    const Vector6 truth = WrittenOutRate(fitted.model, states[k]);
    largest = std::max(largest, (xdot.head<6>() - truth).norm() / truth.norm());
    const Eigen::Vector3d velocity = RotationOf(angles[k]) * states[k].nu.head<3>();
    EXPECT_LT((xdot.segment<3>(6) - velocity).norm(), 1e-12);
    // The turn that the rates of the angles make in a microsecond, by central differences: their
    // own error is 1e-12 of it, rounding 1e-10.
    const double dt = 1e-6;
    const Eigen::Vector3d rates = xdot.tail<3>();
    const Eigen::Matrix3d turn = RotationOf(angles[k] - 0.5 * dt * rates).transpose() *
                                 RotationOf(angles[k] + 0.5 * dt * rates);
    const Eigen::Vector3d omega(turn(2, 1), turn(0, 2), turn(1, 0));
    EXPECT_LT((omega / dt - states[k].nu.tail<3>()).norm(), 1e-5);
  }
  EXPECT_LT(largest, 1e-12);
  std::printf("largest relative difference of dnu/dt: %.2g\n", largest);
}

TEST(MssFunction, MovesInOctaveAsTheEquationsOfSixDofs) {
  ExpectRatesInOctave(GenericRov(), "rov");
}
TEST(MssFunction, MovesInOctaveAsTheEquationsOfABoat) {
  ExpectRatesInOctave(GenericBoat(), "boat");
}

TEST(MssFunction, SaysOfEachNumberWhereItIsFrom) {
  const std::string text =
      MssFunction(ExportModelOf(GenericBoat(), "boat.json"), TargetOf("boat")).text;
  EXPECT_THAT(text, StartsWith("function xdot = boat(x, ui)\n% boat: a motion model of surge, "));
  EXPECT_THAT(text, HasSubstr("\nM(1,1) = 55.0;  % kg, 95 % interval 54.8 to 55.2, log lake_3\n"));
  EXPECT_THAT(text, HasSubstr("\nM(2,6) = -4.1; M(6,2) = -4.1;  % kg m, "));
  EXPECT_THAT(text, HasSubstr("\nmodelled = [1 2 6];\n"));
}

TEST(MssFunction, NamesTheGainThatItLeavesOut) {
  const ExportedFile file = MssFunction(ExportModelOf(GenericRov(), "rov.json"), TargetOf("rov"));
  ASSERT_EQ(file.remarks.size(), 1u);
  EXPECT_THAT(file.text, HasSubstr("% Note: " + file.remarks[0]));
}

}  // namespace
}  // namespace fathom
