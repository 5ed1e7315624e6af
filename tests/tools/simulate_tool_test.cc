// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

const std::string kFlatfish = FATHOM_DATA_DIR "/flatfish";

// From the log to the model file to the prediction, each step a program of its own.
TEST(SimulateTool, PredictsTheLogThatTheModelWasIdentifiedFrom) {
  const Path folder = EmptyTestFolder();
  const std::string model = (folder / "model.json").string();
  const Path out = folder / "prediction.csv";
  const ToolRun identified =
      RunToolBinary("fathom_identify", {"--log=" + kFlatfish, "--dof=surge", "--model=" + model});
  ASSERT_EQ(identified.exit_code, 0) << identified.err;
  const ToolRun run = RunToolBinary(
      "fathom_simulate", {"--model=" + model, "--log=" + kFlatfish, "--out=" + out.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;

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
TEST(SimulateTool, CallsTrainingDataOnlyWhatTheModelWasIdentifiedFrom) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  const Path copy = WriteSmallLog(folder / "copy");
  const Path second = WriteSecondLog(folder / "second");
  const std::string model = (folder / "model.json").string();
  const std::string held_out = "--held_out=40:60";
  const ToolRun identified = RunToolBinary(
      "fathom_identify", {"--log=" + log.string(), "--dof=surge", held_out, "--model=" + model});
  ASSERT_EQ(identified.exit_code, 0) << identified.err;
  for (const Path& scored : {copy, second}) {
    const ToolRun run = RunToolBinary("fathom_simulate",
                                      {"--model=" + model, "--log=" + scored.string(), held_out});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    if (scored == copy) {
      EXPECT_THAT(run.out, HasSubstr("surge, training data: velocity MAE "));
      EXPECT_THAT(run.out, HasSubstr("surge, held out: velocity MAE "));
    } else {
      EXPECT_THAT(run.out, HasSubstr("surge, another log: velocity MAE "));
      EXPECT_THAT(run.out, Not(HasSubstr("held out")));
    }
  }
}

TEST(SimulateTool, WritesTheScoreThatItPrints) {
  const Path folder = EmptyTestFolder();
  const Path json = folder / "score.json";
  const std::string log = WriteSmallLog(folder / "log").string();
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  const ToolRun run = RunToolBinary(
      "fathom_simulate", {"--model=" + model, "--log=" + log, "--json=" + json.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
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

TEST(SimulateTool, SaysWhatAPoorPredictionIsWorth) {
  const Path folder = EmptyTestFolder();
  const Path json = folder / "score.json";
  const std::string log = WriteSmallLog(folder / "log").string();
  const std::string model = WriteTestFile(folder / "model.json", PoorModelJson()).string();
  const ToolRun run = RunToolBinary(
      "fathom_simulate", {"--model=" + model, "--log=" + log, "--json=" + json.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
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

TEST(SimulateTool, SaysOnceWhatTheModelFileSaysOfTheModel) {
  const Path folder = EmptyTestFolder();
  const std::string first = WriteSmallLog(folder / "first").string();
  const std::string second = WriteSecondLog(folder / "second").string();
  const Path json = folder / "scores.json";
  std::string text = SmallModelJson();
  text.replace(text.find("\"caveats\": []"), 13, "\"caveats\": [\"Damping is not known.\"]");
  const std::string model = WriteTestFile(folder / "model.json", text).string();
  const ToolRun run = RunToolBinary(
      "fathom_simulate",
      {"--model=" + model, "--log=" + first, "--log=" + second, "--json=" + json.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string remark = "Said when the model was fitted: Damping is not known.";
  EXPECT_THAT(run.out, EndsWith("\nnote: " + remark + "\n"));
  EXPECT_EQ(run.out.find(remark), run.out.rfind(remark));
  for (const nlohmann::json& score : JsonOf(json)["scores"]) {
    EXPECT_EQ(score["remarks"], nlohmann::json({remark}));
  }
}

TEST(SimulateTool, TheRangeOfAnIdentifiedModelReachesItsFile) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  const Path model = folder / "model.json";
  const ToolRun identified = RunToolBinary(
      "fathom_identify", {"--log=" + log.string(), "--dof=surge", "--model=" + model.string()});
  ASSERT_EQ(identified.exit_code, 0) << identified.err;
  EXPECT_EQ(JsonOf(model)["fit"]["force_range"], nlohmann::json({-20.0, 20.0}));
  const ToolRun run =
      RunToolBinary("fathom_simulate", {"--model=" + model.string(), "--log=" + log.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, ::testing::Not(HasSubstr("note: ")));
}

TEST(SimulateTool, ScoresSeveralLogsOneByOne) {
  const Path folder = EmptyTestFolder();
  const std::string first = WriteSmallLog(folder / "first").string();
  const std::string second = WriteSecondLog(folder / "second").string();
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  const Path json = folder / "scores.json";
  for (const std::vector<std::string>& logs :
       {std::vector<std::string>{"--log=" + first, "--log=" + second},
        std::vector<std::string>{"--log=" + first + "," + second}}) {
    std::vector<std::string> arguments = {"--model=" + model, "--json=" + json.string()};
    arguments.insert(arguments.end(), logs.begin(), logs.end());
    const ToolRun run = RunToolBinary("fathom_simulate", arguments);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr(first + "\nsurge: velocity MAE "));
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

TEST(SimulateTool, RefusesOnePredictionOfSeveralLogs) {
  const Path folder = EmptyTestFolder();
  const std::string first = WriteSmallLog(folder / "first").string();
  const std::string second = WriteSecondLog(folder / "second").string();
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  const ToolRun run = RunToolBinary("fathom_simulate",
                                    {"--model=" + model,
                                     "--log=" + first,
                                     "--log=" + second,
                                     "--out=" + (folder / "out.csv").string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err,
            "fathom_simulate: --out: holds the prediction of one log, expected a single --log with "
            "it.\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "out.csv"));
}

TEST(SimulateTool, TakesTheDofOfTheModelOnly) {
  const Path folder = EmptyTestFolder();
  const std::string log = WriteTestFile(folder / "log.csv", SmallSingleCsv()).string();
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  const ToolRun same =
      RunToolBinary("fathom_simulate", {"--model=" + model, "--log=" + log, "--dof=surge"});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  const ToolRun other =
      RunToolBinary("fathom_simulate", {"--model=" + model, "--log=" + log, "--dof=yaw"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_EQ(other.err,
            "fathom_simulate: --dof: is yaw, but " + model +
                " is a model of surge: expected surge, or no --dof.\n");
}

TEST(SimulateTool, RefusesAModelFileWithAKeyThatNobodyReads) {
  const Path folder = EmptyTestFolder();
  const std::string log = WriteSmallLog(folder / "log").string();
  std::string text = SmallModelJson();
  text.replace(text.find("\"effects\""), 9, "\"effect\"");
  const std::string model = WriteTestFile(folder / "model.json", text).string();
  const ToolRun run = RunToolBinary("fathom_simulate", {"--model=" + model, "--log=" + log});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err,
            "fathom_simulate: " + model +
                ": 'structure.effect' is not known here, expected one of baseline, effects. "
                "Correct or remove it.\n");
}

// m dv/dt + d_L v + b = tau from rest: v = (tau - b) / d_L (1 - exp(-d_L t / m)).
TEST(SimulateTool, MatchesTheClosedFormUnderAConstantForce) {
  const Path folder = EmptyTestFolder();
  std::string model = SmallModelJson();
  model.replace(model.find("\"value\": 30"), 11, "\"value\": 0");
  WriteTestFile(folder / "model.json", model);
  std::string velocity = "t,u\n";
  const auto speed = [](double t) { return 19.0 / 5.0 * (1.0 - std::exp(-5.0 * t / 40.0)); };
  for (int i = 0; i < 200; ++i) velocity += fmt::format("{:.1f},{}\n", 0.1 * i, speed(0.1 * i));
  WriteTestFile(folder / "log" / "log.yaml", "name: push\ndof: surge\n");
  WriteTestFile(folder / "log" / "command.csv", "t,tau_surge\n0,20\n19.9,20\n");
  WriteTestFile(folder / "log" / "velocity.csv", velocity);
  const ToolRun run = RunToolBinary("fathom_simulate",
                                    {"--model=" + (folder / "model.json").string(),
                                     "--log=" + (folder / "log").string(),
                                     "--out=" + (folder / "prediction.csv").string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const CsvColumns predicted = ReadColumns(folder / "prediction.csv");
  ASSERT_EQ(predicted.rows.size(), 200u);
  for (const auto& row : predicted.rows) {
    // Runge-Kutta of order four in steps of h = 0.1 s at a time constant of T = 8 s: an error of
    // (h / T)^4 / 120 t / T of the speed, below 1e-9.
    EXPECT_NEAR(row[1], speed(row[0]), 1e-8) << row[0];
  }
}

TEST(SimulateTool, ReadsAVerdictAsTheExtendedModelInIt) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  WriteTestFile(folder / "model.json", SmallModelJson());
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
  WriteTestFile(folder / "verdict.json", verdict.dump(1));
  for (const std::string name : {"model", "verdict"}) {
    const ToolRun run = RunToolBinary("fathom_simulate",
                                      {"--model=" + (folder / name).string() + ".json",
                                       "--log=" + log.string(),
                                       "--out=" + (folder / name).string() + ".csv"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }
  EXPECT_FALSE(TextOf(folder / "model.csv").empty());
  EXPECT_EQ(TextOf(folder / "model.csv"), TextOf(folder / "verdict.csv"));
}

// The truth of the small log predicts it to its own Euler steps of 1 ms, whose error is about
// 0.0005 s times the acceleration, at most 0.7 m/s^2.
TEST(SimulateTool, TheTruthPredictsTheSmallLog) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  WriteTestFile(folder / "model.json", SmallModelJson());
  const ToolRun run = RunToolBinary(
      "fathom_simulate", {"--model=" + (folder / "model.json").string(), "--log=" + log.string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LT(NumberBehind("MAE ", run.out), 0.0005);
  EXPECT_THAT(run.out, HasSubstr("over 601 samples, 60 s"));
}

// Damping that settles within a microsecond cannot be integrated in steps of the log's rate: no
// prediction, rather than a wrong one.
// Without a motion stream the prediction stands at the command's stamps and starts from rest.
TEST(SimulateTool, SaysThatTheCommandEndsBeforeTheMotion) {
  const Path folder = EmptyTestFolder();
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  const Path log = WriteSmallLog(folder / "log");
  const std::string command = SmallCommandCsv();
  WriteTestFile(log / "command.csv", command.substr(0, command.find("\n20.1,") + 1));
  const ToolRun run =
      RunToolBinary("fathom_simulate", {"--model=" + model, "--log=" + log.string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(
      run.out,
      HasSubstr("note: The command ends 40.0 s before the motion; its last value is held."));
}

TEST(SimulateTool, PredictsACommandAlone) {
  const Path folder = EmptyTestFolder();
  const Path model = WriteTestFile(folder / "model.json", SmallModelJson());
  const Path log = folder / "command_only";
  std::filesystem::create_directories(log);
  WriteTestFile(log / "log.yaml", "name: command_only\ndof: surge\n");
  WriteTestFile(log / "command.csv", "t,tau_surge\n0,10\n0.5,20\n1.5,0\n");
  const Path out = folder / "prediction.csv";
  const ToolRun run = RunToolBinary(
      "fathom_simulate",
      {"--model=" + model.string(), "--log=" + log.string(), "--out=" + out.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const CsvColumns predicted = ReadColumns(out);
  EXPECT_THAT(predicted.Values("t"), ElementsAre(0.0, 0.5, 1.5));
  EXPECT_EQ(predicted.Values("u").front(), 0.0);
  EXPECT_GT(predicted.Values("u").back(), predicted.Values("u")[1]);  // pushed ahead all the time
  EXPECT_THAT(run.out, HasSubstr("predicted from rest"));
}

// The thrust per ampere is unknown: such a model says nothing about a log in newton.
TEST(SimulateTool, SaysHowDetectionsBecomePosesToScoreBy) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  std::filesystem::remove(log / "velocity.csv");
  WriteTestFile(log / "detections.csv",
                "t,tag_id,u0,v0,u1,v1,u2,v2,u3,v3\n"
                "0.1,4,310,251,350,252,351,211,310,211\n"
                "0.2,4,310,251,350,252,351,211,310,211\n");
  const Path model = WriteTestFile(folder / "model.json", SmallModelJson());
  const ToolRun run =
      RunToolBinary("fathom_simulate", {"--model=" + model.string(), "--log=" + log.string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out,
            "surge: predicted from rest. The log has no column 'u' and no pose to score the "
            "prediction. fathom_track makes poses from its detections.csv.\n");
}

TEST(SimulateTool, RefusesAModelWhoseForceHasAnotherUnit) {
  const Path folder = EmptyTestFolder();
  const Path model = folder / "model.json";
  const Path log = folder / "ampere";
  std::filesystem::create_directories(log);
  for (const char* file : {"command.csv", "velocity.csv"}) {
    std::filesystem::copy_file(kFlatfish + "/" + file, log / file);
  }
  WriteTestFile(log / "log.yaml", "name: ampere\ndof: surge\ncommand_unit: A\n");
  const ToolRun identified = RunToolBinary(
      "fathom_identify", {"--log=" + log.string(), "--dof=surge", "--model=" + model.string()});
  ASSERT_EQ(identified.exit_code, 0) << identified.err;
  const ToolRun run =
      RunToolBinary("fathom_simulate", {"--model=" + model.string(), "--log=" + kFlatfish});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err,
              HasSubstr("its commands are in N, but the model was identified from commands "
                        "in A: expected the same unit."));
}

TEST(SimulateTool, AModelThatCannotBeSimulatedEndsWithExitCodeTwoAndNoFile) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  std::string model = SmallModelJson();
  model.replace(model.find("\"value\": 5"), 10, "\"value\": 5e9");
  WriteTestFile(folder / "model.json", model);
  const Path out = folder / "prediction.csv";
  const ToolRun run = RunToolBinary("fathom_simulate",
                                    {"--model=" + (folder / "model.json").string(),
                                     "--log=" + log.string(),
                                     "--out=" + out.string()});
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
  const ToolRun run = RunToolBinary("fathom_synthesize",
                                    {"--vehicle=" + vehicle.string(),
                                     "--experiment=" + experiment.string(),
                                     "--seed=1",
                                     "--effects=" + effects,
                                     "--out=" + log.string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return log;
}

TEST(SimulateTool, SimulatesTheCausesOfAVerdict) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizeSteps(folder, "thruster_lag:time_constant=0.8");
  const Path verdict =
      WriteTestFile(folder / "verdict.json",
                    VerdictJson({{"effect", "thruster_lag"},
                                 {"parameters", {{"time_constant", {{"value", 0.8}}}}}}));
  const Path without = WriteTestFile(folder / "model.json", SmallModelJson());
  const ToolRun with_lag =
      RunToolBinary("fathom_simulate", {"--model=" + verdict.string(), "--log=" + log.string()});
  const ToolRun baseline =
      RunToolBinary("fathom_simulate", {"--model=" + without.string(), "--log=" + log.string()});
  ASSERT_EQ(with_lag.exit_code, 0) << with_lag.err;
  ASSERT_EQ(baseline.exit_code, 0) << baseline.err;
  // The force of a step of h = 0.1 s is its mean: within it the speed is off by up to
  // (40 N / 0.8 s) h^2 / 8 / 40 kg = 1.6e-3 m/s, on which drag acts (about 0.9 1/s) for 0.8 s.
  EXPECT_LT(NumberBehind("MAE ", with_lag.out), 1e-3);
  EXPECT_GT(NumberBehind("MAE ", baseline.out), 0.02);
}

TEST(SimulateTool, LeavesOutWhatBelongsToAnotherRunAndSaysSo) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizeSteps(folder, "sensor_bias:bias=0.2");
  const Path verdict = WriteTestFile(
      folder / "verdict.json",
      VerdictJson({{"effect", "sensor_bias"}, {"parameters", {{"bias", {{"value", 0.2}}}}}}));
  const std::vector<std::string> arguments = {"--model=" + verdict.string(),
                                              "--log=" + log.string()};
  const ToolRun without = RunToolBinary("fathom_simulate", arguments);
  ASSERT_EQ(without.exit_code, 0) << without.err;
  EXPECT_THAT(without.out, HasSubstr("note: left out: sensor_bias."));
  EXPECT_GT(NumberBehind("MAE ", without.out), 0.1);

  auto keeping = arguments;
  keeping.push_back("--keep_run_effects");
  const ToolRun with = RunToolBinary("fathom_simulate", keeping);
  ASSERT_EQ(with.exit_code, 0) << with.err;
  EXPECT_THAT(with.out, ::testing::Not(HasSubstr("left out")));
  EXPECT_LT(NumberBehind("MAE ", with.out), 1e-4);
}

TEST(SimulateTool, RefusesALogThatLacksAPartner) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  const Path verdict =
      WriteTestFile(folder / "verdict.json",
                    VerdictJson({{"effect", "velocity_coupling"},
                                 {"partner", "sway"},
                                 {"parameters", {{"coefficient", {{"value", 3}}}}}}));
  const ToolRun run =
      RunToolBinary("fathom_simulate", {"--model=" + verdict.string(), "--log=" + log.string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err,
              HasSubstr("the model's velocity_coupling(sway) needs the measured sway velocity, "
                        "expected column 'v' in velocity.csv, or a pose.csv."));
}

}  // namespace
}  // namespace fathom
