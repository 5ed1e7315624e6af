// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Makes the log of an experiment with a known vehicle.
//
//   fathom_synthesize --vehicle=VEHICLE.yaml --experiment=EXPERIMENT.yaml --out=LOG

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/files/temporary.h"
#include "fathom/base/files/yaml_without.h"
#include "fathom/base/input_error.h"
#include "fathom/film/film_file.h"
#include "fathom/film/film_log.h"
#include "fathom/log/write_log.h"
#include "fathom/report/format_value.h"
#include "fathom/synthesize/effects/parse_hidden_effects.h"
#include "fathom/synthesize/experiment/experiment_file.h"
#include "fathom/synthesize/synthesize.h"
#include "fathom/synthesize/truth_file.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/output_folder.h"
#include "fathom/tool/progress.h"
#include "fathom/tool/tool.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(vehicle, "", "Vehicle file (YAML) that holds a model of each driven DOF.");
DEFINE_string(experiment, "", "Experiment file (YAML).");
DEFINE_uint64(
    seed,
    1,
    "Seed of every random number: the same seed gives the same log, but for the last digit on "
    "another platform.");
DEFINE_string(out, "", "Folder of the log to write: a new or an empty one.");
DEFINE_bool(overwrite, false, "Replace the log in --out if there is one.");
DEFINE_string(effects,
              "",
              "Effects to hide in the log, [DOF.]NAME[:PARAMETER=VALUE]..., separated by commas. "
              "Parameters that are not given are drawn from the seed. docs/synthesize.md lists "
              "the effects.");
DEFINE_string(film,
              "",
              "Film file (YAML): also makes a camera log, with detections.csv or images.");
DEFINE_bool(render, false, "With --film: images and frames.csv instead of detections.csv.");
DEFINE_string(truth, "", "Write what the log was made from to this file (JSON).");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    .name = "fathom_synthesize",
    .summary = "Makes the log of an experiment with a vehicle of known motion model.",
    .usage =
        "--vehicle=VEHICLE.yaml --experiment=EXPERIMENT.yaml --out=LOG [--seed=1 "
        "--effects=EFFECTS --film=FILM.yaml [--render] --truth=TRUTH.json]",
    .example =
        "fathom_synthesize --vehicle=data/vehicles/flatfish.yaml "
        "--experiment=data/experiments/table1.yaml --seed=1 --out=flatfish\n"
        "  fathom_synthesize --vehicle=data/vehicles/flatfish.yaml "
        "--experiment=data/experiments/table1.yaml --out=slow "
        "--effects=thruster_lag:time_constant=0.5,heave.coulomb_friction",
    .details =
        "The files are described in docs/file_formats.md, the method in docs/synthesize.md."};

constexpr char kVehicleCopy[] = "vehicle.yaml";  // in the log of a coupled vehicle

void PrintStream(const char* file, const std::optional<Stream>& stream) {
  if (!stream) return;
  fmt::print("{:<13}{} rows, t = {} to {} s\n",
             file,
             stream->time.size(),
             stream->time.front(),
             stream->time.back());
}

void WriteFilm(const std::filesystem::path& folder,
               const Vehicle& vehicle,
               const Experiment& experiment,
               const std::vector<ActiveEffect>& effects,
               const Log& log,
               const Film& film) {
  const auto poses = HeldPoses(ShownPoses(vehicle, experiment, effects, FLAGS_seed, film.sampling),
                               log.dofs,
                               film,
                               FLAGS_seed);
  if (!FLAGS_render) {
    WriteFilmCorners(folder, poses, film, FLAGS_seed);
    return;
  }
  Progress line("image");
  FilmProgress progress;
  progress.on_start = [](int num_images, double num_bytes) {
    constexpr double kBytesOfMegabyte = 1e6;
    fmt::print(stderr,
               "drawing {} images, about {:.0f} MB\n",
               num_images,
               std::ceil(num_bytes / kBytesOfMegabyte));
  };
  progress.on_image = [&](int done, int expected) { line.Show(done, expected); };
  WriteFilmImages(folder, poses, film, FLAGS_seed, progress);
}

// As Synthesize. An effect on poses that are not logged is a trace in the film.
Log SynthesizeFilmed(const Vehicle& vehicle,
                     Experiment experiment,
                     const std::vector<ActiveEffect>& effects,
                     const std::optional<Film>& film) {
  const bool is_logged = experiment.pose && experiment.pose->is_logged;
  const bool needs_pose =
      std::any_of(effects.begin(), effects.end(), [](const ActiveEffect& active) {
        return active.effect->info().needs_pose;
      });
  if (!film || !needs_pose || is_logged) {
    return Synthesize(vehicle, experiment, effects, FLAGS_seed);
  }
  if (!experiment.pose) experiment.pose = PoseSensor{.sampling = film->sampling};
  experiment.pose->is_logged = true;
  Log log = Synthesize(vehicle, experiment, effects, FLAGS_seed);
  log.pose.reset();
  return log;
}

int Run() {
  const Vehicle vehicle = ReadVehicleFile(RequireFlag("vehicle", FLAGS_vehicle, "a vehicle file"));
  const Experiment experiment =
      ReadExperimentFile(RequireFlag("experiment", FLAGS_experiment, "an experiment file"));
  std::optional<Film> film;
  if (!FLAGS_film.empty()) film = ReadFilmFile(FLAGS_film);
  if (FLAGS_render && !film) throw InputError("--render: needs --film, expected both.");
  const std::filesystem::path folder =
      OutputFolder(RequireFlag("out", FLAGS_out, "the folder of the log to write"),
                   FLAGS_overwrite,
                   FLAGS_render ? "frames" : "");
  RequireWritableFolder(folder);
  RequireOutside(folder, "truth", FLAGS_truth);
  RequireOutputs({{"truth", FLAGS_truth}}, {FLAGS_vehicle, FLAGS_experiment, FLAGS_film});

  std::vector<ActiveEffect> effects;
  if (!FLAGS_effects.empty()) {
    if (vehicle.coupled) {
      throw InputError(
          fmt::format("--effects: vehicle '{}' has a coupled_model, in which no effect can be "
                      "hidden, expected `models` of single DOFs.",
                      vehicle.name));
    }
    const auto scales = ScalesOf(vehicle, experiment, FLAGS_seed);
    effects = ParseHiddenEffects(FLAGS_effects, experiment, scales, FLAGS_seed);
  }
  Log log = SynthesizeFilmed(vehicle, experiment, effects, film);
  // What the thrusters and fins of its command are; the truth stays out.
  if (vehicle.coupled) log.vehicle = kVehicleCopy;
  const Temporary made(folder);
  WriteLog(made.path(), log);
  if (vehicle.coupled) {
    WriteFile(made.path() / kVehicleCopy, YamlWithout(ReadFile(FLAGS_vehicle), "coupled_model"));
  }
  if (film) WriteFilm(made.path(), vehicle, experiment, effects, log, *film);
  made.TakePlace();
  if (!FLAGS_truth.empty()) {
    WriteFile(FLAGS_truth, FormatTruth(vehicle, experiment, effects, FLAGS_seed));
  }

  fmt::print("{}: {} s of", folder.string(), experiment.duration);
  for (const Dof dof : log.dofs) fmt::print(" {}", Name(dof));
  fmt::print(", vehicle {}, seed {}\n", vehicle.name, FLAGS_seed);
  for (const ActiveEffect& effect : effects) fmt::print("hidden: {}\n", UnitText(Describe(effect)));
  if (film) fmt::print("camera log: {}\n", FLAGS_render ? "images" : "detections.csv");
  PrintStream("command.csv", log.command ? log.command : log.fins ? log.fins : log.shafts);
  PrintStream("velocity.csv", log.velocity);
  PrintStream("pose.csv", log.pose);
  for (const Remark& remark : log.remarks) fmt::print("{}\n", remark.text);
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
