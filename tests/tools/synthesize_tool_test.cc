// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log.h"
#include "fathom/log/read_log.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "bundled_data.h"
#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kVehicle = "--vehicle=" + kData + "/vehicles/flatfish.yaml";
const std::string kExperiment = "--experiment=" + kData + "/experiments/table1.yaml";

const char kShortExperiment[] = R"(name: short
duration: 4
command_rate: 10
surge: {control: open_loop, input: {kind: sine, amplitude: 50, frequency: 1}}
velocity: {rate: 10, noise: {surge: 0.01}}
)";

ToolRun Synthesize(const std::vector<std::string>& arguments) {
  return RunToolBinary("fathom_synthesize", arguments);
}

// Names of what is in a folder.
TEST(SynthesizeTool, WritesTheBundledLogAgainByteForByte) {
  const fs::path out = EmptyTestFolder() / "flatfish";
  RunsWell(Synthesize({kVehicle, kExperiment, "--seed=1", Flag("out", out)}));
  for (const std::string file : {"log.yaml", "command.csv", "velocity.csv"}) {
    const std::string bundled = TextOf(kData + "/flatfish/" + file);
    EXPECT_GT(bundled.size(), 100u) << file;
    EXPECT_TRUE(bundled == TextOf(out / file)) << file << " differs from the bundled one";
  }
  EXPECT_THAT(ListOf(out), testing::SizeIs(3));
}

TEST(SynthesizeTool, SaysWhatItWroteAndWritesALogThatReads) {
  const fs::path out = EmptyTestFolder() / "log/";
  const ToolRun run =
      RunsWell(Synthesize({kVehicle, kExperiment, "--seed", "5", "--out", out.string()}));
  EXPECT_EQ(run.err, "");
  const Log log = ReadLog(out);
  EXPECT_THAT(log.dofs, testing::ElementsAre(Dof::kSurge, Dof::kHeave, Dof::kYaw));
  EXPECT_EQ(log.command->time.size(), 3000u);
  EXPECT_THAT(
      run.out,
      AllOf(HasSubstr("300 s of surge heave yaw, vehicle FlatFish, seed 5"),
            HasSubstr("command.csv  3000 rows"),
            HasSubstr("velocity.csv " + std::to_string(log.velocity->time.size()) + " rows"),
            HasSubstr("drop-outs took " + std::to_string(3000 - log.velocity->time.size()) +
                      " of 3000 samples")));
}

TEST(SynthesizeTool, HidesEffectsAndTellsOnlyTheTruthFile) {
  const fs::path folder = EmptyTestFolder();
  const fs::path experiment = WriteTestFile(folder / "e.yaml", kShortExperiment);
  const std::string given = Flag("experiment", experiment);
  RunsWell(Synthesize({kVehicle, given, Flag("out", folder / "plain")}));
  const ToolRun run = RunsWell(Synthesize({kVehicle,
                                           given,
                                           Flag("out", folder / "hidden"),
                                           "--effects=thruster_lag:time_constant=0.5,buoyancy_step",
                                           Flag("truth", folder / "truth.json")}));
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("hidden: surge.thruster_lag: time_constant = 0.5 s\n"),
                    HasSubstr("hidden: surge.buoyancy_step: jump = ")));
  EXPECT_THAT(TextOf(folder / "truth.json"),
              AllOf(HasSubstr("fathom-truth-1"), HasSubstr("thruster_lag"), HasSubstr("851.05")));
  EXPECT_EQ(TextOf(folder / "hidden/log.yaml"), TextOf(folder / "plain/log.yaml"));
  EXPECT_EQ(TextOf(folder / "hidden/command.csv"), TextOf(folder / "plain/command.csv"));
  EXPECT_NE(TextOf(folder / "hidden/velocity.csv"), TextOf(folder / "plain/velocity.csv"));
  EXPECT_THAT(ListOf(folder / "hidden"), testing::SizeIs(3));
}

// A coupled vehicle under its bundled experiment, for twenty seconds.
std::vector<std::string> ShortCoupledRun(const std::string& vehicle,
                                         const std::string& experiment,
                                         const fs::path& folder) {
  std::string lines = TextOf(kData + "/experiments/" + experiment + ".yaml");
  const auto replace = [&](const std::string& from, const std::string& to) {
    lines.replace(lines.find(from), from.size(), to);
  };
  replace("duration: 300", "duration: 20");
  replace("held_out: [240, 300]", "held_out: [15, 20]");
  return {"--vehicle=" + kData + "/vehicles/" + vehicle + ".yaml",
          Flag("experiment", WriteTestFile(folder / (vehicle + "_steps.yaml"), lines)),
          Flag("out", folder / vehicle)};
}

TEST(SynthesizeTool, PlaysThePublishedCoupledVehicles) {
  const fs::path folder = EmptyTestFolder();
  for (const auto& [vehicle, experiment] :
       std::vector<std::pair<std::string, std::string>>{{"bluerov2", "random_steps_rov"},
                                                        {"rexrov", "random_steps_work_class"},
                                                        {"remus100", "random_steps_auv"}}) {
    auto arguments = ShortCoupledRun(vehicle, experiment, folder);
    arguments.push_back(Flag("truth", folder / (vehicle + ".json")));
    const ToolRun run = RunsWell(Synthesize(arguments));
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("20 s of surge sway heave roll pitch yaw"));
    const Log log = ReadLog(folder / vehicle);
    EXPECT_EQ(log.vehicle, "vehicle.yaml");
    EXPECT_EQ(log.dofs.size(), 6u);
    EXPECT_EQ(log.velocity->columns.size(), 6u);
    EXPECT_EQ(log.command->columns.size(), 6u);
    EXPECT_EQ(log.fins.has_value(), vehicle == "remus100");
    EXPECT_EQ(log.pose->time.size(), 200u);
    // The truth is beside the log, not in it.
    EXPECT_THAT(TextOf(folder / vehicle / "vehicle.yaml"),
                AllOf(HasSubstr("mass: "), testing::Not(HasSubstr("coupled_model"))));
    EXPECT_THAT(TextOf(folder / (vehicle + ".json")), HasSubstr("\"inertia.sway.roll\""));
  }
}

TEST(SynthesizeTool, HidesNothingInACoupledVehicle) {
  const fs::path folder = EmptyTestFolder();
  auto arguments = ShortCoupledRun("bluerov2", "random_steps_rov", folder);
  arguments.push_back("--effects=thruster_lag");
  const ToolRun run = Synthesize(arguments);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err,
              StartsWith("fathom_synthesize: --effects: vehicle 'BlueROV2' has a coupled_model, in "
                         "which no effect can be hidden"));
  EXPECT_FALSE(fs::exists(folder / "bluerov2"));
}

TEST(SynthesizeTool, RefusesEffectsThatThereAreNot) {
  const fs::path folder = EmptyTestFolder();
  const auto message = [&](const std::string& effects) {
    const ToolRun run = Synthesize({kVehicle, kExperiment, Flag("out", folder / "log"), effects});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_FALSE(fs::exists(folder / "log"));
    return run.err;
  };
  EXPECT_THAT(message("--effects=slow"),
              StartsWith("fathom_synthesize: --effects: 'slow' is no effect, expected one of "));
  EXPECT_THAT(message("--effects=thruster_lag:time_constant=-1"),
              HasSubstr("time_constant is '-1', expected a number from 0 to 20."));
  EXPECT_THAT(message("--effects=pose_scale"),
              HasSubstr("logs no pose, expected one since pose_scale shows in nothing else"));
}

TEST(SynthesizeTool, ReplacesALogOnlyWhenTold) {
  const fs::path folder = EmptyTestFolder();
  const std::string experiment =
      "--experiment=" + WriteTestFile(folder / "e.yaml", kShortExperiment).string();
  const std::string out = Flag("out", folder / "log");
  RunsWell(Synthesize({kVehicle, experiment, out}));
  const std::string first = TextOf(folder / "log/velocity.csv");

  const ToolRun refused = Synthesize({kVehicle, experiment, out, "--seed=2"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err, AllOf(HasSubstr("is not empty"), HasSubstr("--overwrite")));
  EXPECT_EQ(TextOf(folder / "log/velocity.csv"), first);

  RunsWell(Synthesize({kVehicle, experiment, out, "--seed=2", "--overwrite"}));
  EXPECT_NE(TextOf(folder / "log/velocity.csv"), first);
}

TEST(SynthesizeTool, WritesTheTruthOnlyBesideALogThatIsThere) {
  const fs::path folder = EmptyTestFolder();
  const std::string experiment =
      "--experiment=" + WriteTestFile(folder / "e.yaml", kShortExperiment).string();
  const std::string out = Flag("out", folder / "log");
  const std::string inside = (folder / "log/truth.json").string();
  ToolRun run = Synthesize({kVehicle, experiment, out, "--truth=" + inside});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err,
            "fathom_synthesize: --truth=" + inside +
                ": lies in --out=" + (folder / "log").string() +
                ", which is replaced as a whole, expected a file elsewhere.\n");
  // A film that shows no marker fails after the motion is made.
  const std::string films = std::string(FATHOM_DATA_DIR) + "/films/";
  const fs::path film =
      WriteTestFile(folder / "film.yaml",
                    "camera: " + films + "wall_camera.yaml\ntags: away.yaml\nmount: " + films +
                        "wall_mount.yaml\n");
  WriteTestFile(
      folder / "away.yaml",
      "family: tag36h11\ntags: [{id: 1, size: 0.4, world_from_tag: {position: [-4, 0, 0], "
      "quaternion: [0.5, 0.5, 0.5, 0.5]}}]\n");
  const std::string truth = Flag("truth", folder / "truth.json");
  run = Synthesize({kVehicle, experiment, out, truth, Flag("film", film)});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_FALSE(fs::exists(folder / "truth.json"));
  EXPECT_FALSE(fs::exists(folder / "log"));
  RunsWell(Synthesize({kVehicle, experiment, out, truth}));
  EXPECT_TRUE(fs::exists(folder / "truth.json"));
}

TEST(SynthesizeTool, RefusesAPlaceThatCannotBeWritten) {
  const fs::path folder = EmptyTestFolder();
  const fs::path file = WriteTestFile(folder / "file", "text");
  const ToolRun is_file = Synthesize({kVehicle, kExperiment, Flag("out", file)});
  EXPECT_EQ(is_file.exit_code, 1);
  EXPECT_THAT(is_file.err, HasSubstr("is a file"));
  const ToolRun below = Synthesize({kVehicle, kExperiment, Flag("out", file / "log")});
  EXPECT_EQ(below.exit_code, 1);
  EXPECT_THAT(below.err, HasSubstr("cannot write"));
  EXPECT_EQ(TextOf(file), "text");
}

// The frame that all tools share, tools/tool.h.

TEST(RunTool, RefusesBadFlagsWithExitCode1) {
  const auto expect_refusal = [](const std::vector<std::string>& arguments,
                                 const std::string& message) {
    const ToolRun run = Synthesize(arguments);
    EXPECT_EQ(run.exit_code, 1) << message;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, "fathom_synthesize: " + message + "\n");
  };
  expect_refusal(
      {"--sed=1"},
      "--sed: there is no such flag, did you mean --seed? See fathom_synthesize --help.");
  expect_refusal({"--minloglevel=0"},
                 "--minloglevel: there is no such flag. See fathom_synthesize --help.");
  expect_refusal({"--seed=one"}, "--seed: is 'one', expected a whole number, at least 0.");
  expect_refusal({"--seed=-1"}, "--seed: is '-1', expected a whole number, at least 0.");
  expect_refusal({"--seed"}, "--seed: has no value, expected a whole number, at least 0.");
  expect_refusal({"--seed=1", "--seed=2"}, "--seed: is given twice, expected once.");
  expect_refusal({"--overwrite=perhaps"}, "--overwrite: is 'perhaps', expected true or false.");
  expect_refusal(
      {"--noseed"},
      "--noseed: there is no such flag, did you mean --seed? See fathom_synthesize --help.");
  expect_refusal({"e.yaml"},
                 "'e.yaml': is no flag, expected --name=value. See fathom_synthesize --help.");
  expect_refusal({}, "--vehicle: is missing, expected a vehicle file.");
  expect_refusal({kVehicle}, "--experiment: is missing, expected an experiment file.");
  expect_refusal({kVehicle, kExperiment},
                 "--out: is missing, expected the folder of the log to write.");
}

TEST(RunTool, PrintsItsOwnHelpAndVersion) {
  const ToolRun help = RunsWell(Synthesize({"--seed=1", "--help"}));
  EXPECT_EQ(help.err, "");
  EXPECT_THAT(help.out,
              AllOf(HasSubstr("Usage: fathom_synthesize"),
                    HasSubstr("--seed (default 1)"),
                    HasSubstr("Example:"),
                    testing::Not(HasSubstr("minloglevel")),
                    testing::Not(HasSubstr("flagfile"))));
  const ToolRun version = RunsWell(Synthesize({"--version"}));
  EXPECT_THAT(version.out,
              testing::MatchesRegex(
                  "fathom [0-9]+\\.[0-9]+\\.[0-9]+ \\(([0-9a-f]+( with changes)?|unknown)\\)\n"));
}

TEST(SynthesizeTool, FilmsTheExperimentAsDetectionsOrImages) {
  const fs::path folder = EmptyTestFolder();
  const std::string experiment =
      "--experiment=" + WriteTestFile(folder / "short.yaml", kShortExperiment).string();
  const std::string film = "--film=" + kData + "/films/wall_four.yaml";
  const fs::path corners = folder / "corners";
  RunsWell(Synthesize({kVehicle, experiment, film, Flag("out", corners)}));
  const std::string detections = TextOf(corners / "detections.csv");
  // Four tags in each of 40 frames, below the column names.
  EXPECT_EQ(std::count(detections.begin(), detections.end(), '\n'), 161);
  for (const std::string file : {"camera", "tags", "mount"}) {
    EXPECT_GT(TextOf(corners / (file + ".yaml")).size(), 50u) << file;
  }

  const fs::path images = folder / "images";
  const std::string few =
      "--experiment=" + WriteTestFile(folder / "few.yaml",
                                      "name: few\nduration: 0.3\ncommand_rate: 10\nsurge: "
                                      "{control: open_loop, input: {kind: sine, amplitude: 50, "
                                      "frequency: 1}}\nvelocity: {rate: 10}\n")
                            .string();
  const ToolRun run = RunsWell(Synthesize({kVehicle, few, film, "--render", Flag("out", images)}));
  // Where nobody watches a line of progress, too.
  EXPECT_THAT(run.err, testing::MatchesRegex("drawing 3 images, about [1-9][0-9]* MB\n"));
  EXPECT_EQ(TextOf(images / "frames.csv"),
            "t,file\n0,frames/000000.png\n0.1,frames/000001.png\n0.2,frames/000002.png\n");
  EXPECT_THAT(TextOf(images / "frames/000002.png"), StartsWith("\x89PNG"));
  EXPECT_FALSE(fs::exists(images / "detections.csv"));
}

TEST(SynthesizeTool, RefusesToRenderWithoutAFilm) {
  const fs::path out = EmptyTestFolder() / "log";
  const ToolRun run = Synthesize({kVehicle, kExperiment, "--render", Flag("out", out)});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err, "fathom_synthesize: --render: needs --film, expected both.\n");
}

}  // namespace
}  // namespace fathom
