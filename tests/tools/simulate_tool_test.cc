// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

// A log and the model that it comes of.
class SimulateTool : public ::testing::Test {
 protected:
  const Path folder_ = EmptyTestFolder();
  const Path log_ = WriteSmallLog(folder_ / "log");
  const Path model_ = WriteTestFile(folder_ / "model.json", SmallModelJson());
};

// From the log to the model file to the prediction, each step a program of its own.
TEST_F(SimulateTool, PredictsTheLogThatTheModelWasIdentifiedFrom) {
  const std::string model = (folder_ / "model.json").string();
  const Path out = folder_ / "prediction.csv";
  RunsWell("fathom_identify", {"--log=" + kFlatfish, "--dof=surge", "--model=" + model});
  const ToolRun run =
      RunsWell("fathom_simulate", {"--model=" + model, "--log=" + kFlatfish, Flag("out", out)});

  const CsvColumns predicted = ReadColumns(out);
  const CsvColumns measured = ReadColumns(kFlatfish + "/velocity.csv");
  EXPECT_THAT(predicted.names, ElementsAre("t", "u"));
  ASSERT_EQ(predicted.rows.size(), measured.rows.size());
  EXPECT_EQ(predicted.Values("t"), measured.Values("t"));
  const std::vector<double> u = predicted.Values("u");
  const std::vector<double> u_measured = measured.Values("u");

  const std::vector<double> time = predicted.Values("t");
  for (const bool is_held_out : {false, true}) {
    double sum_of_errors = 0.0, sum_of_speeds = 0.0, num_samples = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      if ((time[i] - time[0] >= 240.0) != is_held_out) continue;  // log.yaml: [240, 300]
      sum_of_errors += std::abs(u[i] - u_measured[i]);
      sum_of_speeds += std::abs(u_measured[i]);
      num_samples += 1.0;
    }
    // Printed with five and four digits behind the point.
    const std::string part = is_held_out ? "surge, held out" : "surge, training data";
    EXPECT_NEAR(NumberBehind("velocity MAE ", run.out, part), sum_of_errors / num_samples, 6e-6);
    EXPECT_NEAR(NumberBehind("velocity NMAE ", run.out, part), sum_of_errors / sum_of_speeds, 6e-5);
    // The log's noise of about 0.01 m/s is 0.008 in the mean; a wrong model misses by more.
    EXPECT_LT(sum_of_errors / num_samples, 0.012);
  }
}

// A copy of the small log with a row more: the same data twice are refused.
Path WriteSecondLog(const Path& folder) {
  WriteSmallLog(folder);
  WriteTestFile(folder / "log.yaml", "name: second\ndof: surge\n");
  WriteTestFile(folder / "velocity.csv", SmallVelocityCsv() + "60.1,0\n");
  return folder;
}

// The copy has another path and the same data; the second log has other data.
TEST_F(SimulateTool, CallsTrainingDataOnlyWhatTheModelWasIdentifiedFrom) {
  const Path copy = WriteSmallLog(folder_ / "copy");
  const Path second = WriteSecondLog(folder_ / "second");
  const std::string model = (folder_ / "model.json").string();
  const std::string held_out = "--held_out=40:60";
  RunsWell("fathom_identify", {Flag("log", log_), "--dof=surge", held_out, "--model=" + model});
  for (const Path& scored : {copy, second}) {
    const ToolRun run =
        RunsWell("fathom_simulate", {"--model=" + model, Flag("log", scored), held_out});
    if (scored == copy) {
      EXPECT_THAT(run.out, HasSubstr("surge, training data: velocity MAE "));
      EXPECT_THAT(run.out, HasSubstr("surge, held out: velocity MAE "));
    } else {
      EXPECT_THAT(run.out, HasSubstr("surge, another log: velocity MAE "));
      EXPECT_THAT(run.out, Not(HasSubstr("held out")));
    }
  }
}

TEST_F(SimulateTool, WritesTheScoreThatItPrints) {
  const Path json = folder_ / "score.json";
  const ToolRun run =
      RunsWell("fathom_simulate", {Flag("model", model_), Flag("log", log_), Flag("json", json)});
  const nlohmann::json score = JsonOf(json);
  EXPECT_EQ(score["schema"], "fathom-score-1");
  EXPECT_EQ(score["dof"], "surge");
  EXPECT_EQ(score["n"], 601);
  EXPECT_NEAR(score["mae"], NumberBehind("MAE ", run.out), 6e-6);
  EXPECT_NEAR(score["nmae"], NumberBehind("NMAE ", run.out), 6e-5);
}

// The truth but for ten times the inertia, written as if it had been fitted to slower runs.
std::string PoorModelJson() {
  std::string model = SmallModelJson();
  const auto exchange = [&](const std::string& from, const std::string& to) {
    model.replace(model.find(from), from.size(), to);
  };
  exchange("\"value\": 40", "\"value\": 400");
  exchange("\"nmae\": 0.01",
           "\"nmae\": 0.41, \"speed_range\": [-0.1, 0.1], \"force_range\": [-8, 8]");
  return model;
}

TEST_F(SimulateTool, SaysWhatAPoorPredictionIsWorth) {
  const Path json = folder_ / "score.json";
  const std::string model = WriteTestFile(folder_ / "model.json", PoorModelJson()).string();
  const ToolRun run =
      RunsWell("fathom_simulate", {"--model=" + model, Flag("log", log_), Flag("json", json)});
  const std::vector<std::string> beginnings = {"The model is a poor fit: its NMAE on the data that",
                                               "The prediction of this log is poor: its NMAE is",
                                               "The speed of this log, ",
                                               "The force of this log, -20 to 20 N, leaves what"};
  const nlohmann::json remarks = JsonOf(json)["remarks"];
  ASSERT_EQ(remarks.size(), beginnings.size());
  for (std::size_t i = 0; i < beginnings.size(); ++i) {
    EXPECT_THAT(run.out, HasSubstr("note: " + beginnings[i]));
    EXPECT_THAT(remarks[i].get<std::string>(), ::testing::StartsWith(beginnings[i]));
  }
}

TEST_F(SimulateTool, SaysOnceWhatTheModelFileSaysOfTheModel) {
  const std::string second = WriteSecondLog(folder_ / "second").string();
  const Path json = folder_ / "scores.json";
  std::string text = SmallModelJson();
  text.replace(text.find("\"caveats\": []"), 13, "\"caveats\": [\"Damping is not known.\"]");
  const std::string model = WriteTestFile(folder_ / "model.json", text).string();
  const ToolRun run =
      RunsWell("fathom_simulate",
               {"--model=" + model, Flag("log", log_), "--log=" + second, Flag("json", json)});
  const std::string remark = "Said when the model was fitted: Damping is not known.";
  EXPECT_THAT(run.out, EndsWith("\nnote: " + remark + "\n"));
  EXPECT_EQ(run.out.find(remark), run.out.rfind(remark));
  for (const nlohmann::json& score : JsonOf(json)["scores"]) {
    EXPECT_EQ(score["remarks"], nlohmann::json({remark}));
  }
}

TEST_F(SimulateTool, TheRangeOfAnIdentifiedModelReachesItsFile) {
  const Path model = folder_ / "model.json";
  RunsWell("fathom_identify", {Flag("log", log_), "--dof=surge", Flag("model", model)});
  EXPECT_EQ(JsonOf(model)["fit"]["force_range"], nlohmann::json({-20.0, 20.0}));
  const ToolRun run = RunsWell("fathom_simulate", {Flag("model", model), Flag("log", log_)});
  EXPECT_THAT(run.out, ::testing::Not(HasSubstr("note: ")));
}

TEST_F(SimulateTool, ScoresSeveralLogsOneByOne) {
  const std::string second = WriteSecondLog(folder_ / "second").string();
  const Path json = folder_ / "scores.json";
  for (const std::vector<std::string>& logs :
       {std::vector<std::string>{Flag("log", log_), "--log=" + second},
        std::vector<std::string>{Flag("log", log_.string() + "," + second)}}) {
    std::vector<std::string> arguments = {Flag("model", model_), Flag("json", json)};
    arguments.insert(arguments.end(), logs.begin(), logs.end());
    const ToolRun run = RunsWell("fathom_simulate", arguments);
    EXPECT_THAT(run.out, HasSubstr(log_.string() + "\nsurge: velocity MAE "));
    EXPECT_THAT(run.out, HasSubstr(second + "\nsurge: velocity MAE "));
    const nlohmann::json file = JsonOf(json);
    EXPECT_EQ(file["schema"], "fathom-scores-1");
    ASSERT_EQ(file["scores"].size(), 2u);
    EXPECT_EQ(file["scores"][0]["log"], "small");
    EXPECT_EQ(file["scores"][0]["n"], 601);
    EXPECT_EQ(file["scores"][1]["log"], "second");
    EXPECT_EQ(file["scores"][1]["n"], 602);
  }
}

TEST_F(SimulateTool, RefusesOnePredictionOfSeveralLogs) {
  const std::string second = WriteSecondLog(folder_ / "second").string();
  EXPECT_EQ(ExpectRefusal("fathom_simulate",
                          {Flag("model", model_),
                           Flag("log", log_),
                           "--log=" + second,
                           Flag("out", folder_ / "out.csv")}),
            "fathom_simulate: --out: holds the prediction of one log, expected a single --log with "
            "it.\n");
}

TEST_F(SimulateTool, TakesTheDofOfTheModelOnly) {
  const std::string log = WriteTestFile(folder_ / "log.csv", SmallSingleCsv()).string();
  RunsWell("fathom_simulate", {Flag("model", model_), "--log=" + log, "--dof=surge"});
  EXPECT_EQ(ExpectRefusal("fathom_simulate", {Flag("model", model_), "--log=" + log, "--dof=yaw"}),
            "fathom_simulate: --dof: is yaw, but " + model_.string() +
                " is a model of surge: expected surge, or no --dof.\n");
}

// m dv/dt + d_L v + b = tau from rest: v = (tau - b) / d_L (1 - exp(-d_L t / m)).
TEST_F(SimulateTool, MatchesTheClosedFormUnderAConstantForce) {
  std::string model = SmallModelJson();
  model.replace(model.find("\"value\": 30"), 11, "\"value\": 0");
  WriteTestFile(folder_ / "model.json", model);
  std::string velocity = "t,u\n";
  const auto speed = [](double t) { return 19.0 / 5.0 * (1.0 - std::exp(-5.0 * t / 40.0)); };
  for (int i = 0; i < 200; ++i) velocity += fmt::format("{:.1f},{}\n", 0.1 * i, speed(0.1 * i));
  WriteTestFile(folder_ / "log" / "log.yaml", "name: push\ndof: surge\n");
  WriteTestFile(folder_ / "log" / "command.csv", "t,tau_surge\n0,20\n19.9,20\n");
  WriteTestFile(folder_ / "log" / "velocity.csv", velocity);
  RunsWell("fathom_simulate",
           {Flag("model", folder_ / "model.json"),
            Flag("log", folder_ / "log"),
            Flag("out", folder_ / "prediction.csv")});
  const CsvColumns predicted = ReadColumns(folder_ / "prediction.csv");
  ASSERT_EQ(predicted.rows.size(), 200u);
  for (const auto& row : predicted.rows) {
    // Runge-Kutta of order four in steps of h = 0.1 s at a time constant of T = 8 s: an error of
    // (h / T)^4 / 120 t / T of the speed, below 1e-9.
    EXPECT_NEAR(row[1], speed(row[0]), 1e-8) << row[0];
  }
}

TEST_F(SimulateTool, ReadsAVerdictAsTheExtendedModelInIt) {
  const auto model = nlohmann::json::parse(SmallModelJson());
  auto wrong = model["parameters"];
  wrong["inertia"]["value"] = 400.0;
  const nlohmann::json verdict = {
      {"schema", "fathom-verdict-1"},
      {"log", "small"},
      {"dof", "surge"},
      {"verdict", "consistent"},
      {"baseline", {{"parameters", wrong}, {"mae", 0.1}, {"nmae", 0.2}, {"heldout_nmae", nullptr}}},
      {"causes", nlohmann::json::array()},
      {"extended",
       {{"parameters", model["parameters"]},
        {"mae", 0.001},
        {"nmae", 0.01},
        {"heldout_nmae", nullptr}}},
      {"candidates", nlohmann::json::array()}};
  WriteTestFile(folder_ / "verdict.json", verdict.dump(1));
  for (const std::string name : {"model", "verdict"}) {
    RunsWell("fathom_simulate",
             {"--model=" + (folder_ / name).string() + ".json",
              Flag("log", log_),
              "--out=" + (folder_ / name).string() + ".csv"});
  }
  EXPECT_FALSE(TextOf(folder_ / "model.csv").empty());
  EXPECT_EQ(TextOf(folder_ / "model.csv"), TextOf(folder_ / "verdict.csv"));
}

// The truth of the small log predicts it to its own Euler steps of 1 ms, whose error is about
// 0.0005 s times the acceleration, at most 0.7 m/s^2.
TEST_F(SimulateTool, TheTruthPredictsTheSmallLog) {
  const ToolRun run = RunsWell("fathom_simulate", {Flag("model", model_), Flag("log", log_)});
  EXPECT_LT(NumberBehind("MAE ", run.out), 0.0005);
  EXPECT_THAT(run.out, HasSubstr("over 601 samples, 60 s"));
}

TEST_F(SimulateTool, SaysThatTheCommandEndsBeforeTheMotion) {
  const std::string command = SmallCommandCsv();
  WriteTestFile(log_ / "command.csv", command.substr(0, command.find("\n20.1,") + 1));
  const ToolRun run = RunsWell("fathom_simulate", {Flag("model", model_), Flag("log", log_)});
  EXPECT_THAT(
      run.out,
      HasSubstr("note: The command ends 40.0 s before the motion; its last value is held."));
}

// Without a motion stream the prediction stands at the command's stamps and starts from rest.
TEST_F(SimulateTool, PredictsACommandAlone) {
  const Path log = folder_ / "command_only";
  std::filesystem::create_directories(log);
  WriteTestFile(log / "log.yaml", "name: command_only\ndof: surge\n");
  WriteTestFile(log / "command.csv", "t,tau_surge\n0,10\n0.5,20\n1.5,0\n");
  const Path out = folder_ / "prediction.csv";
  const ToolRun run =
      RunsWell("fathom_simulate", {Flag("model", model_), Flag("log", log), Flag("out", out)});
  const CsvColumns predicted = ReadColumns(out);
  EXPECT_THAT(predicted.Values("t"), ElementsAre(0.0, 0.5, 1.5));
  EXPECT_EQ(predicted.Values("u").front(), 0.0);
  EXPECT_GT(predicted.Values("u").back(), predicted.Values("u")[1]);  // pushed ahead all the time
  EXPECT_THAT(run.out, HasSubstr("predicted from rest"));
}

TEST_F(SimulateTool, SaysHowDetectionsBecomePosesToScoreBy) {
  std::filesystem::remove(log_ / "velocity.csv");
  WriteTestFile(log_ / "detections.csv",
                "t,tag_id,u0,v0,u1,v1,u2,v2,u3,v3\n"
                "0.1,4,310,251,350,252,351,211,310,211\n"
                "0.2,4,310,251,350,252,351,211,310,211\n");
  const ToolRun run = RunsWell("fathom_simulate", {Flag("model", model_), Flag("log", log_)});
  EXPECT_EQ(run.out,
            "surge: predicted from rest. The log has no column 'u' and no pose to score the "
            "prediction. fathom_track makes poses from its detections.csv.\n");
}

// The thrust per ampere is unknown: such a model says nothing about a log in newton.
TEST_F(SimulateTool, RefusesAModelWhoseForceHasAnotherUnit) {
  const Path model = folder_ / "model.json";
  const Path log = folder_ / "ampere";
  std::filesystem::create_directories(log);
  for (const char* file : {"command.csv", "velocity.csv"}) {
    std::filesystem::copy_file(kFlatfish + "/" + file, log / file);
  }
  WriteTestFile(log / "log.yaml", "name: ampere\ndof: surge\ncommand_unit: A\n");
  RunsWell("fathom_identify", {Flag("log", log), "--dof=surge", Flag("model", model)});
  EXPECT_THAT(ExpectRefusal("fathom_simulate", {Flag("model", model), "--log=" + kFlatfish}),
              HasSubstr("its commands are in N, but the model was identified from commands "
                        "in A: expected the same unit."));
}

// Damping that settles within a microsecond cannot be integrated in steps of the log's rate: no
// prediction, rather than a wrong one.
TEST_F(SimulateTool, AModelThatCannotBeSimulatedEndsWithExitCodeTwoAndNoFile) {
  std::string model = SmallModelJson();
  model.replace(model.find("\"value\": 5"), 10, "\"value\": 5e9");
  WriteTestFile(folder_ / "model.json", model);
  const Path out = folder_ / "prediction.csv";
  const ToolRun run =
      RunToolBinary("fathom_simulate",
                    {Flag("model", folder_ / "model.json"), Flag("log", log_), Flag("out", out)});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("fathom_simulate: the simulation of "));
  EXPECT_FALSE(std::filesystem::exists(out));
}

// A verdict whose baseline is the vehicle's truth and whose one cause is `cause`.
std::string VerdictJson(const nlohmann::json& cause) {
  const auto number = [](double value) { return nlohmann::json{{"value", value}}; };
  const nlohmann::json verdict = {{"schema", "fathom-verdict-1"},
                                  {"dof", "surge"},
                                  {"causes", {cause}},
                                  {"extended",
                                   {{"parameters",
                                     {{"inertia", number(40)},
                                      {"quadratic_damping", number(30)},
                                      {"linear_damping", number(5)},
                                      {"buoyancy", number(1)}}}}}};
  return verdict.dump(1);
}

// Steps in surge, measured without noise, with `effects` hidden by the other simulation.
Path SynthesizeSteps(const Path& folder, const std::string& effects) {
  const Path vehicle = WriteTestFile(folder / "vehicle.yaml", SmallVehicleYaml());
  const Path experiment = WriteTestFile(folder / "steps.yaml",
                                        "name: steps\nstart_time: 50\nduration: 60\n"
                                        "command_rate: 10\n"
                                        "surge: {control: open_loop, input: {kind: steps, "
                                        "levels: [20, -8, 8, -20], hold: 6}}\n"
                                        "velocity: {rate: 10}\n");
  const Path log = folder / ("log_" + effects.substr(0, effects.find(':')));
  RunsWell("fathom_synthesize",
           {Flag("vehicle", vehicle),
            Flag("experiment", experiment),
            "--seed=1",
            "--effects=" + effects,
            Flag("out", log)});
  return log;
}

TEST_F(SimulateTool, SimulatesTheCausesOfAVerdict) {
  const Path log = SynthesizeSteps(folder_, "thruster_lag:time_constant=0.8");
  const Path verdict =
      WriteTestFile(folder_ / "verdict.json",
                    VerdictJson({{"effect", "thruster_lag"},
                                 {"parameters", {{"time_constant", {{"value", 0.8}}}}}}));
  const ToolRun with_lag =
      RunToolBinary("fathom_simulate", {Flag("model", verdict), Flag("log", log)});
  const ToolRun baseline =
      RunToolBinary("fathom_simulate", {Flag("model", model_), Flag("log", log)});
  ASSERT_EQ(with_lag.exit_code, 0) << with_lag.err;
  ASSERT_EQ(baseline.exit_code, 0) << baseline.err;
  // The force of a step of h = 0.1 s is its mean: within it the speed is off by up to
  // (40 N / 0.8 s) h^2 / 8 / 40 kg = 1.6e-3 m/s, on which drag acts (about 0.9 1/s) for 0.8 s.
  EXPECT_LT(NumberBehind("MAE ", with_lag.out), 1e-3);
  EXPECT_GT(NumberBehind("MAE ", baseline.out), 0.02);
}

TEST_F(SimulateTool, LeavesOutWhatBelongsToAnotherRunAndSaysSo) {
  const Path log = SynthesizeSteps(folder_, "sensor_bias:bias=0.2");
  const Path verdict = WriteTestFile(
      folder_ / "verdict.json",
      VerdictJson({{"effect", "sensor_bias"}, {"parameters", {{"bias", {{"value", 0.2}}}}}}));
  const std::vector<std::string> arguments = {Flag("model", verdict), Flag("log", log)};
  const ToolRun without = RunsWell("fathom_simulate", arguments);
  EXPECT_THAT(without.out, HasSubstr("note: left out: sensor_bias."));
  EXPECT_GT(NumberBehind("MAE ", without.out), 0.1);

  auto keeping = arguments;
  keeping.push_back("--keep_run_effects");
  const ToolRun with = RunsWell("fathom_simulate", keeping);
  EXPECT_THAT(with.out, ::testing::Not(HasSubstr("left out")));
  EXPECT_LT(NumberBehind("MAE ", with.out), 1e-4);
}

TEST_F(SimulateTool, RefusesALogThatLacksAPartner) {
  const Path verdict =
      WriteTestFile(folder_ / "verdict.json",
                    VerdictJson({{"effect", "velocity_coupling"},
                                 {"partner", "sway"},
                                 {"parameters", {{"coefficient", {{"value", 3}}}}}}));
  EXPECT_THAT(ExpectRefusal("fathom_simulate", {Flag("model", verdict), Flag("log", log_)}),
              HasSubstr("the model's velocity_coupling(sway) needs the measured sway velocity, "
                        "expected column 'v' in velocity.csv, or a pose.csv."));
}

}  // namespace
}  // namespace fathom
