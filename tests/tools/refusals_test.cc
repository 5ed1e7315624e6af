// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Every tool refuses every damaged input with exit code 1, the message that docs/file_formats.md
// promises, nothing on stdout and nothing written.

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
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

const TwoColumnCsv kVelocity = {"velocity.csv", "u", "t and at least one of u, v, w, p, q, r"};
const TwoColumnCsv kCommand = {
    "command.csv",
    "tau_surge",
    "t and at least one of tau_surge, tau_sway, tau_heave, tau_roll, tau_pitch, tau_yaw, "
    "thruster_1, thruster_2, ..., fin_<name>, shaft_<name>"};

// A good log, model and vehicle in a folder of the running test.
struct Inputs {
  Path folder = EmptyTestFolder();
  Path log = WriteSmallLog(folder / "log");
  Path model = WriteTestFile(folder / "model.json", SmallModelJson());
};

// What a user would type, with every output flag given.
std::vector<std::string> ArgumentsOf(const std::string& tool,
                                     const Path& folder,
                                     const std::string& log) {
  const std::string out = (folder / "out").string();
  if (tool == "fathom_identify") {
    return {"--log=" + log, "--dof=surge", "--model=" + out + "/model.json"};
  }
  if (tool == "fathom_compare") {
    return {"--log=" + log,
            "--json=" + out + "/rows.json",
            "--report=" + out + "/page.html",
            "--figures=" + out + "/figures"};
  }
  if (tool == "fathom_diagnose") {
    return {"--log=" + log,
            "--dof=surge",
            "--verdict=" + out + "/verdict.json",
            "--report=" + out + "/page.html"};
  }
  return {"--log=" + log, Flag("model", folder / "model.json"), "--out=" + out + "/prediction.csv"};
}

class LogTools : public ::testing::TestWithParam<std::string> {
 protected:
  // What the tool says of the log as it is now, behind its own name.
  std::string RefusalOf(const Inputs& inputs) const {
    const std::string said = ExpectRefusal(
        GetParam(), ArgumentsOf(GetParam(), inputs.folder, inputs.log.string()), inputs.folder);
    EXPECT_THAT(said, StartsWith(GetParam() + ": "));
    return said.substr(std::min(said.size(), GetParam().size() + 2));
  }
};

// Without it the refusals below could come from anything.
TEST_P(LogTools, AcceptsTheUndamagedLog) {
  const Inputs inputs;
  const ToolRun run =
      RunsWell(GetParam(), ArgumentsOf(GetParam(), inputs.folder, inputs.log.string()));
  EXPECT_THAT(run.out, HasSubstr("surge"));
  EXPECT_TRUE(std::filesystem::exists(inputs.folder / "out"));
}

TEST_P(LogTools, RefusesAMissingLogFlag) {
  const Inputs inputs;
  auto arguments = ArgumentsOf(GetParam(), inputs.folder, "");
  arguments.erase(arguments.begin());
  EXPECT_EQ(ExpectRefusal(GetParam(), arguments, inputs.folder),
            GetParam() + ": --log: is missing, expected a log folder or a CSV file.\n");
}

TEST_P(LogTools, RefusesALogThatIsNotThere) {
  const Inputs inputs;
  const std::string log = (inputs.folder / "lgo").string();
  EXPECT_EQ(
      ExpectRefusal(GetParam(), ArgumentsOf(GetParam(), inputs.folder, log), inputs.folder),
      GetParam() + ": " + log + ": there is no such log folder or CSV file. Check the path.\n");
}

TEST_P(LogTools, RefusesAnUnknownFlag) {
  const Inputs inputs;
  auto arguments = ArgumentsOf(GetParam(), inputs.folder, inputs.log.string());
  arguments.push_back("--colour=red");
  EXPECT_EQ(ExpectRefusal(GetParam(), arguments, inputs.folder),
            GetParam() + ": --colour: there is no such flag. See " + GetParam() + " --help.\n");
}

// The tools for one DOF have --dof, those for several --dofs, and two have both.
TEST_P(LogTools, SuggestsDofForDofsAndTheReverse) {
  if (GetParam() == "fathom_identify" || GetParam() == "fathom_diagnose") return;
  const Inputs inputs;
  const bool takes_several = GetParam() == "fathom_compare";
  const std::string wrong = takes_several ? "--dof" : "--dofs";
  const std::string right = takes_several ? "--dofs" : "--dof";
  const std::string log = Flag("log", inputs.log);
  for (const std::vector<std::string>& given :
       {std::vector<std::string>{log, wrong + "=surge"}, {log, wrong, "surge"}}) {
    EXPECT_EQ(ExpectRefusal(GetParam(), given, inputs.folder),
              GetParam() + ": " + wrong + ": there is no such flag, did you mean " + right +
                  "? See " + GetParam() + " --help.\n");
  }
}

TEST_P(LogTools, RefusesALogWithoutMotion) {
  const Inputs inputs;
  std::filesystem::remove(inputs.log / "velocity.csv");
  const auto arguments = ArgumentsOf(GetParam(), inputs.folder, inputs.log.string());
  if (GetParam() == "fathom_simulate") {  // it predicts, and needs no motion
    RunsWell(GetParam(), arguments);
    return;
  }
  EXPECT_THAT(ExpectRefusal(GetParam(), arguments, inputs.folder),
              StartsWith(GetParam() + ": " + inputs.log.string() +
                         ": holds neither velocity.csv nor pose.csv nor detections.csv, "
                         "expected the vehicle's motion in one of them."));
}

TEST_P(LogTools, RefusesACommandWithoutTheDofsColumn) {
  const Inputs inputs;
  std::string command = SmallCommandCsv();
  command.replace(command.find("surge"), 5, "heave");
  const Path file = WriteTestFile(inputs.log / "command.csv", command);
  EXPECT_THAT(
      RefusalOf(inputs),
      AllOf(StartsWith(file.string() + ": column 'tau_surge' is missing"), HasSubstr("tau_heave")));
}

TEST_P(LogTools, RefusesAnUnknownKeyOrDofInTheLog) {
  const Inputs inputs;
  const std::string file =
      WriteTestFile(inputs.log / "log.yaml", "name: small\ndof: surge\nvehicel: rov\n").string();
  EXPECT_THAT(
      RefusalOf(inputs),
      StartsWith(file + ":3: key 'vehicel' is not known here, expected one of: name, dof, "));
  WriteTestFile(file, "name: small\ndof: forward\n");
  EXPECT_EQ(RefusalOf(inputs),
            file +
                ":2: key 'dof' is 'forward', expected one or a list of surge, sway, heave, roll, "
                "pitch, yaw.\n");
}

std::vector<std::string> AllLogTools() {
  return {"fathom_identify", "fathom_compare", "fathom_simulate", "fathom_diagnose"};
}

// "identify" of "fathom_identify".
std::string ShortName(const std::string& tool) { return tool.substr(tool.find('_') + 1); }

INSTANTIATE_TEST_SUITE_P(Refusals,
                         LogTools,
                         ::testing::ValuesIn(AllLogTools()),
                         [](const auto& info) { return ShortName(info.param); });

// tool x file x damage
class DamagedLog : public ::testing::TestWithParam<std::tuple<std::string, TwoColumnCsv, Damage>> {
};

TEST_P(DamagedLog, IsRefused) {
  const auto& [tool, csv, damage] = GetParam();
  const Inputs inputs;
  const Path path = inputs.log / csv.file;
  const std::string good = csv.file == "velocity.csv" ? SmallVelocityCsv() : SmallCommandCsv();
  WriteTestFile(path, Damaged(good, csv, damage));
  const auto arguments = ArgumentsOf(tool, inputs.folder, inputs.log.string());
  EXPECT_EQ(ExpectRefusal(tool, arguments, inputs.folder),
            tool + ": " + path.string() + Refusal(csv, damage) + "\n");
}

// "identify_velocity_TimeGoesBack"
std::string CaseName(const ::testing::TestParamInfo<DamagedLog::ParamType>& info) {
  const auto& [tool, csv, damage] = info.param;
  return ShortName(tool) + "_" + csv.file.substr(0, csv.file.find('.')) + "_" + Name(damage);
}

INSTANTIATE_TEST_SUITE_P(Refusals,
                         DamagedLog,
                         ::testing::Combine(::testing::ValuesIn(AllLogTools()),
                                            ::testing::Values(kVelocity, kCommand),
                                            ::testing::ValuesIn(AllDamages())),
                         CaseName);

// What only some of the tools can be given.
TEST(Refusals, NameTheFlagOfAnUnknownValueAndTheValuesThereAre) {
  const Inputs inputs;
  for (const auto& [tool, flag, begin, part] : std::vector<std::array<std::string, 4>>{
           {"identify", "--dof=forward", "--dof: is 'forward'", "surge, sway, heave, roll, pitch"},
           {"compare", "--dofs=surge,forward", "--dofs: is 'forward'", "surge, sway, heave, roll"},
           {"identify", "--family=kalman", "--family: is 'kalman'", "least_squares, adaptive"},
           {"compare", "--families=adaptive,kalman", "--families: is 'kalman'", "least_squares, "},
           {"compare", "--sources=sonar", "--sources: is 'sonar'", "camera"}}) {
    EXPECT_THAT(
        ExpectRefusal("fathom_" + tool, {Flag("log", inputs.log), flag}, inputs.folder),
        AllOf(StartsWith("fathom_" + tool + ": " + begin + ", expected "), HasSubstr(part)));
  }
}

TEST(Refusals, IdentifyRefusesASourceThatTheLogDoesNotHold) {
  const Inputs inputs;
  EXPECT_THAT(
      ExpectRefusal("fathom_identify", {Flag("log", inputs.log), "--source=camera"}, inputs.folder),
      AllOf(StartsWith("fathom_identify: " + inputs.log.string()), HasSubstr("pose.csv")));
}

TEST(Refusals, IdentifyRefusesTheSecondOfTwoLogs) {
  const Inputs inputs;
  const Path second = WriteSmallLog(inputs.folder / "second");
  WriteTestFile(second / "velocity.csv", Damaged(SmallVelocityCsv(), kVelocity, Damage::kNan));
  EXPECT_EQ(ExpectRefusal("fathom_identify",
                          {"--log=" + inputs.log.string() + "," + second.string(),
                           "--dof=surge",
                           Flag("model", inputs.folder / "out.json")},
                          inputs.folder),
            "fathom_identify: " + (second / "velocity.csv").string() +
                Refusal(kVelocity, Damage::kNan) + "\n");
}

// Each by the flag that it has: a message that says --dof sends the user of fathom_compare to a
// flag there is not.
TEST(Refusals, AskForTheDofOfASingleCsv) {
  const Path folder = EmptyTestFolder();
  const Path csv = WriteTestFile(folder / "run.csv", SmallSingleCsv());
  for (const auto& [tool, flag] : {std::pair{std::string("fathom_identify"), std::string("--dof")},
                                   {"fathom_compare", "--dofs"}}) {
    EXPECT_THAT(ExpectRefusal(tool, {Flag("log", csv)}, folder),
                AllOf(StartsWith(tool + ": " + csv.string() + ": a single CSV (t,tau,v) "),
                      HasSubstr(" " + flag + "=surge")));
    RunsWell(tool, {Flag("log", csv), flag + "=surge"});
  }
}

TEST(Refusals, SimulateRefusesAModelThatItCannotUse) {
  const Inputs inputs;
  const auto refusal = [&](const std::string& json) {
    WriteTestFile(inputs.model, json);
    return ExpectRefusal("fathom_simulate",
                         ArgumentsOf("fathom_simulate", inputs.folder, inputs.log.string()),
                         inputs.folder);
  };
  const std::string begin = "fathom_simulate: " + inputs.model.string() + ": ";
  std::string json = SmallModelJson();
  EXPECT_THAT(refusal(json.substr(0, json.size() / 2)), StartsWith(begin + "is not JSON: "));
  json.replace(json.find("inertia"), 7, "inertie");
  EXPECT_THAT(refusal(json),
              AllOf(StartsWith(begin), HasSubstr("inertia"), HasSubstr("is missing")));
  EXPECT_THAT(
      ExpectRefusal("fathom_simulate", {Flag("log", inputs.log)}, inputs.folder),
      StartsWith("fathom_simulate: --model: is missing, expected a model or verdict file."));
}

TEST(Refusals, TheDamagesAreDifferent) {
  for (const Damage a : AllDamages()) {
    const std::string damaged = Damaged(SmallVelocityCsv(), kVelocity, a);
    EXPECT_NE(damaged, SmallVelocityCsv()) << Name(a);
    for (const Damage b : AllDamages()) {
      if (a == b) continue;
      EXPECT_NE(damaged, Damaged(SmallVelocityCsv(), kVelocity, b)) << Name(a);
    }
  }
}

// The other tools that take a DOF.
TEST(Refusals, SayWhatToDoForSeveralDofs) {
  const Inputs inputs;
  const auto refused = [&](const std::string& tool, const std::string& dof) {
    const ToolRun run = RunToolBinary(tool, {Flag("log", inputs.log), "--dof=" + dof});
    EXPECT_EQ(run.exit_code, 1);
    return run.err;
  };
  // fathom_check has no --dofs.
  EXPECT_EQ(refused("fathom_check", "surge,yaw"),
            "fathom_check: --dof: is 'surge,yaw', expected one DOF: a run for each, --dof=surge "
            "first.\n");
  for (const std::string tool : {"fathom_identify", "fathom_diagnose"}) {
    EXPECT_EQ(refused(tool, "surge,yaw,surge"),
              tool +
                  ": --dof: is 'surge,yaw,surge', expected one DOF. Several as one motion: "
                  "--dofs=surge,yaw.\n");
  }
  for (const std::string tool : {"fathom_check", "fathom_identify"}) {
    EXPECT_EQ(refused(tool, "surge,surge"),
              tool + ": --dof: is 'surge,surge', expected one DOF: --dof=surge.\n");
    EXPECT_EQ(refused(tool, "surge,yow"),
              tool + ": --dof: is 'yow', expected surge, sway, heave, roll, pitch or yaw.\n");
  }
}

TEST(Refusals, CheckSuggestsDofForDofs) {
  EXPECT_EQ(ExpectRefusal("fathom_check", {"--dofs=surge"}, EmptyTestFolder()),
            "fathom_check: --dofs: there is no such flag, did you mean --dof? See fathom_check "
            "--help.\n");
}

// The program that takes one log ignores no second one, however it is named.
TEST(Refusals, ASecondLogWhereOneIsTaken) {
  const Inputs inputs;
  const std::string log = inputs.log.string();
  const std::string second = WriteSmallLog(inputs.folder / "second").string();
  EXPECT_EQ(ExpectRefusal("fathom_track", {"--log=" + log + "," + second}, inputs.folder),
            "fathom_track: --log: names 2, expected one: this program takes one at a time.\n");
  EXPECT_EQ(ExpectRefusal("fathom_track", {"--log=" + log, "--log=" + second}, inputs.folder),
            "fathom_track: --log: is given twice, expected once.\n");
}

}  // namespace
}  // namespace fathom
