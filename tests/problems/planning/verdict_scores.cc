// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// How many `ambiguous` verdicts the planned experiment turns into the right single cause, for
// docs/plan.md. Run by hand; tool_synthesize, tool_diagnose and tool_plan must be built:
//
//   verdict_scores FOLDER [first seed] [last seed] [correlation of the noise]
//
// A line for each log. The folder keeps the files.

#include "fathom/base/files/output_file.h"
#include "fathom/base/random_stream.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "run_tool.h"
#include "saved_files.h"
#include "tank_trial.h"
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kSensorNoise = 0.005;  // [m/s]

// An effect of the pairs that a sine leaves open, at a size that it shows.
struct HiddenCause {
  const char* effect;
  const char* parameter;
  double size;
};
constexpr HiddenCause kHiddenCauses[] = {{"time_offset", "offset", 0.4},
                                         {"thruster_lag", "time_constant", 0.4},
                                         {"thrust_dead_zone", "width", 4.0},
                                         {"coulomb_friction", "force", 2.5},
                                         {"cubic_damping", "coefficient", 300.0},
                                         {"steady_current", "speed", 0.08}};

struct Verdict {
  std::string name;
  std::vector<std::string> causes, alternatives;

  bool IsRight(const std::string& effect) const {
    return name == "explained" && causes == std::vector<std::string>{effect};
  }
  std::string Line() const {
    return fmt::format(
        "{} {} (or {})", name, fmt::join(causes, "+"), fmt::join(alternatives, ", "));
  }
};

Verdict Diagnosed(const std::vector<std::string>& logs, const std::filesystem::path& file) {
  std::vector<std::string> flags = {"--dof=surge", "--threads=1", Flag("verdict", file)};
  for (const std::string& log : logs) flags.push_back("--log=" + log);
  const ToolRun run = RunToolBinary("fathom_diagnose", flags);
  if (run.exit_code != 0) return {"no fit", {}, {}};
  const nlohmann::json json = JsonOf(file);
  Verdict verdict = {json["verdict"], {}, {}};
  for (const auto& cause : json["causes"]) {
    verdict.causes.push_back(cause["effect"]);
    for (const auto& label : cause["alternatives"]) verdict.alternatives.push_back(label);
  }
  return verdict;
}

// Whether the plan says to log positions.
bool AdvisesPositions(const nlohmann::json& plan) {
  const auto& pairs = plan["separations"];
  return std::any_of(pairs.begin(), pairs.end(), [](const nlohmann::json& pair) {
    return pair["sigmas_with_positions"].is_number() && pair["sigmas_with_positions"] >= 5.0;
  });
}

// The least separation of the true cause from any other, and from which.
std::string ForecastOf(const nlohmann::json& plan, const std::string& effect) {
  std::string weakest = "?";
  double least = 1e9;
  for (const auto& pair : plan["separations"]) {
    if (pair["truth"] != effect || pair["sigmas"].get<double>() > least) continue;
    least = pair["sigmas"];
    weakest = fmt::format("{:.1f} sigma from {}", least, pair["assumed"].get<std::string>());
  }
  return weakest;
}

void TryCause(const std::filesystem::path& folder,
              std::uint64_t seed,
              const HiddenCause& cause,
              double correlation) {
  const TankVehicle vehicle = DrawTankVehicle(seed);
  RandomStream random(seed, std::string("verdict.") + cause.effect);
  const double size = cause.size * (0.7 + 0.6 * random.Uniform());
  const std::string effects = fmt::format("{}:{}={:.4g}", cause.effect, cause.parameter, size);
  const std::filesystem::path place = folder / fmt::format("{}_{}", cause.effect, seed);
  const auto file = [&](const char* name) { return (place / name).string(); };
  std::filesystem::remove_all(place);
  std::filesystem::create_directories(place);
  WriteFile(file("vehicle.yaml"),
            fmt::format("name: tank\nmass: 274\nmodels:\n  surge: {{inertia: {}, "
                        "quadratic_damping: {}, linear_damping: {}, buoyancy: {}}}\n",
                        vehicle.truth.inertia,
                        vehicle.truth.quadratic_damping,
                        vehicle.truth.linear_damping,
                        vehicle.truth.buoyancy));
  WriteFile(file("limits.yaml"),
            "force: 60\nspeed: 0.6\ndistance: {back: 3, ahead: 5}\nshortest_hold: 1\n");
  const std::vector<double> sine = LargestSine(vehicle, 120.0).value;
  const auto [low, high] = std::minmax_element(sine.begin(), sine.end());
  const std::string sensor =
      fmt::format("velocity:\n  rate: 10\n  noise: {{surge: {}}}\n{}",
                  kSensorNoise,
                  correlation > 0.0 ? fmt::format("  noise_correlation: {}\n", correlation) : "");
  WriteFile(file("first.yaml"),
            fmt::format("name: first\nduration: 200\ncommand_rate: 10\nsurge:\n  control: "
                        "open_loop\n  input: {{kind: sine, amplitude: {}, frequency: 0.3, offset: "
                        "{}}}\n{}",
                        0.5 * (*high - *low),
                        0.5 * (*high + *low),
                        sensor));
  const std::string with_effects = "--effects=" + effects;
  const std::string of_vehicle = "--vehicle=" + file("vehicle.yaml");
  const std::string with_seed = fmt::format("--seed={}", seed);
  RunsWell("fathom_synthesize",
           {of_vehicle,
            "--experiment=" + file("first.yaml"),
            with_effects,
            with_seed,
            "--out=" + file("first")});
  const Verdict before = Diagnosed({file("first")}, file("first.json"));
  if (before.name != "ambiguous") {
    fmt::print("{} | {:34} | not ambiguous: {}\n", seed, effects, before.Line());
    std::fflush(stdout);
    return;
  }
  const ToolRun run = RunToolBinary("fathom_plan",
                                    {"--verdict=" + file("first.json"),
                                     "--limits=" + file("limits.yaml"),
                                     "--duration=120",
                                     "--out=" + file("plan")});
  if (run.exit_code != 0) {
    fmt::print("{} | {:34} | no plan | {} | {}\n", seed, effects, before.Line(), run.err);
    return;
  }
  // Sensor and seed of the next log are those of the vehicle, not of the plan. Positions are logged
  // where it says so.
  const bool has_positions = AdvisesPositions(JsonOf(file("plan/plan.json")));
  WriteFile(
      file("plan/next.yaml"),
      fmt::format(
          "name: next\nduration: 120\ncommand_rate: 10\nsurge:\n  control: "
          "open_loop\n  input: {{kind: file, file: command.csv}}\n{}{}",
          sensor,
          has_positions ? "pose:\n  rate: 10\n  noise: {position: 0.02, angle: 0.01}\n" : ""));
  RunsWell("fathom_synthesize",
           {of_vehicle,
            "--experiment=" + file("plan/next.yaml"),
            with_effects,
            fmt::format("--seed={}", seed + 1000),
            "--out=" + file("next")});
  const Verdict after = Diagnosed({file("next")}, file("next.json"));
  const Verdict both = Diagnosed({file("first"), file("next")}, file("both.json"));
  fmt::print("{} | {:34} | {:5} | {:5} | {} | {} | {}{} | both: {}\n",
             seed,
             effects,
             after.IsRight(cause.effect) ? "right" : "NOT",
             both.IsRight(cause.effect) ? "right" : "NOT",
             before.Line(),
             ForecastOf(JsonOf(file("plan/plan.json")), cause.effect),
             has_positions ? "with positions: " : "",
             after.Line(),
             both.Line());
  std::fflush(stdout);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "verdict_scores FOLDER [first seed] [last seed] [correlation]\n");
    return 1;
  }
  const int first = argc > 2 ? std::atoi(argv[2]) : 1;
  const int last = argc > 3 ? std::atoi(argv[3]) : 10;
  const double correlation = argc > 4 ? std::atof(argv[4]) : 0.0;
  for (int seed = first; seed <= last; ++seed) {
    for (const fathom::HiddenCause& cause : fathom::kHiddenCauses) {
      fathom::TryCause(argv[1], static_cast<std::uint64_t>(seed), cause, correlation);
    }
  }
  return 0;
}
