// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/slurm_script.h"

#include "fathom/base/input_error.h"
#include "fathom/process/run_child.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "test_folder.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string FileText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

fs::path Write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  fs::permissions(path, fs::perms::owner_all);
  return path;
}

std::vector<std::string> Entries(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

// Runs the script in a bash, as Slurm does, with a fathom_batch that notes its arguments in `args`,
// one per line, and writes "results" to its results.
class SlurmScriptTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "disk");
    options_.archive = shared_ / "a vehicle's \"dives\"";
    options_.results = shared_ / "the $HOME `id` \\ *, results.sqlite";
    options_.tools = shared_ / "the tools";
    options_.families = "output_error,joint";
    options_.weighting = "learned";
    options_.coupled_dofs = {Dof::kSurge, Dof::kYaw};
    Write(options_.tools / "fathom_batch",
          fmt::format("#!/bin/bash\n"
                      "printf '%s\\n' \"$@\" > '{}/args'\n"
                      "[[ ! -e '{}/fail' ]] || exit 1\n"
                      "for a in \"$@\"; do\n"
                      "  if [[ $a == --results=* ]]; then echo results > \"${{a#*=}}\"; fi\n"
                      "done\n",
                      folder_.string(),
                      folder_.string()));
  }

  // "1" for a task, "merge" for the merge.
  ChildResult Run(const std::string& what, std::vector<std::string> environment = {}) const {
    const fs::path script = Write(folder_ / "job", SlurmScript(options_, 3, report_));
    std::vector<std::string> arguments = {"TMPDIR=" + (folder_ / "disk").string(),
                                          "SLURM_ARRAY_JOB_ID=71",
                                          "SLURM_JOB_ID=73",
                                          "SLURM_ARRAY_TASK_ID=" + what};
    arguments.insert(arguments.end(), environment.begin(), environment.end());
    arguments.insert(arguments.end(), {"bash", script.string()});
    if (what == "merge") arguments.push_back(what);
    return RunChild({.program = "env", .arguments = arguments});
  }

  std::vector<std::string> Arguments() const {
    std::istringstream text(FileText(folder_ / "args"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }

  fs::path Part(int part) const {
    return options_.results.string() + ".part" + std::to_string(part);
  }

  const fs::path folder_ = EmptyTestFolder();
  const fs::path shared_ = folder_ / "shared";
  fs::path report_;
  BatchOptions options_;
};

TEST_F(SlurmScriptTest, ATaskDoesItsPartOnTheNodesDiskAndCopiesIt) {
  const ChildResult run = Run("1");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(Arguments(),
              ElementsAre("--archive=" + options_.archive.string(),
                          "--results=" + (folder_ / "disk/fathom_71_1/part.sqlite").string(),
                          "--merge=" + options_.results.string(),
                          "--shard=1/3",
                          "--jobs=1",
                          "--time_limit=600",
                          "--memory_limit=2000",
                          "--diagnose=true",
                          "--families=output_error,joint",
                          "--weighting=learned",
                          "--dofs=surge,yaw",
                          "--tools=" + options_.tools.string()));
  EXPECT_EQ(FileText(Part(1)), "results\n");
  EXPECT_THAT(Entries(folder_ / "disk"), IsEmpty());
}

TEST_F(SlurmScriptTest, TheMergeTakesAllPartsAndTheReport) {
  report_ = shared_ / "dives' page.html";
  const ChildResult run = Run("merge");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const std::vector<std::string> arguments = Arguments();
  ASSERT_GE(arguments.size(), 5u);
  EXPECT_EQ(arguments[1], "--results=" + options_.results.string());
  for (int part = 0; part < 3; ++part)
    EXPECT_EQ(arguments[2 + part], "--merge=" + Part(part).string());
  EXPECT_EQ(arguments.back(), "--report=" + report_.string());
  EXPECT_THAT(arguments, Not(Contains(HasSubstr("--shard"))));
}

TEST_F(SlurmScriptTest, ATaskThatFailsFailsAndGivesNoPart) {
  Write(folder_ / "fail", "");
  EXPECT_EQ(Run("2").exit_code, 1);
  EXPECT_FALSE(fs::exists(Part(2)));
  // What it had done is there when it runs again.
  EXPECT_THAT(Entries(folder_ / "disk"), ElementsAre("fathom_71_2"));
}

TEST_F(SlurmScriptTest, ATaskKilledWhileItCopiesLeavesNoHalfPart) {
  // A cp that copies half and takes the script with it.
  const fs::path bin = folder_ / "bin";
  Write(bin / "cp", "#!/bin/bash\nhead -c 3 \"$1\" > \"$2\"\nkill -9 $PPID\n");
  const ChildResult killed = Run("0", {"PATH=" + bin.string() + ":/usr/bin:/bin"});
  EXPECT_NE(killed.exit_code, 0);
  EXPECT_FALSE(fs::exists(Part(0)));

  // Queued again.
  ASSERT_EQ(Run("0", {"SLURM_RESTART_COUNT=1"}).exit_code, 0);
  EXPECT_EQ(FileText(Part(0)), "results\n");
  const auto is_copy = HasSubstr(".copy.");
  EXPECT_THAT(Entries(shared_), Contains(is_copy));
  ASSERT_EQ(Run("merge").exit_code, 0);
  EXPECT_THAT(Entries(shared_), Not(Contains(is_copy)));
  EXPECT_EQ(FileText(Part(0)), "results\n");
}

TEST_F(SlurmScriptTest, ATaskWhoseTmpdirIsMissingOnItsNodeTakesTmp) {
  const std::string job =
      "SLURM_ARRAY_JOB_ID=" + fmt::format("test{}", std::hash<std::string>{}(folder_.string()));
  const ChildResult run = Run("1", {"TMPDIR=/nowhere/at all", job});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(Arguments().at(1), testing::StartsWith("--results=/tmp/fathom_test"));
  EXPECT_EQ(FileText(Part(1)), "results\n");
}

// The merge finds there what a task made of images; else it would track all of them again.
TEST_F(SlurmScriptTest, TrackedLogsGoToTheSharedDisk) {
  const fs::path batch = options_.tools / "fathom_batch";
  Write(batch,
        FileText(batch) + "if [[ -d ${2#*=}.logs ]]; then mkdir \"${2#*=}.logs/4711\"; fi\n");
  ASSERT_EQ(Run("1").exit_code, 0);
  EXPECT_THAT(Entries(options_.results.string() + ".logs"), ElementsAre("4711"));
}

TEST_F(SlurmScriptTest, ReservesProcessorsAndMemoryForAllPrograms) {
  options_.jobs = 3;
  options_.memory_limit = 1500.0;
  const std::string script = SlurmScript(options_, 3, "");
  EXPECT_THAT(script, HasSubstr("\n#SBATCH --cpus-per-task=3\n"));
  EXPECT_THAT(script, HasSubstr("\n#SBATCH --mem=5000M\n"));  // 3 * 1500 + 500
  EXPECT_THAT(script, HasSubstr("\n#SBATCH --requeue\n"));
}

TEST_F(SlurmScriptTest, TheMergeWritesTheTable) {
  EXPECT_THAT(SlurmScript(options_, 3, "", "/shared/fits.csv"),
              HasSubstr(R"("${flags[@]}" --csv=/shared/fits.csv)"));
}

TEST_F(SlurmScriptTest, RefusesNoPartsAndTooMany) {
  EXPECT_THROW(SlurmScript(options_, 0, ""), InputError);
  EXPECT_THROW(SlurmScript(options_, 10001, ""), InputError);
  EXPECT_THAT(HowToSubmit("my job", 8), HasSubstr("sbatch --parsable --array=0-7 'my job'"));
}

}  // namespace
}  // namespace fathom
