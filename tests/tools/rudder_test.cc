// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>
#include <vector>

#include "run_tool.h"
#include "saved_files.h"
#include "test_folder.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

// The angles of a rudder are logged with the other sign.
TEST(Rudder, IsSaidToTurnTheOtherWayWhereItsAnglesDo) {
  const Path folder = EmptyTestFolder(), log = folder / "zigzag";
  std::string experiment = TextOf(FATHOM_DATA_DIR "/experiments/ship_zigzag.yaml");
  const std::string whole = "duration: 900";
  experiment.replace(experiment.find(whole), whole.size(), "duration: 600");
  const Path shorter = WriteTestFile(folder / "zigzag.yaml", experiment);
  RunsWell("fathom_synthesize",
           {"--vehicle=" FATHOM_DATA_DIR "/vehicles/mariner.yaml",
            "--experiment=" + shorter.string(),
            "--out=" + log.string()});
  const std::vector<std::string> identify = {
      "--log=" + log.string(), "--dofs=surge,sway,yaw", "--structure=symmetric"};
  EXPECT_THAT(RunToolBinary("fathom_identify", identify).out,
              Not(HasSubstr("fin_force.rudder is below 0")));
  const CsvColumns command = ReadColumns(log / "command.csv");
  const auto time = command.Values("t"), force = command.Values("tau_surge"),
             angle = command.Values("fin_rudder");
  std::string turned = "t,tau_surge,fin_rudder\n";
  for (std::size_t k = 0; k < time.size(); ++k) {
    turned += fmt::format("{},{},{}\n", time[k], force[k], -angle[k]);
  }
  WriteTestFile(log / "command.csv", turned);
  EXPECT_THAT(RunToolBinary("fathom_identify", identify).out,
              HasSubstr("fin_force.rudder is below 0: in this log the fin turns the vehicle the "
                        "other way"));
}

}  // namespace
}  // namespace fathom
