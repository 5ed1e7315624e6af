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

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Path = std::filesystem::path;

const TwoColumnCsv kReplay = {"replay.csv", "tau_surge", "t, tau_surge", false};

constexpr char kReplayExperiment[] =
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
  Path experiment = WriteTestFile(folder / "experiment.yaml", kReplayExperiment);
  Path replay = WriteTestFile(folder / "replay.csv", SmallCommandCsv());

  std::vector<std::string> Arguments() const {
    return {Flag("vehicle", vehicle), Flag("experiment", experiment), Flag("out", folder / "log")};
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
  RunsWell("fathom_synthesize", inputs.Arguments());
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

TEST(SynthesizeRefusals, AFileThatSaysWhatItMayNot) {
  const SynthesisInputs inputs;
  struct Wrong {
    const Path& file;
    std::string from, to;
    std::string place;  // behind the file's name
    std::string said;   // behind that
  };
  const Path &vehicle = inputs.vehicle, &experiment = inputs.experiment;
  for (const auto& [file, from, to, place, said] : std::vector<Wrong>{
           {vehicle, "0.3]", "0.3", ":", ": not valid YAML: "},
           {vehicle, "inertia: 40", "inertia: 0", ":5: key '", "surge.inertia' is 0, expected a "},
           {experiment,
            "ion: 30",
            "ion: 30\nrate: 1",
            ":3: key 'rate' is not known here",
            "one of: "},
           {experiment, "duration: 30\n", "", ":", "key 'duration' is missing, expected a finite"},
           {experiment,
            ": 30",
            ": long",
            ":2: key 'duration' is 'long'",
            ", expected a finite "}}) {
    const std::string good = file == vehicle ? SmallVehicleYaml() : kReplayExperiment;
    WriteTestFile(file, Replaced(good, from, to));
    EXPECT_THAT(inputs.ExpectedRefusal(),
                AllOf(StartsWith("fathom_synthesize: " + file.string() + place), HasSubstr(said)));
    WriteTestFile(file, good);
  }
}

TEST(SynthesizeRefusals, AVehicleWithoutAModelOfTheDrivenDof) {
  const SynthesisInputs inputs;
  WriteTestFile(inputs.vehicle, Replaced(SmallVehicleYaml(), "surge:", "heave:"));
  EXPECT_THAT(inputs.ExpectedRefusal(),
              AllOf(StartsWith("fathom_synthesize: vehicle 'small': has no model of surge"),
                    HasSubstr("'replay' drives it")));
}

TEST(SynthesizeRefusals, ACoupledModelThatCannotBe) {
  const SynthesisInputs inputs;
  WriteTestFile(inputs.vehicle,
                "name: rov\ncoupled_model:\n  inertia: [40, 50, 60, 1, 2, 3]\n"
                "  linear_damping: [-4, 6, 7, 1, 1, 1]\n");
  EXPECT_THAT(inputs.ExpectedRefusal(),
              AllOf(StartsWith("fathom_synthesize: " + inputs.vehicle.string() +
                               ":4: key 'coupled_model.linear_damping' gives energy"),
                    HasSubstr("expected a matrix whose symmetric part is positive")));
}

TEST(SynthesizeRefusals, AFileThatIsNotThere) {
  const SynthesisInputs inputs;
  for (const Path& file : {inputs.replay, inputs.vehicle}) {
    std::filesystem::remove(file);
    EXPECT_EQ(inputs.ExpectedRefusal(),
              "fathom_synthesize: " + file.string() + ": there is no such file. Check the path.\n");
  }
}

// A wrong --out must not cost a folder of something else.
TEST(SynthesizeRefusals, AFolderThatHoldsSomethingElseIsLeftAlone) {
  const SynthesisInputs inputs;
  const Path other = WriteTestFile(inputs.folder / "log" / "thesis.txt", "years of work");
  auto arguments = inputs.Arguments();
  arguments.push_back("--overwrite");
  EXPECT_THAT(ExpectRefusal("fathom_synthesize", arguments, inputs.folder),
              AllOf(StartsWith("fathom_synthesize: --out="),
                    HasSubstr("is not empty"),
                    HasSubstr("holds no log")));
  EXPECT_TRUE(std::filesystem::exists(other));
}

}  // namespace
}  // namespace fathom
