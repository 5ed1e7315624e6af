// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

// The paper's Table I, from which data/flatfish is made, and how close the inertia has to come.
struct DofTruth {
  const char* dof;
  double inertia;    // [kg] or [kg m^2]
  double tolerance;  // relative
};

std::ostream& operator<<(std::ostream& out, const DofTruth& truth) { return out << truth.dof; }

std::string DofOfTruth(const ::testing::TestParamInfo<DofTruth>& info) { return info.param.dof; }

nlohmann::json IdentifiedModel(const std::vector<std::string>& arguments) {
  const Path model = TestFolder() / "model.json";
  std::vector<std::string> all = arguments;
  all.push_back(Flag("model", model));
  RunsWell("fathom_identify", all);
  return JsonOf(model);
}

double InertiaOf(const nlohmann::json& model) { return model["parameters"]["inertia"]["value"]; }

class IdentifyFlatfish : public ::testing::TestWithParam<DofTruth> {};

TEST_P(IdentifyFlatfish, OutputErrorFindsTheInertia) {
  const auto& [dof, inertia, tolerance] = GetParam();
  const auto model = IdentifiedModel({"--log=" + kFlatfish, std::string("--dof=") + dof});
  EXPECT_EQ(model["schema"], "fathom-model-1");
  EXPECT_EQ(model["dof"], dof);
  EXPECT_EQ(model["provenance"]["family"], "output_error");
  EXPECT_NEAR(InertiaOf(model), inertia, tolerance * inertia);
  // The interval is of use, and the truth is not far outside of it.
  const double std = model["parameters"]["inertia"]["std"];
  EXPECT_LT(std, tolerance * inertia);
  EXPECT_NEAR(InertiaOf(model), inertia, 4.0 * std);
}

TEST_P(IdentifyFlatfish, TheAdaptiveLawAgreesWithinFivePercent) {
  const std::string dof = std::string("--dof=") + GetParam().dof;
  const double output_error = InertiaOf(IdentifiedModel({"--log=" + kFlatfish, dof}));
  const double adaptive =
      InertiaOf(IdentifiedModel({"--log=" + kFlatfish, dof, "--family=adaptive"}));
  EXPECT_NEAR(adaptive, output_error, 0.05 * output_error);
}

TEST(IdentifyTool, SaysHowItWeighed) {
  const std::vector<std::string> arguments = {"--log=" + kFlatfish, "--dof=surge"};
  const auto weighed_by = [&](const std::string& weighting) {
    auto all = arguments;
    all.push_back("--weighting=" + weighting);
    return IdentifiedModel(all)["provenance"];
  };
  EXPECT_EQ(weighed_by("plain")["weighting"], "plain");
  EXPECT_EQ(weighed_by("learned")["weighting"], "learned");
  EXPECT_EQ(IdentifiedModel(arguments)["provenance"]["weighting"], "plain");
  auto removed = arguments;
  removed.push_back("--weighting=auto");
  EXPECT_THAT(ExpectRefusal("fathom_identify", removed),
              HasSubstr("--weighting: is 'auto', expected one of plain, learned."));
}

INSTANTIATE_TEST_SUITE_P(TableI,
                         IdentifyFlatfish,
                         ::testing::Values(DofTruth{"surge", 851.05, 0.01},
                                           DofTruth{"heave", 1511.53, 0.02},
                                           DofTruth{"yaw", 301.60, 0.02}),
                         DofOfTruth);

TEST(IdentifyTool, PrintsParametersWithIntervalsAndFigures) {
  const ToolRun run = RunsWell("fathom_identify", {"--log=" + kFlatfish, "--dof=surge"});
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("surge by output error from velocity.csv: "),
                    HasSubstr("95 % interval"),
                    HasSubstr("inertia"),
                    HasSubstr("kg/m"),
                    HasSubstr("training "),
                    HasSubstr("held out ")));
  // As the interval in the model file: value and 1.96 std.
  EXPECT_NEAR(NumberBehind("inertia", run.out), 851.05, 8.5);
}

TEST(IdentifyTool, TheSameLogGivesTheSameBytes) {
  const Path folder = EmptyTestFolder();
  std::vector<std::string> models, outputs;
  for (const char* name : {"first.json", "second.json"}) {
    const ToolRun run = RunToolBinary(
        "fathom_identify", {"--log=" + kFlatfish, "--dof=yaw", Flag("model", folder / name)});
    models.push_back(TextOf(folder / name));
    outputs.push_back(run.out);
  }
  EXPECT_FALSE(models[0].empty());
  EXPECT_EQ(models[0], models[1]);
  EXPECT_EQ(outputs[0], outputs[1]);
}

// A log and its copy with another reading in surge, so that it passes for another run: the same
// optimum in yaw, counted as if known twice as well.
TEST(IdentifyTool, TakesSeveralLogsTogether) {
  const auto once = IdentifiedModel({"--log=" + kFlatfish, "--dof=yaw"});
  const Path copy = EmptyTestFolder() / "again";
  std::filesystem::copy(kFlatfish, copy, std::filesystem::copy_options::recursive);
  std::string velocity = TextOf(copy / "velocity.csv");
  ASSERT_EQ(velocity.find("t,u,"), 0u);
  velocity.insert(velocity.find(',', velocity.find('\n')) + 1, "1");
  WriteTestFile(copy / "velocity.csv", velocity);
  const auto twice = IdentifiedModel({"--log=" + kFlatfish + "," + copy.string(), "--dof=yaw"});
  EXPECT_EQ(twice["fit"]["n"].get<int>(), 2 * once["fit"]["n"].get<int>());
  const double std_once = once["parameters"]["inertia"]["std"];
  const double std_twice = twice["parameters"]["inertia"]["std"];
  EXPECT_NEAR(InertiaOf(twice), InertiaOf(once), 0.05 * std_once);
  // 1 / sqrt(2), but for the correction for the number of unknowns, a few out of hundreds of
  // effective samples. In heave and surge slow noise leaves fewer.
  EXPECT_NEAR(std_twice / std_once, std::sqrt(0.5), 0.03);
}

// The same motion under a command that reads 12 N more: as the log of a vehicle trimmed anew.
TEST(IdentifyTool, GivesEachLogItsOwnOffsetIfAskedTo) {
  const Path folder = EmptyTestFolder();
  const std::string first = WriteSmallLog(folder / "before").string();
  const std::string second = WriteSmallLog(folder / "after").string();
  std::istringstream rows(SmallCommandCsv());
  std::string row, text;
  std::getline(rows, text);
  while (std::getline(rows, row)) {
    const std::size_t comma = row.find(',');
    const double force = std::stod(row.substr(comma + 1)) + 12.0;
    text += "\n" + row.substr(0, comma) + "," + std::to_string(force);
  }
  WriteTestFile(Path(second) / "command.csv", text);
  const std::vector<std::string> logs = {"--log=" + first, "--log=" + second, "--dof=surge"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), logs.begin(), logs.end());
    return more;
  };
  const auto alone = IdentifiedModel({"--log=" + first, "--dof=surge"});
  const auto own = IdentifiedModel(with({"--offset=per_log"}));
  EXPECT_NEAR(InertiaOf(own), InertiaOf(alone), 0.05 * InertiaOf(alone));
  const double offset = alone["parameters"]["buoyancy"]["value"];
  EXPECT_NEAR(own["parameters"]["buoyancy"]["value"].get<double>(), offset + 6.0, 0.3);
  EXPECT_EQ(own["provenance"]["offset"], "per_log");
  const ToolRun run = RunToolBinary("fathom_identify", with({"--offset=per_log"}));
  EXPECT_THAT(run.out, HasSubstr("They scatter by 8.5 N"));  // 12 / sqrt(2)
  EXPECT_THAT(run.out, HasSubstr("training NMAE\n"));
}

TEST(IdentifyTool, RefusesOffsetsPerLogOfAFamilyThatHasNone) {
  EXPECT_THAT(
      ExpectRefusal(
          "fathom_identify",
          {"--log=" + kFlatfish, "--dof=heave", "--offset=per_log", "--family=least_squares"}),
      HasSubstr("--offset: is per_log, expected shared: the family least_squares has one "
                "offset in all logs."));
  EXPECT_THAT(
      ExpectRefusal("fathom_identify", {"--log=" + kFlatfish, "--dof=heave", "--offset=each"}),
      HasSubstr("--offset: is 'each', expected one of shared, per_log."));
}

TEST(IdentifyTool, RefusesACopyOfALogBesideIt) {
  const Path folder = EmptyTestFolder();
  const std::string copy = (folder / "other").string();
  std::filesystem::copy(kFlatfish, copy, std::filesystem::copy_options::recursive);
  EXPECT_THAT(ExpectRefusal("fathom_identify", {"--log=" + kFlatfish + "," + copy, "--dof=heave"}),
              HasSubstr("--log: " + kFlatfish + " and " + copy +
                        " hold the same data, expected each log once."));
}

TEST(IdentifyTool, ASingleCsvGivesTheSameModelAsTheFolderOfItsColumns) {
  const Path folder = EmptyTestFolder();
  const Path csv = WriteTestFile(folder / "run.csv", SmallSingleCsv());
  const Path log = WriteSmallLog(folder / "log");
  for (const Path& path : {csv, log}) {
    RunsWell(
        "fathom_identify",
        {Flag("log", path), "--dof=surge", "--model=" + (folder / path.stem()).string() + ".json"});
  }
  const auto from_csv = JsonOf(folder / "run.json");
  EXPECT_EQ(from_csv["parameters"], JsonOf(folder / "log.json")["parameters"]);
  // Data without noise, the file's six digits aside: the truth of small_log.h.
  EXPECT_NEAR(InertiaOf(from_csv), 40.0, 0.04);
}

TEST(IdentifyTool, RefusesAFlagByItsOwnNameAndRange) {
  for (const std::string flag : {"huber", "shooting_window"}) {
    EXPECT_EQ(ExpectRefusal("fathom_identify",
                            {"--log=" + kFlatfish, "--dof=surge", "--" + flag + "=-1"}),
              "fathom_identify: --" + flag + ": is -1, expected 0 (never) or a number above.\n");
  }
}

// Nothing moves: no model, and no file that looks like one.
TEST(IdentifyTool, AVehicleAtRestEndsWithExitCodeTwoAndNoModel) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteStillLog(folder / "log");
  const Path model = folder / "model.json";
  for (const char* family : {"least_squares", "adaptive", "output_error"}) {
    const ToolRun run =
        RunToolBinary("fathom_identify",
                      {Flag("log", log), std::string("--family=") + family, Flag("model", model)});
    EXPECT_EQ(run.exit_code, 2) << family << ": " << run.out;
    EXPECT_THAT(run.err, HasSubstr("fathom_identify: no usable model: ")) << family;
    EXPECT_FALSE(std::filesystem::exists(model)) << family;
  }
}

// A folder's name may hold a comma; several logs are given one by one or between commas.
TEST(IdentifyTool, TakesLogsOneByOneAndBetweenCommas) {
  const Path folder = EmptyTestFolder();
  const std::string first = WriteSmallLog(folder / "a,b").string();
  const std::string second = WriteSmallLog(folder / "c").string();
  // Its first half: another log.
  const std::string velocity = TextOf(folder / "c" / "velocity.csv");
  WriteTestFile(folder / "c" / "velocity.csv",
                velocity.substr(0, velocity.find('\n', velocity.size() / 2) + 1));
  const ToolRun alone = RunsWell("fathom_identify", {"--log=" + first, "--dof=surge"});
  const ToolRun one_by_one =
      RunsWell("fathom_identify", {"--log=" + first, "--log=" + second, "--dof=surge"});
  EXPECT_NE(one_by_one.out, alone.out);

  std::filesystem::rename(folder / "a,b", folder / "a_b");
  const std::string both = (folder / "a_b").string() + "," + second;
  const ToolRun between_commas = RunToolBinary("fathom_identify", {"--log=" + both, "--dof=surge"});
  // But for the name, which a note and the table of runs show.
  std::string out = between_commas.out;
  ASSERT_NE(out.find("a_b"), std::string::npos) << out;
  for (std::size_t at = 0; (at = out.find("a_b")) != std::string::npos;) out.replace(at, 3, "a,b");
  EXPECT_EQ(out, one_by_one.out);
}

// A speed of 0.7 rad/s that decays by a = 0.2 1/s and b = 0.48 per rad: v = a v0 e / (a + b v0 (1 -
// e)), e = exp(-a t).
std::string DecayCsv() {
  std::string text = "t,v\n";
  const double a = 0.2, b = 0.48, v0 = 0.7;
  for (int i = 0; i < 300; ++i) {
    const double t = 0.05 * i, e = std::exp(-a * t);
    // A ripple in place of noise.
    const double v = a * v0 * e / (a + b * v0 * (1.0 - e)) + 0.002 * std::sin(40.0 * t);
    text += std::to_string(t) + "," + std::to_string(v) + "\n";
  }
  return text;
}

TEST(IdentifyTool, ALogWithoutACommandIsAFreeDecay) {
  const Path folder = EmptyTestFolder();
  const Path csv = WriteTestFile(folder / "decay.csv", DecayCsv());
  const Path json = folder / "decay.json";
  const ToolRun run =
      RunsWell("fathom_identify", {Flag("log", csv), "--dof=yaw", Flag("json", json)});
  EXPECT_THAT(run.out, HasSubstr("yaw: free decay over"));
  const auto decay = JsonOf(json);
  EXPECT_EQ(decay["schema"], "fathom-decay-1");
  EXPECT_NEAR(decay["parameters"]["linear_damping / inertia"]["value"], 0.2, 0.01);
  EXPECT_NEAR(decay["parameters"]["quadratic_damping / inertia"]["value"], 0.48, 0.02);

  const ToolRun model =
      RunToolBinary("fathom_identify", {Flag("log", csv), "--dof=yaw", Flag("model", json)});
  EXPECT_EQ(model.exit_code, 1);
  EXPECT_THAT(model.err, HasSubstr("--model: a model needs the inertia, expected `inertia:"));
}

TEST(IdentifyTool, ScalesAFreeDecayByTheInertiaOfTheVehicleFile) {
  const Path folder = EmptyTestFolder();
  WriteTestFile(folder / "log.yaml", "name: turn\ndof: yaw\nvehicle: rov.yaml\n");
  WriteTestFile(folder / "rov.yaml", "name: rov\nmass: 20\ninertia: {yaw: 5}\n");
  std::string text = DecayCsv();
  text.replace(text.find('v'), 1, "r");
  WriteTestFile(folder / "velocity.csv", text);
  const auto model = IdentifiedModel({Flag("log", folder), "--dof=yaw"});
  EXPECT_EQ(model["provenance"]["family"], "free_decay");
  EXPECT_EQ(model["parameters"]["inertia"]["value"], 5.0);
  EXPECT_NEAR(model["parameters"]["linear_damping"]["value"], 1.0, 0.05);
}

TEST(IdentifyTool, AMotionThatDoesNotDecayEndsWithExitCodeTwo) {
  std::string text = "t,v\n";
  for (int i = 0; i < 200; ++i) {
    text += std::to_string(0.1 * i) + "," + std::to_string(0.01 * i) + "\n";
  }
  const Path csv = WriteTestFile(EmptyTestFolder() / "rise.csv", text);
  const ToolRun run = RunToolBinary("fathom_identify", {Flag("log", csv), "--dof=yaw"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("no usable model: Nothing decays"));
}

// From a log to a model of two DOFs to its prediction.
TEST(IdentifyTool, MakesOneModelOfSeveralDofsThatFathomSimulateRuns) {
  const Path folder = EmptyTestFolder();
  const std::string model = (folder / "model.json").string();
  RunsWell(
      "fathom_identify",
      {"--log=" + kFlatfish, "--dofs=surge,heave", "--structure=coriolis", "--model=" + model});
  EXPECT_EQ(JsonOf(model)["schema"], "fathom-model-2");
  EXPECT_NEAR(JsonOf(model)["parameters"]["inertia.surge"]["value"], 851.05, 0.05 * 851.05);
  const Path scores = folder / "scores.json", out = folder / "prediction.csv";
  const ToolRun simulated = RunsWell("fathom_simulate",
                                     {"--model=" + model,
                                      "--log=" + kFlatfish,
                                      "--horizon=20",
                                      Flag("out", out),
                                      Flag("json", scores)});
  EXPECT_THAT(simulated.out, HasSubstr("surge, training data: velocity MAE"));
  EXPECT_LT(JsonOf(scores)["dofs"]["surge"]["nmae"], 0.2);
  EXPECT_THAT(ReadColumns(out).names, ::testing::ElementsAre("t", "u", "w"));
}

TEST(IdentifyTool, FreesWhatItIsToldBesideAStructure) {
  const std::string model = (EmptyTestFolder() / "model.json").string();
  const auto flags = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"--log=" + kFlatfish, "--model=" + model});
    return more;
  };
  RunsWell("fathom_identify",
           flags({"--dofs=surge,heave",
                  "--structure=diagonal",
                  "--free=linear_damping.surge.heave,inertia.surge"}));
  const auto parameters = JsonOf(model)["parameters"];
  EXPECT_EQ(parameters.size(), 9u);
  EXPECT_GT(parameters["linear_damping.surge.heave"]["std"], 0.0);
  for (const auto& [more, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--dofs=surge,heave", "--free=inertia.surge"},
            "--free: goes with a structure that is given"},
           {{"--dofs=surge,heave", "--structure=diagonal", "--free=inertia.up"},
            "--free: 'inertia.up' is no entry"},
           {{"--dofs=surge,heave", "--structure=diagonal", "--free=inertia.sway"},
            "nothing is there for inertia.sway to be of"},
           {{"--dofs=surge,heave", "--structure=diagonal", "--free=thrust_gain.port"},
            "nothing is there for thrust_gain.port to be of"},
           {{"--dof=surge", "--free=inertia.surge"}, "--free: goes with --dofs"}}) {
    const ToolRun run = RunToolBinary("fathom_identify", flags(more));
    EXPECT_EQ(run.exit_code, 1) << said;
    EXPECT_THAT(run.err, HasSubstr(said));
  }
}

TEST(IdentifyTool, RefusesDofsThatAreNone) {
  const auto error = [](const std::string& flag) {
    return ExpectRefusal("fathom_identify", {"--log=" + kFlatfish, flag});
  };
  EXPECT_THAT(error("--dofs=surge,up"), HasSubstr("--dofs: is 'up'"));
  EXPECT_THAT(error("--dofs=surge,surge"), HasSubstr("names surge twice"));
  EXPECT_THAT(
      ExpectRefusal("fathom_identify", {"--log=" + kFlatfish, "--dofs=surge,yaw", "--dof=surge"}),
      HasSubstr("--dof: goes with a model of one DOF"));
}

// A command with a column that no model of one DOF reads, and one that nothing reads.
TEST(IdentifyTool, SaysOfWhichLogARemarkIs) {
  const Path folder = EmptyTestFolder();
  const Path first = WriteSmallLog(folder / "first"), second = WriteSmallLog(folder / "second");
  WriteTestFile(second / "command.csv", "t,tau_surge,fin_rudder,n\n0,1,0.1,1\n60,2,0.1,1\n");
  const std::vector<std::string> logs = {Flag("log", first), Flag("log", second)};
  const std::string of_second = second.string() + ": command.csv: ";
  std::vector<std::string> alone = logs, coupled = logs;
  alone.push_back("--dof=surge");
  coupled.push_back("--dofs=surge");
  EXPECT_THAT(RunToolBinary("fathom_identify", alone).err,
              AllOf(HasSubstr(of_second + "1 further column is not read: n."),
                    HasSubstr(of_second + "fin_rudder acts in models")));
  EXPECT_THAT(RunToolBinary("fathom_identify", coupled).err,
              AllOf(HasSubstr(of_second + "1 further column is not read: n."),
                    Not(HasSubstr("fin_rudder acts in models"))));
}

}  // namespace
}  // namespace fathom
