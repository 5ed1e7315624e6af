// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_synthesize refuses a damaged command to replay, vehicle or experiment.

#include <filesystem>
#include <string>
#include <vector>

#include "damage.h"
#include "expect_refusal.h"
#include "run_tool.h"
#include "small_log.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Path = std::filesystem::path;

const TwoColumnCsv kReplay = {"replay.csv", "tau_surge", "t, tau_surge", false};

constexpr char kExperiment[] =
    "name: replay\n"
    "duration: 30\n"
    "command_rate: 10\n"
    "surge:\n"
    "  control: open_loop\n"
    "  input: {kind: file, file: replay.csv}\n"
    "velocity: {rate: 10}\n";

// A good vehicle, experiment and command in a folder of the running test.
struct SynthesisInputs {
  Path folder = EmptyTestFolder();
  Path vehicle = WriteTestFile(folder / "vehicle.yaml", SmallVehicleYaml());
  Path experiment = WriteTestFile(folder / "experiment.yaml", kExperiment);
  Path replay = WriteTestFile(folder / "replay.csv", SmallCommandCsv());

  std::vector<std::string> Arguments() const {
    return {"--vehicle=" + vehicle.string(),
            "--experiment=" + experiment.string(),
            "--out=" + (folder / "log").string()};
  }
  std::string ExpectedRefusal() const {
    return ExpectRefusal("fathom_synthesize", Arguments(), folder);
  }
};

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(SynthesizeRefusals, TheUndamagedFilesAreAccepted) {
  const SynthesisInputs inputs;
  const auto run = RunToolBinary("fathom_synthesize", inputs.Arguments());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(inputs.folder / "log" / "velocity.csv"));
}

class DamagedReplay : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedReplay, IsRefused) {
  const SynthesisInputs inputs;
  WriteTestFile(inputs.replay, Damaged(SmallCommandCsv(), kReplay, GetParam()));
  EXPECT_EQ(inputs.ExpectedRefusal(),
            "fathom_synthesize: " + inputs.replay.string() + Refusal(kReplay, GetParam()) + "\n");
}

INSTANTIATE_TEST_SUITE_P(Refusals,
                         DamagedReplay,
                         ::testing::ValuesIn(AllDamages()),
                         [](const auto& info) { return "synthesize_replay_" + Name(info.param); });

TEST(SynthesizeRefusals, AVehicleThatIsNoYaml) {
  const SynthesisInputs inputs;
  WriteTestFile(inputs.vehicle, Replaced(SmallVehicleYaml(), "0.3]", "0.3"));
  EXPECT_THAT(inputs.ExpectedRefusal(),
              AllOf(StartsWith("fathom_synthesize: " + inputs.vehicle.string() + ":"),
                    HasSubstr(": not valid YAML: ")));
}

TEST(SynthesizeRefusals, AVehicleWithAnInertiaOfZero) {
  const SynthesisInputs inputs;
  WriteTestFile(inputs.vehicle, Replaced(SmallVehicleYaml(), "inertia: 40", "inertia: 0"));
  EXPECT_THAT(inputs.ExpectedRefusal(),
              AllOf(StartsWith("fathom_synthesize: " + inputs.vehicle.string() + ":5: key '"),
                    HasSubstr("surge.inertia' is 0, expected a number above 0")));
}

TEST(SynthesizeRefusals, AVehicleWithoutAModelOfTheDrivenDof) {
  const SynthesisInputs inputs;
  WriteTestFile(inputs.vehicle, Replaced(SmallVehicleYaml(), "surge:", "heave:"));
  EXPECT_THAT(inputs.ExpectedRefusal(),
              AllOf(StartsWith("fathom_synthesize: "), HasSubstr("surge"), HasSubstr("model")));
}

TEST(SynthesizeRefusals, AnExperimentWithAnUnknownKey) {
  const SynthesisInputs inputs;
  WriteTestFile(inputs.experiment, Replaced(kExperiment, "duration: 30", "duration: 30\nrate: 1"));
  EXPECT_THAT(inputs.ExpectedRefusal(),
              StartsWith("fathom_synthesize: " + inputs.experiment.string() +
                         ":3: key 'rate' is not known here, expected one of: "));
}

TEST(SynthesizeRefusals, AnExperimentWithoutDuration) {
  const SynthesisInputs inputs;
  WriteTestFile(inputs.experiment, Replaced(kExperiment, "duration: 30\n", ""));
  EXPECT_THAT(inputs.ExpectedRefusal(),
              AllOf(StartsWith("fathom_synthesize: " + inputs.experiment.string() + ":"),
                    HasSubstr("key 'duration' is missing, expected a finite number.")));
}

TEST(SynthesizeRefusals, AnExperimentWhoseDurationIsNoNumber) {
  const SynthesisInputs inputs;
  WriteTestFile(inputs.experiment, Replaced(kExperiment, "duration: 30", "duration: long"));
  EXPECT_THAT(inputs.ExpectedRefusal(),
              StartsWith("fathom_synthesize: " + inputs.experiment.string() +
                         ":2: key 'duration' is 'long', expected a finite number."));
}

TEST(SynthesizeRefusals, AnExperimentThatReplaysAFileThatIsNotThere) {
  const SynthesisInputs inputs;
  std::filesystem::remove(inputs.replay);
  EXPECT_EQ(inputs.ExpectedRefusal(),
            "fathom_synthesize: " + inputs.replay.string() +
                ": there is no such file. Check the path.\n");
}

TEST(SynthesizeRefusals, AMissingFlagIsNamed) {
  const SynthesisInputs inputs;
  for (std::size_t i = 0; i < inputs.Arguments().size(); ++i) {
    auto arguments = inputs.Arguments();
    const std::string flag = arguments[i].substr(0, arguments[i].find('='));
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_THAT(ExpectRefusal("fathom_synthesize", arguments, inputs.folder),
                StartsWith("fathom_synthesize: " + flag + ": is missing, expected "));
  }
}

// A wrong --out must not cost a folder of something else.
TEST(SynthesizeRefusals, AFolderThatHoldsSomethingElseIsLeftAlone) {
  const SynthesisInputs inputs;
  const Path other = WriteTestFile(inputs.folder / "log" / "thesis.txt", "years of work");
  auto arguments = inputs.Arguments();
  arguments.push_back("--overwrite");
  EXPECT_THAT(ExpectRefusal("fathom_synthesize", arguments, inputs.folder),
              AllOf(StartsWith("fathom_synthesize: --out="), HasSubstr("is not empty")));
  EXPECT_TRUE(std::filesystem::exists(other));
}

}  // namespace
}  // namespace fathom
