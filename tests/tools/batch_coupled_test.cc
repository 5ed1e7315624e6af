// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_batch --dofs: one coupled model of each log beside those of single DOFs.

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "batch_results.h"
#include "boat_log.h"
#include "run_tool.h"
#include "saved_files.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const char kCoupledRuns[] =
    "SELECT count(*) FROM runs WHERE program = 'fathom_diagnose' AND arguments LIKE '--dofs=%'";

class CoupledBatch : public ::testing::Test {
 protected:
  std::vector<std::string> FlagsWith(std::vector<std::string> more, const fs::path& results) const {
    std::vector<std::string> flags = {Flag("archive", archive_),
                                      Flag("results", results),
                                      "--jobs=2",
                                      "--families=least_squares",
                                      "--diagnose=false"};
    flags.insert(flags.end(), more.begin(), more.end());
    return flags;
  }

  ToolRun Run(std::vector<std::string> more) const {
    return RunToolBinary("fathom_batch", FlagsWith(std::move(more), results_));
  }

  // A sound run, and one whose starboard thruster gives 60 %.
  void WriteTwoRuns() const {
    WriteBoatLog({.starboard_gain = 1.0, .seed = 5}, archive_ / "dive 1/sound");
    WriteBoatLog({.starboard_gain = 0.6, .seed = 6}, archive_ / "dive 1/weak");
  }

  const fs::path folder_ = EmptyTestFolder();
  const fs::path archive_ = folder_ / "archive", results_ = folder_ / "r.sqlite";
};

TEST_F(CoupledBatch, NamesTheWeakThrusterOfItsLog) {
  WriteTwoRuns();
  const fs::path csv = folder_ / "fits.csv", page = folder_ / "r.html";
  const ToolRun run =
      RunsWell(Run({"--dofs=yaw,surge", Flag("csv", csv), Flag("report", page), "--pages"}));
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("2 logs in 1 dive: 2 ok"),
                    HasSubstr("2 coupled models: 1 consistent, 1 explained. They name "
                              "thrust_gain.starboard (1 log).\n")));
  EXPECT_THAT(Query("SELECT log, dof, verdict FROM verdicts ORDER BY log", results_),
              ElementsAre("dive 1/sound|surge,yaw|consistent", "dive 1/weak|surge,yaw|explained"));
  // 0.6 within 0.002, which is ten times its std here.
  EXPECT_THAT(
      Query("SELECT log, effect, abs(value - 0.6) < 0.002, std < 0.001 FROM causes", results_),
      ElementsAre("dive 1/weak|thrust_gain.starboard|1|1"));
  EXPECT_THAT(
      Query("SELECT log, source, usable, abs(value - 40) < 0.2, unit FROM fits WHERE family = "
            "'coupled' AND parameter = 'inertia.surge' ORDER BY log",
            results_),
      ElementsAre("dive 1/sound|diagonal|1|1|kg", "dive 1/weak|thruster|1|1|kg"));
  // Those of single DOFs stand beside, and dives are fitted by them.
  EXPECT_THAT(
      Query("SELECT DISTINCT dof FROM fits WHERE family = 'least_squares' ORDER BY dof", results_),
      ElementsAre("surge", "yaw"));
  EXPECT_THAT(Query("SELECT DISTINCT dof FROM dive_fits ORDER BY dof", results_),
              ElementsAre("surge", "yaw"));
  EXPECT_THAT(TextOf(csv),
              HasSubstr("dive 1/weak,\"surge,yaw\",coupled,thruster,1,thrust_gain.starboard,0.6"));
  EXPECT_THAT(TextOf(page),
              AllOf(HasSubstr("<td>thruster</td><td>explained</td><td>thrust_gain.starboard 0.6"),
                    HasSubstr("<a href=\"r_pages/dive_1_weak_surge_yaw_")));
}

TEST_F(CoupledBatch, RunsOnlyTheCoupledModelsWhereTheOthersAreDone) {
  WriteTwoRuns();
  RunsWell(Run({}));
  EXPECT_THAT(Query(kCoupledRuns, results_), ElementsAre("0"));
  const auto before = PublicRows(results_);
  const auto others = Query("SELECT key FROM runs WHERE arguments NOT LIKE '--dofs=%,%'", results_);
  EXPECT_THAT(RunsWell(Run({"--dofs=auto"})).out, HasSubstr("2 logs run now, 0 done before"));
  EXPECT_THAT(Query(kCoupledRuns, results_), ElementsAre("2"));
  EXPECT_EQ(Query("SELECT key FROM runs WHERE arguments NOT LIKE '--dofs=%,%'", results_), others);
  // auto and its DOFs are one question.
  EXPECT_THAT(RunsWell(Run({"--dofs=surge,yaw"})).out, HasSubstr("0 logs run now, 2 done before"));
  RunsWell(Run({}));
  EXPECT_EQ(PublicRows(results_), before);
}

TEST_F(CoupledBatch, TakesTheVehicleOfTheArchiveForLogsThatNameNone) {
  WriteTwoRuns();
  RunsWell(Run({"--dofs=surge,yaw"}));
  const auto of_logs = Query("SELECT * FROM causes", results_);
  fs::remove_all(archive_);
  WriteBoatLog({.starboard_gain = 1.0, .seed = 5, .names_vehicle = false},
               archive_ / "dive 1/sound");
  WriteBoatLog({.starboard_gain = 0.6, .seed = 6, .names_vehicle = false},
               archive_ / "dive 1/weak");
  RunsWell(Run({"--dofs=surge,yaw"}));
  EXPECT_THAT(StatesOf(results_)["dive 1/weak"], HasSubstr("names no vehicle file"));
  WriteBoatFile(archive_ / "boat.yaml");
  WriteTestFile(archive_ / "archive.yaml", "vehicle: boat.yaml\n");
  EXPECT_THAT(RunsWell(Run({"--dofs=surge,yaw"})).out, HasSubstr("2 logs in 1 dive: 2 ok"));
  EXPECT_EQ(Query("SELECT * FROM causes", results_), of_logs);
  EXPECT_THAT(Query("SELECT DISTINCT vehicle FROM logs", results_), ElementsAre("boat"));
  EXPECT_THAT(RunsWell(Run({"--dofs=surge,yaw"})).out, HasSubstr("0 logs run now, 2 done before"));
  // A remark asks nothing new; another mass does.
  const std::string boat = TextOf(archive_ / "boat.yaml");
  WriteTestFile(archive_ / "boat.yaml", boat + "# the same, but for a remark\n");
  EXPECT_THAT(RunsWell(Run({"--dofs=surge,yaw"})).out, HasSubstr("0 logs run now, 2 done before"));
  WriteTestFile(archive_ / "boat.yaml",
                "name: boat\nmass: 29" + boat.substr(boat.find("\nthrusters")));
  EXPECT_THAT(RunsWell(Run({"--dofs=surge,yaw"})).out, HasSubstr("2 logs run now, 0 done before"));
}

// Twelve dives of one log; the starboard thruster gives that much from dive 7 on.
class TwelveDives : public CoupledBatch {
 protected:
  void WriteDives(double gain_from_dive_7) const {
    for (unsigned dive = 1; dive <= 12; ++dive) {
      WriteBoatLog({.starboard_gain = dive < 7 ? 1.0 : gain_from_dive_7, .seed = 100 + dive},
                   archive_ / fmt::format("dive {}/run", dive));
    }
  }
};

TEST_F(TwelveDives, NameTheThrusterThatWeakensAndNothingElse) {
  WriteDives(0.8);
  const fs::path page = folder_ / "r.html";
  const std::vector<std::string> flags = {"--dofs=surge,yaw", Flag("report", page)};
  const std::string out = RunsWell(Run(flags)).out;
  EXPECT_THAT(out,
              AllOf(StartsWith("From dive 7 on the thrust of thruster starboard is "),
                    HasSubstr(" % weaker (± "),
                    HasSubstr("): thruster(starboard).\n12 logs in 12 dives: 12 ok")));
  // 0.8 within 0.005, five times its std.
  EXPECT_THAT(Query("SELECT dof, parameter, kind, at, abs(before - 1) < 0.005, "
                    "abs(after - 0.8) < 0.005, after_std < 0.001, cause FROM changes",
                    results_),
              ElementsAre("surge,yaw|thrust_gain.starboard|step|dive 7|1|1|1|thruster(starboard)"));
  EXPECT_THAT(Query("SELECT * FROM outliers", results_), ElementsAre());
  // The gain is free in sound dives too: else nothing could be compared.
  EXPECT_THAT(Query("SELECT count(*) FROM dive_fits WHERE dof = 'surge,yaw' AND usable AND "
                    "parameter = 'thrust_gain.starboard' AND std > 0",
                    results_),
              ElementsAre("12"));
  EXPECT_THAT(TextOf(page),
              AllOf(HasSubstr("From dive 7 on the thrust of thruster starboard is "),
                    HasSubstr("\"parameter\":\"thrust_gain.starboard\"")));
  // What is known is compared as what was run.
  const auto rows = PublicRows(results_);
  WriteTestFile(archive_ / "dive 9/notes.txt", "no log");
  WriteBoatLog({.starboard_gain = 0.8, .turns = false, .seed = 200}, archive_ / "dive 9/straight");
  EXPECT_THAT(RunsWell(Run(flags)).out, HasSubstr("1 log run now, 12 done before"));
  fs::remove_all(archive_ / "dive 9/straight");
  RunsWell(Run(flags));
  EXPECT_EQ(PublicRows(results_), rows);
}

TEST_F(TwelveDives, OfASoundBoatNameNothing) {
  WriteDives(1.0);
  EXPECT_THAT(RunsWell(Run({"--dofs=surge,yaw"})).out,
              StartsWith("No change over 12 dives.\n12 logs in 12 dives: 12 ok"));
  EXPECT_THAT(Query("SELECT * FROM changes", results_), ElementsAre());
  EXPECT_THAT(Query("SELECT * FROM outliers", results_), ElementsAre());
}

TEST_F(CoupledBatch, TellsOfALogWithoutAUsableFit) {
  WriteBoatLog({.turns = false}, archive_ / "straight");
  const std::vector<std::string> flags = {"--dofs=surge,yaw", Flag("report", folder_ / "r.html")};
  RunsWell(Run(flags));
  EXPECT_THAT(StatesOf(results_)["straight"],
              StartsWith("partial: surge,yaw, fathom_diagnose: no diagnosis: "));
  EXPECT_THAT(
      Query("SELECT usable, parameter, message FROM fits WHERE family = 'coupled'", results_),
      ElementsAre(StartsWith("0||no diagnosis: ")));
  EXPECT_THAT(Query("SELECT exit_code FROM runs WHERE program = 'fathom_diagnose'", results_),
              ElementsAre("2"));
  EXPECT_THAT(TextOf(folder_ / "r.html"), HasSubstr("<td>no usable fit</td><td>no diagnosis: "));
  EXPECT_THAT(RunsWell(Run(flags)).out, HasSubstr("0 logs run now, 1 done before"));
}

TEST_F(CoupledBatch, TakesTheDofsThatALogMoves) {
  WriteBoatLog({.turns = false}, archive_ / "straight");
  RunsWell(Run({"--dofs=auto"}));
  EXPECT_THAT(Query(kCoupledRuns, results_), ElementsAre("0"));
  EXPECT_THAT(StatesOf(results_)["straight"], StartsWith("ok: "));
}

TEST_F(CoupledBatch, SaysWhichDofsThatMoveItLeavesOut) {
  WriteBoatLog({.seed = 5, .rolls = true}, archive_ / "a");
  WriteBoatLog({.seed = 6, .rolls = true}, archive_ / "b");
  const fs::path page = folder_ / "r.html";
  const std::string said =
      "Left out of the coupled models, though the vehicle moves so: roll (2 logs, as a: moves by "
      "0.1 rad/s, and nothing commands it). --dofs=DOF,... models what it names.";
  const std::vector<std::string> flags = {"--dofs=auto", Flag("report", page)};
  EXPECT_THAT(RunsWell(Run(flags)).out, HasSubstr(said + "\n"));
  EXPECT_THAT(TextOf(page), HasSubstr(said));
  EXPECT_THAT(
      Query("SELECT log, dof, severity FROM findings WHERE id = 'left_out_of_coupled' ORDER BY log",
            results_),
      ElementsAre("a|roll|yellow", "b|roll|yellow"));
  EXPECT_THAT(RunsWell(Run(flags)).out, HasSubstr(said + "\n"));
  // Who names the DOFs knows what he leaves out.
  EXPECT_THAT(RunsWell(Run({"--dofs=surge,yaw"})).out, ::testing::Not(HasSubstr("Left out")));
}

TEST_F(CoupledBatch, KeepsTheOthersOfALogWhoseCoupledModelCrashes) {
  WriteBoatLog({}, archive_ / "segfault_diagnose");
  const fs::path tools = folder_ / "tools";
  fs::create_directories(tools);
  for (const char* program : {"batch", "compare", "diagnose", "identify", "simulate"}) {
    fs::create_symlink(FATHOM_UNRULY_TOOL, tools / (std::string("fathom_") + program));
  }
  RunsWell(Run({"--dofs=surge,yaw", Flag("tools", tools)}));
  EXPECT_EQ(StatesOf(results_)["segfault_diagnose"],
            "partial: surge,yaw, fathom_diagnose: crashed by signal 11 (Segmentation fault)");
  EXPECT_THAT(Query("SELECT DISTINCT usable FROM fits WHERE family = 'least_squares'", results_),
              ElementsAre("1"));
  EXPECT_THAT(Query("SELECT message FROM fits WHERE family = 'coupled'", results_),
              ElementsAre("crashed by signal 11 (Segmentation fault)"));
}

TEST_F(CoupledBatch, GoesOnToTheSameResultsAfterAKill) {
  WriteTwoRuns();
  const auto start = std::chrono::steady_clock::now();
  RunsWell(Run({"--dofs=auto"}));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const auto undisturbed = PublicRows(results_);
  for (const double share : {0.3, 0.7}) {
    const fs::path results = folder_ / ("killed_" + std::to_string(share) + ".sqlite");
    const auto flags = FlagsWith({"--dofs=auto"}, results);
    std::thread killer;
    RunToolBinary("fathom_batch", flags, [&](int parent) {
      killer = std::thread([=] {
        std::this_thread::sleep_for(share * seconds);
        kill(parent, SIGKILL);
      });
    });
    killer.join();
    RunsWell("fathom_batch", flags);
    EXPECT_EQ(PublicRows(results), undisturbed) << share;
  }
}

TEST_F(CoupledBatch, MergesItsParts) {
  WriteTwoRuns();
  const auto part = [&](int i) { return folder_ / ("part" + std::to_string(i) + ".sqlite"); };
  for (int i = 0; i < 2; ++i) {
    RunsWell("fathom_batch",
             FlagsWith({"--dofs=auto", "--shard=" + std::to_string(i) + "/2"}, part(i)));
  }
  RunsWell(Run({"--dofs=auto", Flag("merge", part(0)), Flag("merge", part(1))}));
  EXPECT_THAT(Query(kCoupledRuns, results_), ElementsAre("2"));
  EXPECT_THAT(PublicRows(results_), Contains(HasSubstr("thrust_gain.starboard")));
  const fs::path at_once = folder_ / "at_once.sqlite";
  RunsWell("fathom_batch", FlagsWith({"--dofs=auto"}, at_once));
  EXPECT_EQ(PublicRows(results_), PublicRows(at_once));
}

TEST_F(CoupledBatch, RefusesDofsThatAreNone) {
  WriteBoatLog({}, archive_ / "run");
  for (const auto& [value, said] :
       {std::pair{"surge", "--dofs: is 'surge', expected two or more as surge,sway,yaw, or auto."},
        std::pair{"surge,up", "--dofs: is 'up', expected surge, sway, heave, roll, pitch or yaw."},
        std::pair{"yaw,surge,yaw", "--dofs: names yaw twice, expected each once."}}) {
    const ToolRun run = Run({std::string("--dofs=") + value});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, HasSubstr(said));
    EXPECT_FALSE(fs::exists(results_));
  }
}

}  // namespace
}  // namespace fathom
