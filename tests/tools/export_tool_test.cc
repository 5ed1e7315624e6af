// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/process/run_child.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Path = std::filesystem::path;

// The small model with one text in place of another.
std::string ChangedModel(const std::string& from, const std::string& to) {
  std::string model = SmallModelJson();
  model.replace(model.find(from), from.size(), to);
  return model;
}

std::string WholeVehicle() {
  return SmallVehicleYaml() +
         "rigid_body: {inertia_tensor: [[0.4, 0, 0], [0, 0.6, 0], [0, 0, 0.8]], centre_of_mass: "
         "[0, 0, 0.02]}\n";
}

// In an empty folder: a model, vehicles, and what is to be written.
struct ExportInputs {
  Path folder = EmptyTestFolder();
  std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  std::string vehicle = WriteTestFile(folder / "vehicle.yaml", WholeVehicle()).string();
  std::string bare = WriteTestFile(folder / "bare.yaml", SmallVehicleYaml()).string();

  std::string Out(const std::string& name) const { return (folder / name).string(); }
};

TEST(ExportTool, WritesEachFormatAndSaysWhatItChecked) {
  const ExportInputs inputs;
  const struct {
    std::string format, file, begins;
  } formats[] = {
      {"c", "small.h", "/* small: a motion model of surge."},
      {"csv", "small.csv", "# small: a motion model of surge.\n"},
      {"gazebo", "small.sdf", "<?xml version=\"1.0\"?>\n<!-- small: a motion model"},
      {"mss", "small.m", "function xdot = small(x, ui)\n"},
      {"stonefish", "small.scn", "<?xml version=\"1.0\"?>\n<!-- small: a motion model"},
      {"uuv", "small_uuv.sdf", "<?xml version=\"1.0\"?>\n<!-- small_uuv: a motion model"},
      {"vrx", "small_vrx.sdf", "<?xml version=\"1.0\"?>\n<!-- small_vrx: a motion model"}};
  for (const auto& [format, file, begins] : formats) {
    const std::string out = inputs.Out(file);
    const ToolRun run = RunsWell("fathom_export",
                                 {"--model=" + inputs.model,
                                  "--vehicle=" + inputs.vehicle,
                                  "--format=" + format,
                                  "--out=" + out});
    EXPECT_THAT(run.out, StartsWith(out + " written: a "));
    EXPECT_THAT(run.out, HasSubstr("Checked: the inertia, a free decay.\n"));
    EXPECT_THAT(TextOf(out), StartsWith(begins));
    EXPECT_THAT(TextOf(out), HasSubstr("Made by fathom_export "));
  }
}

// A force that holds from a time on, and whether the speed at that time is wanted.
struct HeldForce {
  double time = 0.0;
  double force = 0.0;
  bool is_wanted = true;
};

// The wanted speeds of a program that steps through small.h from one time to the next, with
// `make_tau` before each step.
std::vector<double> SpeedsInC(const Path& folder,
                              const std::vector<HeldForce>& forces,
                              double first_speed,
                              const std::string& make_tau = "tau[0] = command[0]") {
  std::string rows;
  for (const HeldForce& row : forces) {
    rows += fmt::format("{{{}, {}, {}}},\n", row.time, row.force, row.is_wanted ? 1 : 0);
  }
  const std::string main = fmt::format(
      "#include \"small.h\"\n#include <stdio.h>\n"
      "static const double held[{0}][3] = {{\n{1}}};\n"
      "int main(void) {{\n"
      "  small_state state = {{{{{2}}}, {{0, 0, 0, 1}}, {{0}}}};\n"
      "  double command[6] = {{0}}, tau[6] = {{0}};\n"
      "  int i;\n"
      "{3}"
      "  for (i = 0; i < {0}; ++i) {{\n"
      "    const double h = i + 1 < {0} ? held[i + 1][0] - held[i][0] : 0.0;\n"
      "    if (held[i][2] > 0) printf(\"%.17g\\n\", state.nu[0]);\n"
      "    command[0] = held[i][1];\n"
      "    if (h == 0.0) continue;\n"
      "    {4};\n"
      "    small_step(&state, tau, h);\n"
      "  }}\n"
      "  return 0;\n"
      "}}\n",
      forces.size(),
      rows,
      first_speed,
      make_tau.find("thrusters") == std::string::npos ? ""
                                                      : "  small_thrusters thrusters = {{0}};\n",
      make_tau);
  const Path source = WriteTestFile(folder / "main.c", main);
  const std::string program = (folder / "program").string();
  const ChildResult compiled =
      RunChild({"cc", {"-std=c99", "-o", program, source.string(), "-lm"}});
  EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
  std::istringstream out(RunChild({program, {}}).out);
  std::vector<double> speeds;
  for (double speed = 0.0; out >> speed;) speeds.push_back(speed);
  return speeds;
}

// The model as a C program predicts a log as fathom_simulate does.
TEST(ExportTool, PredictsALogInCAsFathomSimulateDoes) {
  const ExportInputs inputs;
  const Path log = WriteSmallLog(inputs.folder / "log");
  const Path csv = inputs.folder / "prediction.csv";
  RunsWell("fathom_simulate", {"--model=" + inputs.model, Flag("log", log), Flag("out", csv)});
  RunsWell("fathom_export",
           {"--model=" + inputs.model, "--format=c", "--out=" + inputs.Out("small.h")});
  const std::vector<double> speeds = ReadColumns(csv).Values("u");
  std::vector<HeldForce> forces;
  for (const auto& row : ReadColumns(log / "command.csv").rows) forces.push_back({row[0], row[1]});
  const std::vector<double> in_c = SpeedsInC(inputs.folder, forces, speeds.front());
  ASSERT_EQ(in_c.size(), speeds.size());
  // Both take the same steps of the same scheme, from stamp to stamp.
  for (std::size_t k = 0; k < speeds.size(); ++k) EXPECT_NEAR(in_c[k], speeds[k], 1e-12);
}

// Round trip: a log is made from a vehicle, a model identified from it and exported, and the
// command of the held-out minute run in C. Its NMAE, docs/models.md (8), is fathom_simulate's.
TEST(ExportTool, ScoresInCOnHeldOutDataAsFathomSimulateDoes) {
  const ExportInputs inputs;
  const Path log = inputs.folder / "log", csv = inputs.folder / "prediction.csv";
  const Path model = inputs.folder / "surge.json", score = inputs.folder / "score.json";
  const Path data = Path(FATHOM_DATA_DIR);
  RunsWell("fathom_synthesize",
           {Flag("vehicle", data / "vehicles" / "flatfish.yaml"),
            Flag("experiment", data / "experiments" / "surge_multisine.yaml"),
            "--seed=3",
            Flag("out", log)});
  RunsWell("fathom_identify", {Flag("log", log), "--dof=surge", Flag("model", model)});
  RunsWell("fathom_simulate",
           {Flag("model", model), Flag("log", log), Flag("out", csv), Flag("json", score)});
  RunsWell("fathom_export", {Flag("model", model), "--format=c", "--out=" + inputs.Out("small.h")});

  // From the first held-out stamp on, where fathom_simulate begins anew: the command's changes and
  // the stamps of the velocity in their order.
  const CsvColumns command = ReadColumns(log / "command.csv"),
                   measured = ReadColumns(log / "velocity.csv");
  const CsvColumns predicted = ReadColumns(csv);
  std::vector<HeldForce> forces;
  std::vector<double> truth;
  double first_speed = 0.0;
  std::size_t next = 0;
  for (std::size_t k = 0; k < measured.rows.size(); ++k) {
    const double time = measured.rows[k][0];
    for (; next < command.rows.size() && command.rows[next][0] <= time; ++next) {
      if (!truth.empty()) forces.push_back({command.rows[next][0], command.rows[next][1], false});
    }
    if (time - measured.rows[0][0] < 240.0) continue;  // held_out: [240, 300]
    if (truth.empty()) first_speed = predicted.rows[k][1];
    forces.push_back({time, command.rows[next - 1][1]});
    truth.push_back(measured.rows[k][1]);
  }
  const std::vector<double> in_c = SpeedsInC(inputs.folder, forces, first_speed);
  ASSERT_EQ(in_c.size(), truth.size());
  double errors = 0.0, speeds = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    errors += std::abs(in_c[k] - truth[k]);
    speeds += std::abs(truth[k]);
  }
  const double in_fathom = JsonOf(score)["held_out"]["nmae"];
  EXPECT_EQ(truth.size(), JsonOf(score)["held_out"]["n"]);
  EXPECT_GT(in_fathom, 0.01);
  // To three digits and beyond. Steps in C end at the stamps too.
  EXPECT_NEAR(errors / speeds, in_fathom, 1e-4 * in_fathom);
}

// One parameter of an effect.
struct EffectNumber {
  std::string effect, parameter, unit;
  double value = 0.0;
};

// The small model with effects.
std::string ModelWithEffects(const std::vector<EffectNumber>& numbers) {
  auto model = nlohmann::json::parse(SmallModelJson());
  for (const auto& [effect, parameter, unit, value] : numbers) {
    model["structure"]["effects"].push_back({{"effect", effect}});
    model["parameters"][effect + "." + parameter] = {
        {"value", value}, {"std", 0.1}, {"unit", unit}};
    for (auto& row : model["covariance"]) row.push_back(0.0);
    model["covariance"].push_back(std::vector<double>(model["covariance"][0].size(), 0.0));
    model["covariance"].back().back() = 0.01;
  }
  return model.dump();
}

// The thrusters' effects in C, in steps that are the same as fathom_simulate's.
TEST(ExportTool, PredictsThrustersInCAsFathomSimulateDoes) {
  const ExportInputs inputs;
  const Path log = WriteSmallLog(inputs.folder / "log");
  const Path csv = inputs.folder / "prediction.csv";
  const Path model = WriteTestFile(inputs.folder / "thrusters.json",
                                   ModelWithEffects({{"thrust_dead_zone", "width", "N", 1.5},
                                                     {"thrust_saturation", "limit", "N", 7.0},
                                                     {"thrust_asymmetry", "reverse_loss", "-", 0.2},
                                                     {"thruster_lag", "time_constant", "s", 0.7}}));
  RunsWell("fathom_simulate", {Flag("model", model), Flag("log", log), Flag("out", csv)});
  const ToolRun run = RunsWell(
      "fathom_export", {Flag("model", model), "--format=c", "--out=" + inputs.Out("small.h")});
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(TextOf(inputs.Out("small.h")),
              HasSubstr("#define SMALL_SURGE_THRUSTER_LAG_TIME_CONSTANT (0.7) /* s, 95 % interval "
                        "0.504 to 0.896, log small */\n"));
  const std::vector<double> speeds = ReadColumns(csv).Values("u");
  std::vector<HeldForce> forces;
  for (const auto& row : ReadColumns(log / "command.csv").rows) forces.push_back({row[0], row[1]});
  const std::vector<double> in_c =
      SpeedsInC(inputs.folder, forces, speeds.front(), "small_thrust(command, h, &thrusters, tau)");
  ASSERT_EQ(in_c.size(), speeds.size());
  for (std::size_t k = 0; k < speeds.size(); ++k) EXPECT_NEAR(in_c[k], speeds[k], 1e-12);
}

TEST(ExportTool, SaysOnStderrAndInTheFileWhatItLeavesOut) {
  const ExportInputs inputs;
  const Path model = WriteTestFile(inputs.folder / "lag.json",
                                   ModelWithEffects({{"thruster_lag", "time_constant", "s", 0.5}}));
  const std::string out = inputs.Out("lag.m");
  const ToolRun run =
      RunsWell("fathom_export", {Flag("model", model), "--format=mss", "--out=" + out});
  const std::string remark = "The effect thruster_lag of surge is left out (time_constant 0.5 s)";
  EXPECT_THAT(run.err, HasSubstr("fathom_export: note: " + remark));
  EXPECT_THAT(TextOf(out), HasSubstr("% Note: " + remark));
}

TEST(ExportTool, SaysHowLateTheCommandIs) {
  const ExportInputs inputs;
  const Path model = WriteTestFile(inputs.folder / "late.json",
                                   ModelWithEffects({{"time_offset", "offset", "s", 0.3}}));
  const ToolRun run = RunsWell(
      "fathom_export", {Flag("model", model), "--format=c", "--out=" + inputs.Out("late.h")});
  EXPECT_EQ(
      run.err,
      "fathom_export: note: Give the command of surge 0.3 s late (below 0: early): the effect "
      "time_offset.\n");
  EXPECT_THAT(TextOf(inputs.Out("late.h")),
              HasSubstr("#define LATE_SURGE_TIME_OFFSET_OFFSET (0.3)"));
}

TEST(ExportTool, SaysWhatGazeboLacksAndHowToWriteIt) {
  const ExportInputs inputs;
  EXPECT_THAT(
      ExpectRefusal("fathom_export",
                    {"--model=" + inputs.model,
                     "--vehicle=" + inputs.bare,
                     "--format=gazebo",
                     "--out=" + inputs.Out("small.sdf")},
                    inputs.folder),
      AllOf(StartsWith("fathom_export: " + inputs.bare +
                       ": has no key 'rigid_body.inertia_tensor', nor "
                       "'rigid_body.centre_of_mass'. --format=gazebo wants"),
            HasSubstr("expected `rigid_body: {inertia_tensor: [[0.4, 0, 0], [0, 0.6, 0], [0, 0, "
                      "0.8]], centre_of_mass: [0, 0, 0.02]}`")));
  EXPECT_THAT(
      ExpectRefusal(
          "fathom_export",
          {"--model=" + inputs.model, "--format=gazebo", "--out=" + inputs.Out("small.sdf")},
          inputs.folder),
      StartsWith("fathom_export: --vehicle: is missing."));
}

TEST(ExportTool, RefusesANameThatMatlabCannotCall) {
  const ExportInputs inputs;
  EXPECT_THAT(
      ExpectRefusal("fathom_export",
                    {"--model=" + inputs.model, "--format=mss", "--out=" + inputs.Out("my-boat.m")},
                    inputs.folder),
      HasSubstr("expected a name such as boat.m"));
  EXPECT_THAT(
      ExpectRefusal("fathom_export",
                    {"--model=" + inputs.model, "--format=mss", "--out=" + inputs.Out("end.m")},
                    inputs.folder),
      HasSubstr("'end' is a reserved word of MATLAB or Octave"));
}

TEST(ExportTool, RefusesAFormatThatThereIsNot) {
  const ExportInputs inputs;
  EXPECT_EQ(ExpectRefusal(
                "fathom_export",
                {"--model=" + inputs.model, "--format=urdf", "--out=" + inputs.Out("small.urdf")},
                inputs.folder),
            "fathom_export: --format: is 'urdf', expected c, csv, gazebo, mss, stonefish, "
            "uuv or vrx.\n");
}

TEST(ExportTool, RefusesASpeedThatIsNone) {
  const ExportInputs inputs;
  EXPECT_EQ(ExpectRefusal("fathom_export",
                          {"--model=" + inputs.model,
                           "--format=stonefish",
                           "--speed=0",
                           "--out=" + inputs.Out("small.scn")},
                          inputs.folder),
            "fathom_export: --speed: is 0, expected a speed above 0 m/s.\n");
  EXPECT_EQ(
      ExpectRefusal(
          "fathom_export",
          {"--model=" + inputs.model, "--format=c", "--speed=1", "--out=" + inputs.Out("small.h")},
          inputs.folder),
      "fathom_export: --speed: goes with --format=stonefish, expected none with "
      "--format=c.\n");
}

TEST(ExportTool, RefusesToWriteOverItsModel) {
  const ExportInputs inputs;
  EXPECT_THAT(ExpectRefusal("fathom_export",
                            {"--model=" + inputs.model, "--format=c", "--out=" + inputs.model},
                            inputs.folder),
              HasSubstr("--out=" + inputs.model));
}

// Without damping nothing ends the motion. Nothing is written.
TEST(ExportTool, WritesNothingOfAModelThatFailsACheck) {
  const ExportInputs inputs;
  std::string text = ChangedModel("{\"value\": 30,", "{\"value\": 0,");
  text.replace(text.find("{\"value\": 5,"), 12, "{\"value\": 0,");
  const std::string model = WriteTestFile(inputs.folder / "ice.json", text).string();
  const auto before = ListOf(inputs.folder);
  const ToolRun run = RunToolBinary(
      "fathom_export", {"--model=" + model, "--format=c", "--out=" + inputs.Out("ice.h")});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err,
            "fathom_export: not written: A DOF has no damping: nothing ends its motion.\n");
  EXPECT_EQ(ListOf(inputs.folder), before);
}

}  // namespace
}  // namespace fathom
