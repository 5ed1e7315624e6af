// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "synthesized_log.h"

#include <sstream>
#include <vector>

#include "run_tool.h"
#include "saved_files.h"

namespace fathom {
namespace {

constexpr int kTrainingEnd = 70;  // [s]

}  // namespace

std::filesystem::path Synthesized(const std::filesystem::path& vehicle,
                                  const std::filesystem::path& experiment,
                                  const std::string& effects,
                                  int seed,
                                  const std::filesystem::path& log) {
  std::vector<std::string> arguments = {Flag("vehicle", vehicle),
                                        Flag("experiment", experiment),
                                        "--seed=" + std::to_string(seed),
                                        Flag("out", log)};
  if (!effects.empty()) arguments.push_back("--effects=" + effects);
  RunsWell("fathom_synthesize", arguments);
  return log;
}

std::filesystem::path SmallLogWith(const std::filesystem::path& folder,
                                   const std::string& name,
                                   const std::string& effects,
                                   int seed,
                                   const std::string& vehicle_yaml) {
  const std::filesystem::path vehicle = WriteTestFile(folder / "vehicle.yaml", vehicle_yaml);
  const std::filesystem::path experiment =
      WriteTestFile(folder / "multisine.yaml",
                    "name: small_multisine\n"
                    "duration: 90\n"
                    "command_rate: 10\n"
                    "surge: {control: open_loop, input: {kind: multisine, rms: 12, "
                    "frequency: [0.15, 2], lines: 9}}\n"
                    "velocity: {rate: 10, noise: {surge: 0.005}}\n"
                    "held_out: [" +
                        std::to_string(kTrainingEnd) + ", 90]\n");
  return Synthesized(vehicle, experiment, effects, seed, folder / name);
}

std::filesystem::path SmallLogThatLoses(const std::filesystem::path& folder,
                                        const std::string& effects,
                                        int seed) {
  const auto with = SmallLogWith(folder, "with", effects, seed);
  const auto without = SmallLogWith(folder, "without", "", seed);
  std::istringstream rows_with(TextOf(with / "velocity.csv"));
  std::istringstream rows_without(TextOf(without / "velocity.csv"));
  std::string row, other, text;
  while (std::getline(rows_with, row) && std::getline(rows_without, other)) {
    const bool is_training = row.starts_with("t,") || std::stod(row) < kTrainingEnd;
    text += (is_training ? row : other) + "\n";
  }
  WriteTestFile(with / "velocity.csv", text);
  return with;
}

}  // namespace fathom
