// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Makes the log of an experiment with a known vehicle.
//
//   fathom_synthesize --vehicle=VEHICLE.yaml --experiment=EXPERIMENT.yaml --out=LOG

#include "fathom/base/input_error.h"
#include "fathom/base/output_file.h"
#include "fathom/log/write_log.h"
#include "fathom/simulate/effect_list.h"
#include "fathom/simulate/experiment_file.h"
#include "fathom/simulate/synthesize.h"
#include "fathom/simulate/truth_file.h"
#include "fathom/tools/tool.h"
#include "fathom/vehicle/vehicle_file.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>
#include <unistd.h>

DEFINE_string(vehicle, "", "Vehicle file (YAML) that holds a model of each driven DOF.");
DEFINE_string(experiment, "", "Experiment file (YAML).");
DEFINE_uint64(seed, 1, "Seed of every random number: the same seed gives the same bytes.");
DEFINE_string(out, "", "Folder of the log to write: a new or an empty one.");
DEFINE_bool(overwrite, false, "Replace the log in --out if there is one.");
DEFINE_string(effects,
              "",
              "Effects to hide in the log, [DOF.]NAME[:PARAMETER=VALUE]... separated by commas; "
              "what is not given is drawn. docs/synthesize.md lists them.");
DEFINE_string(truth, "", "Write what the log was made from to this file (JSON).");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    .name = "fathom_synthesize",
    .summary = "Makes the log of an experiment with a vehicle whose motion model is known.",
    .usage =
        "--vehicle=VEHICLE.yaml --experiment=EXPERIMENT.yaml --out=LOG [--seed=1 "
        "--effects=EFFECTS --truth=TRUTH.json]",
    .example =
        "fathom_synthesize --vehicle=data/vehicles/flatfish.yaml "
        "--experiment=data/experiments/table1.yaml --seed=1 --out=flatfish\n"
        "  fathom_synthesize --vehicle=data/vehicles/flatfish.yaml "
        "--experiment=data/experiments/table1.yaml --out=slow "
        "--effects=thruster_lag:time_constant=0.5,heave.coulomb_friction",
    .details =
        "The files are described in docs/file_formats.md, the method in docs/synthesize.md."};

// A folder that takes its final name only once it is complete.
class FolderInTheMaking {
 public:
  explicit FolderInTheMaking(const std::filesystem::path& folder)
      : folder_(folder), temporary_(folder.string() + ".part" + std::to_string(getpid())) {}

  ~FolderInTheMaking() {
    std::error_code error;
    std::filesystem::remove_all(temporary_, error);
  }

  const std::filesystem::path& path() const { return temporary_; }

  void Finish() const {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
    if (!error) std::filesystem::rename(temporary_, folder_, error);
    if (error) {
      throw InputError(
          fmt::format("{}: cannot write this folder: {}.", folder_.string(), error.message()));
    }
  }

 private:
  std::filesystem::path folder_;
  std::filesystem::path temporary_;
};

std::filesystem::path OutputFolder() {
  const std::filesystem::path folder =
      RequireFlag("out", FLAGS_out, "the folder of the log to write");
  // Without a slash at the end, which would make the temporary's place be inside it.
  const std::filesystem::path named = folder.has_filename() ? folder : folder.parent_path();
  std::error_code error;
  if (!std::filesystem::exists(named, error)) return named;
  if (!std::filesystem::is_directory(named, error)) {
    throw InputError(fmt::format("--out={}: is a file, expected a folder.", FLAGS_out));
  }
  if (std::filesystem::is_empty(named, error) && !error) return named;
  // Only what is a log may be replaced: a wrong path must not cost a folder of something else.
  const bool is_log = std::filesystem::exists(named / "log.yaml", error);
  if (!FLAGS_overwrite || !is_log) {
    throw InputError(fmt::format("--out={}: the folder is not empty{}.",
                                 FLAGS_out,
                                 is_log ? ", expected --overwrite to replace the log in it"
                                        : " and holds no log, expected a new folder"));
  }
  return named;
}

void PrintStream(const char* file, const std::optional<Stream>& stream) {
  if (!stream) return;
  fmt::print("{:<13}{} rows, t = {} to {} s\n",
             file,
             stream->time.size(),
             stream->time.front(),
             stream->time.back());
}

int Run() {
  const Vehicle vehicle = ReadVehicleFile(RequireFlag("vehicle", FLAGS_vehicle, "a vehicle file"));
  const Experiment experiment =
      ReadExperimentFile(RequireFlag("experiment", FLAGS_experiment, "an experiment file"));
  const std::filesystem::path folder = OutputFolder();

  std::vector<ActiveEffect> effects;
  if (!FLAGS_effects.empty()) {
    const auto scales = ScalesOf(vehicle, experiment, FLAGS_seed);
    effects = ParseEffectList(FLAGS_effects, experiment, scales, FLAGS_seed);
  }
  const Log log = Synthesize(vehicle, experiment, effects, FLAGS_seed);
  if (!FLAGS_truth.empty()) {
    WriteFile(FLAGS_truth, FormatTruth(vehicle, experiment, effects, FLAGS_seed));
  }
  const FolderInTheMaking made(folder);
  WriteLog(made.path(), log);
  made.Finish();

  fmt::print("{}: {} s of", folder.string(), experiment.duration);
  for (const Dof dof : log.dofs) fmt::print(" {}", Name(dof));
  fmt::print(", vehicle {}, seed {}\n", vehicle.name, FLAGS_seed);
  for (const ActiveEffect& effect : effects) fmt::print("hidden: {}\n", Describe(effect));
  PrintStream("command.csv", log.command);
  PrintStream("velocity.csv", log.velocity);
  PrintStream("pose.csv", log.pose);
  for (const std::string& remark : log.remarks) fmt::print("{}\n", remark);
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
