// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/experiment_file.h"

#include "fathom/base/input_error.h"

#include <filesystem>
#include <fstream>
#include <string>

#include "error_from.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kGood = R"(name: both
notes: still water
start_time: 1000
duration: 60
command_rate: 5
command_resolution: 0.1
surge:
  control: open_loop
  initial_speed: 0.2
  turbulence: {force: 4, correlation_time: 7.5}
  input: {kind: sine, amplitude: 52.9, frequency: 0.3, phase: 0.5, offset: 2}
heave:
  control: closed_loop
  setpoint: {kind: steps, levels: [1, -1], hold: 10}
  pid: {kp: 30, ki: 3, kd: 25, limit: 80}
velocity:
  rate: 20
  jitter: 0.004
  noise: {surge: 0.01}
  outliers: {probability: 0.02, heave: 0.4}
  noise_correlation: 0.5
  resolution: 0.001
  drop_outs: {probability: 0.01, length: [1, 2]}
pose:
  rate: 8
  noise: {position: 0.02, angle: 0.03}
  outliers: {probability: 0.03, position: 0.7, angle: 0.6}
  logged: false
held_out: [1040, 1060]
)";

// The message for the good file with its first `from` replaced.
std::string MessageWith(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const auto place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  text.replace(place, from.size(), to);
  return ErrorFrom([&] { ParseExperiment("e.yaml", text); });
}

TEST(ExperimentFile, ReadsEveryKey) {
  const Experiment e = ParseExperiment("e.yaml", kGood);
  EXPECT_EQ(e.name, "both");
  EXPECT_EQ(e.notes, "still water");
  EXPECT_EQ(e.start_time, 1000.0);
  EXPECT_EQ(e.duration, 60.0);
  EXPECT_EQ(e.command_rate, 5.0);
  EXPECT_EQ(e.command_resolution, 0.1);
  ASSERT_EQ(e.drives.size(), 2u);

  EXPECT_EQ(e.drives[0].dof, Dof::kSurge);
  EXPECT_EQ(e.drives[0].initial_speed, 0.2);
  EXPECT_EQ(e.drives[0].input.offset, 2.0);
  EXPECT_FALSE(e.drives[0].pid);
  EXPECT_EQ(e.drives[0].turbulence.force, 4.0);
  EXPECT_EQ(e.drives[0].turbulence.correlation_time, 7.5);
  EXPECT_EQ(e.drives[1].turbulence.force, 0.0);
  const auto& sine = std::get<SineInput>(e.drives[0].input.kind);
  EXPECT_EQ(sine.amplitude, 52.9);
  EXPECT_EQ(sine.frequency, 0.3);
  EXPECT_EQ(sine.phase, 0.5);

  EXPECT_EQ(e.drives[1].dof, Dof::kHeave);
  EXPECT_THAT(std::get<StepsInput>(e.drives[1].input.kind).levels, testing::ElementsAre(1.0, -1.0));
  EXPECT_EQ(std::get<StepsInput>(e.drives[1].input.kind).hold, 10.0);
  ASSERT_TRUE(e.drives[1].pid);
  EXPECT_EQ(e.drives[1].pid->kp, 30.0);
  EXPECT_EQ(e.drives[1].pid->ki, 3.0);
  EXPECT_EQ(e.drives[1].pid->kd, 25.0);
  EXPECT_EQ(e.drives[1].pid->limit, 80.0);

  ASSERT_TRUE(e.velocity);
  EXPECT_EQ(e.velocity->sampling.rate, 20.0);
  EXPECT_EQ(e.velocity->sampling.jitter, 0.004);
  EXPECT_EQ(e.velocity->sampling.drop_outs.probability, 0.01);
  EXPECT_EQ(e.velocity->sampling.drop_outs.shortest, 1.0);
  EXPECT_EQ(e.velocity->sampling.drop_outs.longest, 2.0);
  EXPECT_THAT(e.velocity->noise, testing::ElementsAre(0.01, 0.0, 0.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(e.velocity->outlier_probability, 0.02);
  EXPECT_THAT(e.velocity->outlier_size, testing::ElementsAre(0.0, 0.0, 0.4, 0.0, 0.0, 0.0));
  EXPECT_EQ(e.velocity->noise_correlation, 0.5);
  EXPECT_EQ(e.velocity->resolution, 0.001);

  ASSERT_TRUE(e.pose);
  EXPECT_EQ(e.pose->sampling.rate, 8.0);
  EXPECT_EQ(e.pose->position_noise, 0.02);
  EXPECT_EQ(e.pose->angle_noise, 0.03);
  EXPECT_EQ(e.pose->outlier_probability, 0.03);
  EXPECT_EQ(e.pose->outlier_position, 0.7);
  EXPECT_EQ(e.pose->outlier_angle, 0.6);
  EXPECT_FALSE(e.pose->is_logged);

  ASSERT_EQ(e.held_out.size(), 1u);
  EXPECT_EQ(e.held_out[0].from, 1040.0);
  EXPECT_EQ(e.held_out[0].to, 1060.0);
}

TEST(ExperimentFile, ReadsEveryKindOfInput) {
  const auto input = [](const std::string& text) {
    std::string file = kGood;
    const std::string sine = "{kind: sine, amplitude: 52.9, frequency: 0.3, phase: 0.5, offset: 2}";
    file.replace(file.find(sine), sine.size(), text);
    return ParseExperiment("e.yaml", file).drives[0].input.kind;
  };
  const auto sines =
      std::get<MultisineInput>(input("{kind: multisine, rms: 9, frequency: [0.1, 2], lines: 7}"));
  EXPECT_EQ(sines.rms, 9.0);
  EXPECT_EQ(sines.lowest_frequency, 0.1);
  EXPECT_EQ(sines.highest_frequency, 2.0);
  EXPECT_EQ(sines.num_lines, 7);
  const auto chirp =
      std::get<ChirpInput>(input("{kind: chirp, amplitude: 9, frequency: [2, 0.1], sweep: 30}"));
  EXPECT_EQ(chirp.amplitude, 9.0);
  EXPECT_EQ(chirp.first_frequency, 2.0);
  EXPECT_EQ(chirp.last_frequency, 0.1);
  EXPECT_EQ(chirp.sweep, 30.0);
  const auto prbs = std::get<PrbsInput>(input("{kind: prbs, amplitude: 9, hold: 0.2}"));
  EXPECT_EQ(prbs.amplitude, 9.0);
  EXPECT_EQ(prbs.hold, 0.2);
  const auto square = std::get<SquareInput>(input("{kind: square, amplitude: 9, frequency: 2}"));
  EXPECT_EQ(square.amplitude, 9.0);
  EXPECT_EQ(square.frequency, 2.0);
  const auto pilot =
      std::get<PilotInput>(input("{kind: pilot, amplitude: 9, hold: 3, levels: 12}"));
  EXPECT_EQ(pilot.amplitude, 9.0);
  EXPECT_EQ(pilot.hold, 3.0);
  EXPECT_EQ(pilot.num_levels, 12);
  EXPECT_EQ(std::get<ReplayInput>(input("{kind: file, file: c.csv}")).file, "c.csv");
}

TEST(ExperimentFile, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(MessageWith("duration: 60", "duration: 0"),
              AllOf(StartsWith("e.yaml:4: key 'duration' is 0"), HasSubstr("above 0")));
  EXPECT_THAT(MessageWith("command_rate: 5", "command_rate: 0.01"),
              AllOf(StartsWith("e.yaml:5: key 'command_rate' is 0.01"), HasSubstr("from 0.1")));
  EXPECT_THAT(MessageWith("frequency: 0.3", "frequency: 16"),
              AllOf(StartsWith("e.yaml:11: key 'surge.input.frequency' holds 16 rad/s"),
                    HasSubstr("half of the command_rate")));
  EXPECT_THAT(MessageWith("kind: sine", "kind: sinus"),
              AllOf(HasSubstr("key 'surge.input.kind' is 'sinus'"), HasSubstr("multisine")));
  EXPECT_THAT(MessageWith("hold: 10", "hold: 0.1"),
              AllOf(HasSubstr("key 'heave.setpoint.hold' is 0.1 s"), HasSubstr("0.2 s")));
  EXPECT_THAT(MessageWith("levels: [1, -1]", "levels: []"), HasSubstr("'heave.setpoint.levels'"));
  EXPECT_THAT(MessageWith("control: closed_loop", "control: closed"),
              AllOf(HasSubstr("key 'heave.control' is 'closed'"), HasSubstr("closed_loop")));
  EXPECT_THAT(MessageWith("kp: 30", "kp: -30"), HasSubstr("key 'heave.pid.kp' is -30"));
  EXPECT_THAT(MessageWith(", limit: 80", ""), HasSubstr("'heave.pid"));
  EXPECT_THAT(MessageWith("jitter: 0.004", "jitter: 0.4"),
              HasSubstr("key 'velocity.jitter' is 0.4, expected a number from 0 to 0.02"));
  EXPECT_THAT(MessageWith("correlation: 0.5", "correlation: 1"), HasSubstr("is 1, expected"));
  EXPECT_THAT(MessageWith("resolution: 0.001", "resolution: -1"), HasSubstr("velocity.resolution"));
  EXPECT_THAT(MessageWith("probability: 0.01", "probability: 2"), HasSubstr("is 2, expected"));
  EXPECT_THAT(
      MessageWith("probability: 0.02", "probability: 1.5"),
      HasSubstr("key 'velocity.outliers.probability' is 1.5, expected a number from 0 to 1"));
  EXPECT_THAT(MessageWith("heave: 0.4", "heave: -0.4"),
              HasSubstr("key 'velocity.outliers.heave' is -0.4, expected a number from 0"));
  EXPECT_THAT(MessageWith("heave: 0.4", "sway: 0.4"), HasSubstr("velocity.outliers.sway"));
  EXPECT_THAT(MessageWith("position: 0.7", "position: -1"),
              HasSubstr("key 'pose.outliers.position' is -1"));
  EXPECT_THAT(MessageWith("angle: 0.6", "angle: 4"), HasSubstr("key 'pose.outliers.angle' is 4"));
  EXPECT_THAT(MessageWith("force: 4,", "force: -4,"),
              HasSubstr("key 'surge.turbulence.force' is -4, expected a number from 0"));
  EXPECT_THAT(MessageWith("correlation_time: 7.5", "correlation_time: 0.01"),
              HasSubstr("key 'surge.turbulence.correlation_time' is 0.01, expected a number from "
                        "0.1"));
  EXPECT_THAT(MessageWith(", correlation_time: 7.5", ""), HasSubstr("'surge.turbulence"));
  EXPECT_THAT(MessageWith("length: [1, 2]", "length: [2, 1]"),
              HasSubstr("is [2, 1], expected [shortest, longest] in seconds"));
  EXPECT_THAT(MessageWith("{surge: 0.01}", "{sway: 0.01}"), HasSubstr("velocity.noise.sway"));
  EXPECT_THAT(MessageWith("held_out: [1040, 1060]", "held_out: [1060, 1040]"),
              HasSubstr("holds [1060, 1040], expected [from, to]"));
  EXPECT_THAT(MessageWith("name: both", "names: both"), HasSubstr("'name'"));
  EXPECT_THAT(MessageWith("notes:", "remarks:"), HasSubstr("'remarks'"));
  EXPECT_THAT(MessageWith("rate: 20", "rate: 1e9"), HasSubstr("key 'velocity.rate'"));
  EXPECT_THAT(MessageWith("duration: 60", "duration: 90000"),
              HasSubstr("samples, expected at most"));
}

TEST(ExperimentFile, RefusesAPilotThatCannotSteer) {
  const std::string sine = "{kind: sine, amplitude: 52.9, frequency: 0.3, phase: 0.5, offset: 2}";
  EXPECT_THAT(MessageWith(sine, "{kind: pilot, amplitude: 9, hold: 3, levels: 0}"),
              HasSubstr("key 'surge.input.levels' is 0, expected a whole number from 1 to 1000"));
  EXPECT_THAT(MessageWith(sine, "{kind: pilot, amplitude: 9, hold: 0.1, levels: 5}"),
              HasSubstr("key 'surge.input.hold' is 0.1 s, expected at least one period"));
  EXPECT_THAT(MessageWith(sine, "{kind: pilot, hold: 3, levels: 5}"),
              HasSubstr("'surge.input.amplitude' is missing"));
}

TEST(ExperimentFile, ReadsThrustersFinsAndWhatIsMeasured) {
  const Experiment e = ParseExperiment(
      "e.yaml",
      "name: fins\nduration: 60\ncommand_rate: 5\n"
      "thrusters: {port: {kind: random_steps, amplitude: 30, hold: [2, 6], offset: 4}}\n"
      "fins: {rudder: {kind: sine, amplitude: 0.2, frequency: 0.3}}\n"
      "velocity: {rate: 10, noise: {yaw: 0.02}, dofs: [yaw, surge]}\n");
  EXPECT_TRUE(e.drives.empty());
  ASSERT_EQ(e.thrusters.size(), 1u);
  EXPECT_EQ(e.thrusters[0].name, "port");
  const auto& steps = std::get<RandomStepsInput>(e.thrusters[0].input.kind);
  EXPECT_EQ(steps.amplitude, 30.0);
  EXPECT_EQ(steps.shortest, 2.0);
  EXPECT_EQ(steps.longest, 6.0);
  EXPECT_EQ(e.thrusters[0].input.offset, 4.0);
  ASSERT_EQ(e.fins.size(), 1u);
  EXPECT_EQ(e.fins[0].name, "rudder");
  EXPECT_THAT(e.velocity->dofs, testing::ElementsAre(Dof::kSurge, Dof::kYaw));
  EXPECT_EQ(e.velocity->noise[5], 0.02);
}

TEST(ExperimentFile, RefusesThrustersAndFinsThatNoLogHolds) {
  const auto error = [](const std::string& lines) {
    return ErrorFrom([&] {
      ParseExperiment("e.yaml",
                      "name: fins\nduration: 60\ncommand_rate: 5\nvelocity: {rate: 10}\n" + lines);
    });
  };
  const std::string port = "thrusters: {port: {kind: random_steps, amplitude: 3, hold: [2, 6]}}\n";
  EXPECT_EQ(
      error(port + "heave: {control: open_loop, input: {kind: steps, levels: [1], hold: 1}}\n"),
      "e.yaml:5: key 'thrusters' stands beside 'heave', expected thrusters or forces: a "
      "command.csv holds one of them.");
  EXPECT_THAT(error("fins: {rudder: {kind: file, file: a.csv}}\n"),
              HasSubstr("e.yaml:5: key 'fins.rudder.kind' is 'file'"));
  EXPECT_THAT(error("fins: {rudder: {kind: random_steps, amplitude: 3, hold: [6, 2]}}\n"),
              HasSubstr("key 'fins.rudder.hold' is [6, 2], expected shortest, longest"));
  EXPECT_THAT(error("fins: {rudder: {kind: random_steps, amplitude: 3, hold: [0.1, 2]}}\n"),
              HasSubstr("key 'fins.rudder.hold' is 0.1 s, expected at least one period"));
  EXPECT_THAT(MessageWith("rate: 20", "rate: 20\n  dofs: [surge, up]"),
              HasSubstr("key 'velocity.dofs' holds 'up', expected surge, sway"));
}

TEST(ExperimentFile, RefusesAnExperimentWithoutDriveOrMotion) {
  EXPECT_THAT([] { ParseExperiment("e.yaml", "name: a\nduration: 9\ncommand_rate: 5\n"); },
              testing::ThrowsMessage<InputError>(HasSubstr("drives no DOF")));
  EXPECT_THAT(
      [] {
        ParseExperiment("e.yaml",
                        "name: a\nduration: 9\ncommand_rate: 5\nyaw: {control: open_loop, "
                        "input: {kind: sine, amplitude: 1, frequency: 1}}\n");
      },
      testing::ThrowsMessage<InputError>(HasSubstr("logs no motion")));
}

TEST(ExperimentFile, ReadsTheBundledExperiments) {
  int num_files = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(std::string(FATHOM_DATA_DIR) + "/experiments")) {
    EXPECT_NO_THROW(ReadExperimentFile(file.path())) << file.path();
    ++num_files;
  }
  EXPECT_GE(num_files, 3);
}

TEST(ExperimentFile, FindsTheReplayedCommandBesideIt) {
  const std::filesystem::path folder = TestFolder();
  std::ofstream(folder / "command.csv") << "t,tau_yaw,tau_surge\n100,7,1.5\n100.5,8,-2\n";
  std::ofstream(folder / "e.yaml")
      << "name: a\nduration: 9\ncommand_rate: 5\nvelocity: {rate: 5}\n"
         "surge: {control: open_loop, input: {kind: file, file: command.csv}}\n";
  const Experiment e = ReadExperimentFile(folder / "e.yaml");
  const auto& replay = std::get<ReplayInput>(e.drives.at(0).input.kind);
  EXPECT_THAT(replay.command.time, testing::ElementsAre(100.0, 100.5));
  EXPECT_THAT(replay.command.value, testing::ElementsAre(1.5, -2.0));

  std::ofstream(folder / "command.csv") << "t,tau_yaw\n100,7\n100.5,8\n";
  EXPECT_THAT(
      [&] { ReadExperimentFile(folder / "e.yaml"); },
      testing::ThrowsMessage<InputError>(AllOf(HasSubstr("command.csv"), HasSubstr("tau_surge"))));
}

}  // namespace
}  // namespace fathom
