// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// The public tables of an archive's results, a struct per row with the columns in their order;
// docs/archive.md. Texts that do not apply are empty, numbers that are not known NaN (NULL in the
// database).

inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// One log, or what looks like one.
struct LogRow {
  std::string path;  // from the archive on
  std::string dive;
  std::string start;            // ISO 8601, UTC
  double duration = kNoNumber;  // [s]
  std::string content;          // hash of every byte that decides what comes out
  std::string status;           // Name(LogState)
  std::string message;          // why it is not ok
  double seconds = kNoNumber;   // that its programs took
  double peak_mb = kNoNumber;   // most memory that one of them held
  std::string version;          // of Fathom
  std::string vehicle;          // as log.yaml or archive.yaml names it

  bool operator==(const LogRow&) const = default;
};

// FitRow::family of a coupled model: `dof` then names several, "surge,sway,yaw", and `source` the
// structure that the data show. One without a usable fit has a row without a parameter.
inline constexpr std::string_view kCoupledFamily = "coupled";

// One parameter as one family gave it for one log.
struct FitRow {
  std::string log, dof, family, source;
  bool usable = false;
  std::string parameter;
  double value = kNoNumber;
  double std = kNoNumber;
  std::string unit, message;
};

// One parameter of the joint fit of all logs of a dive by output error: what trends are made of.
struct DiveFitRow {
  std::string dive, dof;
  bool usable = false;
  std::string parameter;
  double value = kNoNumber;
  double std = kNoNumber;
  std::string unit;
  int logs = 0;         // in the fit
  std::string message;  // why it is not usable, which logs were left out and why
  std::string vehicle;
};

// How well a model of a log simulates it, in training and on held-out data.
struct ScoreRow {
  std::string log, dof, family, source;
  double mae = kNoNumber;  // [m/s] or [rad/s]
  double nmae = kNoNumber;
  double heldout_mae = kNoNumber;
  double heldout_nmae = kNoNumber;
};

// What fathom_diagnose said of a log.
struct VerdictRow {
  std::string log, dof, verdict, sentence;
  std::string json;  // the verdict file, verbatim
};

// One parameter of one cause that a verdict names. `effect` and its figures repeat with each.
struct CauseRow {
  std::string log, dof, effect, parameter;
  double value = kNoNumber;
  double std = kNoNumber;
  std::string unit;
  double p_value = kNoNumber;
  double heldout_gain = kNoNumber;
};

// FindingRow::id of a DOF that moves, and that --dofs=auto leaves out of the coupled model.
inline constexpr std::string_view kLeftOutOfCoupled = "left_out_of_coupled";

// What the checks of the data found before any fit.
struct FindingRow {
  std::string log, dof;
  std::string severity;  // "red" or "yellow"
  std::string id, text;
};

// How well the model of one dive predicts a log of the next dive.
struct PredictionRow {
  std::string model_log;  // the dive that the model is of
  std::string log, dof;
  double nmae = kNoNumber;
};

// A parameter that changed over the dives.
struct ChangeRow {
  std::string dof, parameter;
  std::string kind;           // "step" or "trend"
  std::string at;             // the first dive after it; of a trend, the first dive
  double before = kNoNumber;  // of a trend, at the first dive
  double after = kNoNumber;   // of a trend, at the last dive
  double before_std = kNoNumber;
  double after_std = kNoNumber;
  double p_value = kNoNumber;  // over the whole archive at once
  std::string cause, text;
  std::string vehicle;
};

// A dive whose parameter lies too far from those of the other dives.
struct OutlierRow {
  std::string dive, dof, parameter, vehicle;
};

struct Tables {
  std::vector<LogRow> logs;  // in the order of dives, then by path
  std::vector<FitRow> fits;
  std::vector<DiveFitRow> dive_fits;
  std::vector<ScoreRow> scores;
  std::vector<VerdictRow> verdicts;
  std::vector<CauseRow> causes;
  std::vector<FindingRow> findings;
  std::vector<PredictionRow> predictions;
  std::vector<ChangeRow> changes;
  std::vector<OutlierRow> outliers;
};

}  // namespace fathom
