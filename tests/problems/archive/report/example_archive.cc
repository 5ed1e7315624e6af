// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "example_archive.h"

#include "fathom/vehicle/parameters.h"

#include <array>
#include <random>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::array<const char*, 3> kDofs = {"surge", "sway", "heave"};
constexpr std::array<const char*, 4> kUnits = {"kg", "kg/m", "kg/s", "N"};
constexpr std::array<ParameterVector::Scalar, 4> kStds = {1.8, 3.0, 1.6, 0.35};
constexpr double kPayload = 14.0;  // [kg]

// What a log of each state that is not ok says of itself.
constexpr std::array<std::array<const char*, 2>, 9> kTroubles = {{
    {"partial", "sway: no usable fit, the command moves in no stretch"},
    {"nothing_to_identify", "no DOF is excited for longer than 5 s"},
    {"no_model", "surge: the fit did not converge"},
    {"refused", "velocity.csv: the stamps go back 0.8 s at line 2044"},
    {"crashed", "fathom_identify: signal 11"},
    {"timed_out", "fathom_diagnose: stopped after 600 s"},
    {"out_of_memory", "fathom_identify: 2048 MB were not enough"},
    {"unreadable", "command.csv: column 'tau_surge' is missing"},
    {"duplicate", "the same data as dives/dive-003/log-1"},
}};

std::string DiveName(int dive) { return fmt::format("dive-{:03d}", dive + 1); }
std::string LogPath(int dive, int log) {
  return fmt::format("dives/{}/log-{}", DiveName(dive), log + 1);
}

// The place of the first dive with the payload.
int FirstWithPayload(int num_dives) { return 2 * num_dives / 5; }

double Truth(int dof, int parameter, int dive, int num_dives) {
  const double growth = static_cast<double>(dive) / num_dives;
  switch (parameter) {
    case kInertia:
      return 96.0 + 22.0 * dof + (dive >= FirstWithPayload(num_dives) ? kPayload : 0.0);
    case kQuadraticDamping:
      return 120.0 + 35.0 * dof + (dof == 0 ? 40.0 * growth : 0.0);
    case kLinearDamping:
      return 18.0 + 4.0 * dof;
    default:
      return dof == 2 ? -6.0 : 0.4;
  }
}

void AddDiveFits(int num_dives, std::mt19937* generator, ArchiveReport* report) {
  std::normal_distribution<double> normal;
  for (int dive = 0; dive < num_dives; ++dive) {
    for (int dof = 0; dof < 3; ++dof) {
      for (int parameter = 0; parameter < kNumParameters; ++parameter) {
        DiveFitRow row;
        row.dive = DiveName(dive);
        row.dof = kDofs[dof];
        row.parameter = kParameterInfo[parameter].name;
        row.unit = kUnits[parameter];
        row.vehicle = "pool_rov";
        row.logs = 4;
        row.usable = dive != 6;
        if (!row.usable) row.message = "no stretch is excited";
        row.std = kStds[parameter] * (0.8 + 0.1 * (dive % 5));
        row.value = Truth(dof, parameter, dive, num_dives) + row.std * normal(*generator);
        if (dive == 17 && dof == 0 && parameter == kInertia) row.value += 22.0;      // the outlier
        if (dive == 9 && dof == 1 && parameter == kInertia) row.value = 4.0e5;       // diverged
        if (dive == 13 && dof == 2 && parameter == kLinearDamping) row.std = 900.0;  // not known
        report->tables.dive_fits.push_back(row);
      }
    }
  }
  report->tables.outliers = {{DiveName(17), "surge", "inertia", "pool_rov"}};
}

ChangeRow ChangeOf(const char* dof, const char* parameter, const char* kind, const char* cause) {
  ChangeRow row;
  row.dof = dof;
  row.parameter = parameter;
  row.kind = kind;
  row.cause = cause;
  row.vehicle = "pool_rov";
  return row;
}

void AddChanges(int num_dives, ArchiveReport* report) {
  const std::string payload = DiveName(FirstWithPayload(num_dives));
  for (int dof = 0; dof < 3; ++dof) {
    ChangeRow step = ChangeOf(kDofs[dof], "inertia", "step", "payload");
    step.at = payload;
    step.before = Truth(dof, kInertia, 0, num_dives);
    step.after = step.before + kPayload;
    step.text = fmt::format(
        "From {} on the vehicle is 14 kg heavier (± 2) in surge, sway and heave: payload.",
        payload);
    step.p_value = 0.002;
    report->tables.changes.push_back(step);
  }
  ChangeRow growth = ChangeOf("surge", "quadratic_damping", "trend", "fouling");
  growth.at = DiveName(0);
  growth.before = 120.0;
  growth.after = 160.0;
  growth.text =
      fmt::format("From {} to {} the quadratic damping of surge grows by 33 % (± 4): fouling.",
                  DiveName(0),
                  DiveName(num_dives - 1));
  growth.p_value = 0.004;
  report->tables.changes.push_back(growth);
}

// A verdict, and causes where it names one. Every fifth dive was not diagnosed.
void AddDiagnosis(
    int dive, const std::string& log, const char* dof, unsigned draw, ArchiveReport* report) {
  if (dive % 5 == 4) return;
  VerdictRow verdict{log, dof, "consistent", "Nothing beyond noise.", "{}"};
  const auto name = [&](const char* effect, const char* parameter) {
    verdict.verdict = "explained";
    report->tables.causes.push_back({log, dof, effect, parameter, 3.0, 0.3, "N"});
  };
  if (dive > 19 && draw % 4 != 0) {
    name("thrust_dead_zone", "width");
    name("thrust_dead_zone", "slope");
  } else if (draw % 11 == 0) {
    name("time_offset", "offset");
  } else if (draw % 13 == 0) {
    verdict.verdict = "ambiguous";
  } else if (draw % 17 == 0) {
    verdict.verdict = "unexplained";
  }
  report->tables.verdicts.push_back(verdict);
  report->pages[{log, dof}] = fmt::format("diagnoses/{}/{}.html", log, dof);
}

void AddModel(int dive, const std::string& log, std::mt19937* generator, ArchiveReport* report) {
  Tables& tables = report->tables;
  for (const char* dof : kDofs) {
    std::uniform_real_distribution<double> error(0.04, 0.12);
    const double nmae = error(*generator) * (dive == 17 ? 4.0 : 1.0);
    tables.fits.push_back(
        {log, dof, "output_error", "velocity", true, "inertia", 96.0, 2.0, "kg", ""});
    tables.scores.push_back({log, dof, "output_error", "velocity", 0.01, 0.9 * nmae, 0.012, nmae});
    tables.scores.push_back({log, dof, "adaptive", "velocity", 0.02, nmae, 0.03, 2.0 * nmae});
    if (dive > 0) tables.predictions.push_back({DiveName(dive - 1), log, dof, 1.3 * nmae});
    AddDiagnosis(dive, log, dof, (*generator)(), report);
  }
}

void AddLogs(const ExampleArchiveOptions& options, std::mt19937* generator, ArchiveReport* report) {
  for (int dive = 0; dive < options.num_dives; ++dive) {
    for (int log = 0; log < options.logs_per_dive; ++log) {
      LogRow row;
      row.path = LogPath(dive, log);
      row.dive = DiveName(dive);
      row.start = fmt::format("{}-{:02d}-{:02d}T0{}:15:00Z",
                              2021 + dive / 336,
                              dive / 28 % 12 + 1,
                              dive % 28 + 1,
                              log % 10);
      row.duration = 240.0;
      row.status = "ok";
      row.vehicle = "pool_rov";
      const int trouble = dive - 5;
      if (log == 0 && trouble >= 0 && trouble % 40 < static_cast<int>(kTroubles.size())) {
        row.status = kTroubles[trouble % 40][0];
        row.message = kTroubles[trouble % 40][1];
      }
      if (log == 1 && dive == 8) {
        row.status = "refused";
        row.message = kTroubles[3][1];
      }
      report->tables.logs.push_back(row);
      if (row.status == "refused") {
        report->tables.findings.push_back(
            {row.path, "surge", "red", "stamps", "The stamps go back by 0.8 s at 204.4 s."});
      } else if ((dive + log) % 9 == 0) {
        report->tables.findings.push_back(
            {row.path,
             "sway",
             "yellow",
             "saturation",
             "The command stands at its limit for 31 % of the time."});
      }
      if (row.status == "ok" || row.status == "partial")
        AddModel(dive, row.path, generator, report);
    }
  }
}

}  // namespace

ArchiveReport ExampleArchive(const ExampleArchiveOptions& options) {
  ArchiveReport report;
  report.archive = "/data/pool_rov/2021-2026";
  report.origin = {
      "Fathom 0.1.0",
      "2026-11-24T06:12:00Z",
      "fathom_batch --archive=/data/pool_rov/2021-2026 --results=results --jobs=8 --diagnose",
      {}};
  report.other_files = {{".mp4", 12}, {".txt", 3}, {"", 1}};
  for (int dive = 0; dive < options.num_dives; ++dive) report.dives.push_back(DiveName(dive));
  std::mt19937 generator(1);
  AddDiveFits(options.num_dives, &generator, &report);
  AddChanges(options.num_dives, &report);
  AddLogs(options, &generator, &report);
  return report;
}

}  // namespace fathom
