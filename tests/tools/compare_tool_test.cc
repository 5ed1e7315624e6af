// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bundled_data.h"
#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include "turn_without_command.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Path = std::filesystem::path;

// One run over the bundled log with every output, in the running test's folder.
struct FlatfishRun {
  explicit FlatfishRun(const Path& folder) {
    run = RunToolBinary("fathom_compare",
                        {"--log=" + kFlatfish,
                         "--dofs=surge,heave,yaw",
                         Flag("json", folder / "rows.json"),
                         Flag("report", folder / "page.html")});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    json = TextOf(folder / "rows.json");
    page = TextOf(folder / "page.html");
  }
  ToolRun run;
  std::string json, page;
};

TEST(CompareTool, WritesARowForEachFamilyAndDof) {
  const FlatfishRun flatfish(EmptyTestFolder());
  const auto json = nlohmann::json::parse(flatfish.json);
  EXPECT_EQ(json["schema"], "fathom-comparison-1");
  std::vector<std::string> rows;
  for (const auto& row : json["rows"]) {
    rows.push_back(row["dof"].get<std::string>() + " " + row["family"].get<std::string>());
    EXPECT_EQ(row["usable"], true) << rows.back() << ": " << row["message"];
    EXPECT_EQ(row["source"], "pose_estimator");
  }
  EXPECT_THAT(rows,
              ElementsAre("surge least_squares",
                          "surge adaptive",
                          "surge output_error",
                          "heave least_squares",
                          "heave adaptive",
                          "heave output_error",
                          "yaw least_squares",
                          "yaw adaptive",
                          "yaw output_error"));
}

// The same vehicle driven in the same way, another run and measured without noise: what remains is
// the model's own error. (On the log's own noisy minute chance decides, docs/comparison.md.)
TEST(CompareTool, OutputErrorPredictsANoiselessRunBest) {
  const Path folder = EmptyTestFolder();
  std::string experiment;
  std::istringstream lines(TextOf(FATHOM_DATA_DIR "/experiments/table1.yaml"));
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" noise:") == std::string::npos) experiment += line + "\n";
  }
  WriteTestFile(folder / "noiseless.yaml", experiment);
  const std::string log = Flag("log", folder / "log");
  RunsWell("fathom_synthesize",
           {"--vehicle=" FATHOM_DATA_DIR "/vehicles/flatfish.yaml",
            Flag("experiment", folder / "noiseless.yaml"),
            "--seed=5",
            Flag("out", folder / "log")});
  for (const std::string dof : {"surge", "heave", "yaw"}) {
    std::map<std::string, double> mae;
    for (const std::string family : {"least_squares", "adaptive", "output_error"}) {
      const std::string model = Flag("model", folder / (dof + family + ".json"));
      RunToolBinary("fathom_identify",
                    {"--log=" + kFlatfish, "--dof=" + dof, "--family=" + family, model});
      const ToolRun run = RunsWell("fathom_simulate", {model, log});
      mae[family] = NumberBehind("MAE ", run.out);
    }
    EXPECT_LT(mae["output_error"], mae["least_squares"]) << dof;
    EXPECT_LT(mae["output_error"], mae["adaptive"]) << dof;
    EXPECT_LT(mae["output_error"], 0.001) << dof;  // a tenth of the noise it was fitted through
  }
}

TEST(CompareTool, WritesAPageThatShowsEachDofAndNeedsNoNetwork) {
  const FlatfishRun flatfish(EmptyTestFolder());
  for (const char* heading : {"Surge", "Heave", "Yaw"}) {
    EXPECT_THAT(flatfish.page, HasSubstr(heading));
  }
  EXPECT_THAT(flatfish.page, Not(HasSubstr("<script src=")));
  EXPECT_THAT(flatfish.page, Not(HasSubstr("<link")));
  EXPECT_THAT(flatfish.run.out, HasSubstr("held-out NMAE"));
}

// The family of the row that is marked with * for its DOF, as --json has it.
std::string MarkedFamily(const std::string& dof, const std::string& out) {
  const std::size_t at = out.find("* " + dof);
  const std::string row = at == std::string::npos ? "" : out.substr(at, out.find('\n', at) - at);
  for (const auto& [title, family] :
       std::vector<std::pair<std::string, std::string>>{{"Least squares", "least_squares"},
                                                        {"Adaptive", "adaptive"},
                                                        {"Output error", "output_error"}}) {
    if (row.find(title) != std::string::npos) return family;
  }
  return "";
}

// The adaptive law has a quadratic damping of 176 +- 29, and nearly the best score.
TEST(CompareTool, RecommendsAModelWhoseIntervalsHoldTheTruth) {
  const std::map<std::string, double> truth = {// data/vehicles/flatfish.yaml
                                               {"inertia", 851.05},
                                               {"quadratic_damping", 8.62},
                                               {"linear_damping", 39.57},
                                               {"buoyancy", -0.81}};
  const FlatfishRun flatfish(EmptyTestFolder());
  const std::string family = MarkedFamily("surge", flatfish.run.out);
  const auto comparison = nlohmann::json::parse(flatfish.json);
  int num_held = 0;
  for (const auto& row : comparison["rows"]) {
    if (row["dof"] != "surge" || row["family"] != family) continue;
    EXPECT_TRUE(row["usable"].get<bool>());
    for (const auto& [name, value] : truth) {
      const auto& parameter = row["parameters"][name];
      EXPECT_NEAR(parameter["value"].get<double>(), value, 1.96 * parameter["std"].get<double>())
          << name << " of " << family;
      ++num_held;
    }
  }
  EXPECT_EQ(num_held, 4);
}

// In yaw, 0.1330 and 0.1330 on a last minute of noise.
TEST(CompareTool, CallsAsGoodWhatIsBetterByChance) {
  const FlatfishRun flatfish(EmptyTestFolder());
  const std::string header = HeaderOf(flatfish.page);
  const std::size_t yaw = header.find("Yaw: ");
  ASSERT_NE(yaw, std::string::npos) << header;
  EXPECT_THAT(header.substr(yaw),
              AllOf(StartsWith("Yaw: take Output error, velocity.csv."),
                    HasSubstr("As good within chance: Least squares, velocity.csv")));
}

TEST(CompareTool, SaysInTheLegendThatTheScoreIsOfHeldOutData) {
  const FlatfishRun flatfish(EmptyTestFolder());
  EXPECT_NE(flatfish.page.find("\"held-out velocity NMAE 0.062\""), std::string::npos);
  EXPECT_EQ(flatfish.page.find("\"velocity NMAE 0."), std::string::npos);
}

TEST(CompareTool, TheSameLogGivesTheSameBytes) {
  // A page says when it was made, and by which command.
  setenv("SOURCE_DATE_EPOCH", "1500000000", 1);
  const Path folder = EmptyTestFolder();
  const FlatfishRun first(folder);
  const FlatfishRun second(folder);
  unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_THAT(first.page, HasSubstr("2017-07-14"));
  EXPECT_FALSE(first.json.empty());
  EXPECT_EQ(first.json, second.json);
  EXPECT_EQ(first.page, second.page);
  EXPECT_EQ(first.run.out, second.run.out);
}

TEST(CompareTool, TakesTheFamiliesAndDofsItIsAskedFor) {
  const Path json = EmptyTestFolder() / "rows.json";
  RunsWell(
      "fathom_compare",
      {"--log=" + kFlatfish, "--dofs=yaw", "--families=adaptive,output_error", Flag("json", json)});
  std::vector<std::string> families;
  const auto comparison = JsonOf(json);
  for (const auto& row : comparison["rows"]) families.push_back(row["family"]);
  EXPECT_THAT(families, ElementsAre("adaptive", "output_error"));
}

TEST(CompareTool, RefusesWhatIsNamedTwice) {
  for (const auto& [flag, name] : std::vector<std::pair<std::string, std::string>>{
           {"dofs", "surge"}, {"families", "adaptive"}, {"sources", "pose_estimator"}}) {
    EXPECT_EQ(ExpectRefusal("fathom_compare",
                            {"--log=" + kFlatfish, "--" + flag + "=" + name + "," + name}),
              "fathom_compare: --" + flag + ": names " + name + " twice, expected each once.\n");
  }
}

TEST(CompareTool, WritesItsFigures) {
  const Path folder = EmptyTestFolder() / "figures";
  RunsWell("fathom_compare", {"--log=" + kFlatfish, "--dofs=heave", Flag("figures", folder)});
  EXPECT_THAT(TextOf(folder / "heave_response.svg"), HasSubstr("<svg"));
  EXPECT_THAT(TextOf(folder / "heave_parameters.svg"), HasSubstr("<svg"));
  EXPECT_EQ(TextOf(folder / "heave_response.png").substr(0, 4), "\x89PNG");
  EXPECT_EQ(TextOf(folder / "heave_parameters.png").substr(0, 4), "\x89PNG");
}

TEST(CompareTool, AVehicleAtRestEndsWithExitCodeTwoAndSaysWhy) {
  const Path folder = EmptyTestFolder();
  std::string command = "t,tau_surge\n", velocity = "t,u\n";
  for (int i = 0; i < 300; ++i) {
    command += std::to_string(0.1 * i) + ",0\n";
    velocity += std::to_string(0.1 * i) + ",0\n";
  }
  WriteTestFile(folder / "log" / "log.yaml", "name: rest\ndof: surge\n");
  WriteTestFile(folder / "log" / "command.csv", command);
  WriteTestFile(folder / "log" / "velocity.csv", velocity);
  const Path json = folder / "rows.json";
  const ToolRun run =
      RunToolBinary("fathom_compare", {Flag("log", folder / "log"), Flag("json", json)});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  ASSERT_TRUE(std::filesystem::exists(json));
  const nlohmann::json rows = JsonOf(json)["rows"];
  EXPECT_EQ(rows.size(), 3u);
  for (const auto& row : rows) {
    EXPECT_EQ(row["usable"], false) << row["family"];
    EXPECT_NE(row["message"], "") << row["family"];
    EXPECT_TRUE(row["heldout_nmae"].is_null()) << row["family"];
  }
}

TEST(CompareTool, TellsTheRatiosOfAFreeDecay) {
  const Path folder = EmptyTestFolder();
  const Path turn = TurnWithoutCommand(folder, true);
  const ToolRun run = RunsWell("fathom_compare",
                               {Flag("log", turn),
                                "--dofs=yaw",
                                Flag("json", folder / "decay.json"),
                                Flag("report", folder / "page.html")});
  EXPECT_THAT(run.out, StartsWith("Nothing drives yaw"));
  const auto decay = nlohmann::json::parse(TextOf(folder / "decay.json"));
  EXPECT_NEAR(decay["parameters"]["linear_damping / inertia"]["value"], 0.2, 0.01);
  EXPECT_THAT(TextOf(folder / "page.html"), HasSubstr("free decay of yaw"));
}

TEST(CompareTool, EndsWithExitCodeTwoWhereNothingDrivesAndNothingDecays) {
  const Path turn = TurnWithoutCommand(EmptyTestFolder(), false);
  const ToolRun run = RunToolBinary("fathom_compare", {Flag("log", turn), "--dofs=yaw"});
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_THAT(run.err, HasSubstr("nothing to compare"));
}

}  // namespace
}  // namespace fathom
