// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/findings/finding.h"
#include "fathom/findings/verdict.h"
#include "fathom/log/held_command.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A model of the training data.
struct DiagnosedModel {
  static constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

  ExtendedModel model;

  // Of the baseline's parameters in the order of kParameterInfo, then the effects' in theirs.
  Eigen::MatrixXd covariance;

  FitFigures train;     // of free runs
  FitFigures held_out;  // on data that no fit has seen; where every block was left out in turn,
                        // over the blocks

  // Of the fit by which causes are weighed, generalised least squares with the noise learned along.
  // That is the extended model's own; the baseline, which is output error's, has another.
  double weighed_log_likelihood = kNotComputed;
};

// What became of a candidate.
enum class CandidateOutcome {
  kKept,
  kKeptBesideOthers,  // too weak alone, needed beside the other kept ones
  kAlternative,       // these logs cannot tell it from a kept one
  kFitFailed,
  kScoreWithinNoise,
  kOthersScoreHigher,  // so it was not refitted
  kGainWithinNoise,
  kNeedless,             // helps alone, adds nothing once the kept ones are in
  kRefused,              // nothing is kept: free runs do not improve by it
  kNoBetterThanRefused,  // the same: it is worth no more than what they refused
  kTakenUpByNoise,       // the same: the noise learned without it takes it up
};

// One effect (with its partner, if it has one, and its log, if it belongs to one of several) that
// was tried.
struct Candidate {
  const Effect* effect = nullptr;
  EffectSetting setting;
  std::string label;  // "thruster_lag", "velocity_coupling(sway)"

  std::vector<double> values;  // as fitted on top of the baseline alone; empty: not refitted
  std::vector<double> stds;
  double score = 0.0;  // twice the log-likelihood gained over the baseline, by the linear screen
  double gain = 0.0;   // the same after refitting, the noise learned along; NaN: not refitted
  double delta_bic = 0.0;  // of that gain; above 0: better than the baseline
  // Of as much gain (score where not refitted) anywhere among all candidates, if nothing is
  // missing.
  double p_value = 1.0;
  double noise_reach = 0.0;  // the gain that noise alone reaches in 5 % of cases
  CandidateOutcome outcome = CandidateOutcome::kScoreWithinNoise;

  bool IsKept() const {
    return outcome == CandidateOutcome::kKept || outcome == CandidateOutcome::kKeptBesideOthers;
  }
};

// What logs cannot tell from a cause.
struct Alternative {
  const Effect* effect = nullptr;
  EffectSetting setting;
  std::string label;  // as Candidate's
};

// The experiment that would tell a cause from its alternatives.
struct DecidingRun {
  std::string text;     // a sentence; empty if there are no alternatives
  bool decides = true;  // false: none of this kind can, and the text says what could
};

// A thruster that pushes less along the DOF than its place and direction in the vehicle file say.
struct WeakThruster {
  std::string name;
  double change = 0.0;  // of what it gives along the DOF, as a share: -1 for nothing left
  double std = 0.0;
};

// A cause that the data call for.
struct Cause {
  int effect_index = 0;  // in Diagnosis::extended.model.effects
  double p_value = 1.0;
  double delta_bic = 0.0;      // lost when this cause alone is taken out again
  double held_out_gain = 0.0;  // 1 - NMAE with / NMAE without it
  std::vector<Alternative> alternatives;
  DecidingRun experiment;
  std::optional<WeakThruster> thruster = {};  // what a crosstalk comes down to
};

// What the logs leave room for of an effect that is not named.
struct ExclusionLimit {
  const Effect* effect = nullptr;  // of one parameter
  EffectSetting setting;
  std::string label;  // as Candidate's

  // False where the logs could not have shown the effect at any size that was tried; `low` and
  // `high` then mean nothing.
  bool is_told = false;

  // The parameter's values that are not 95 % excluded.
  double low = 0.0, high = 0.0;
};

// What fits best but is not named.
struct NotNamed {
  std::string label;  // of one effect or of several together
  std::string why;    // a clause: "the error on held-out data grows by 12 %"
};

// What the baseline's free run misses, as a force in time; with its standard deviation. Where there
// is no baseline, the same of the extended model.
struct MissingForce {
  std::vector<double> time;       // log time [s]
  std::vector<double> mean;       // [N] or [N m]
  std::vector<double> std;        // [N] or [N m]
  std::vector<double> explained;  // the part that the named causes account for
  // What it may depend on, at the same times; simulated, but for the displacement where that is
  // measured.
  std::vector<double> command, command_rate, velocity, displacement;
  std::vector<std::vector<double>> partner_velocities;  // one per entry of partner_names
  std::vector<std::string> partner_names;               // "sway"
};

// Residuals of one segment of the training data at the velocity's stamps (the displacement's where
// there is no velocity).
struct ResidualTrace {
  std::string log;
  std::vector<double> time;      // log time [s]
  std::vector<double> measured;  // [m/s] or [rad/s]; displacement [m] or [rad]
  std::vector<double> before;    // baseline's free run
  std::vector<double> after;     // extended model's free run
  bool is_held_out = false;
  HeldCommand command = {};  // meanwhile, as logged
};

// A cause of a time of its own, such as a step, where a free function of what the vehicle did
// explains the data as well: that it happened just then may be chance.
struct Coincidence {
  std::string label;  // of the cause
  std::string input;  // of the function: "displacement"
};

struct Diagnosis {
  Dof dof = Dof::kSurge;
  std::string force_unit;
  std::vector<std::string>
      logs;  // their names, told apart by their folders where they are the same
  bool fits_displacement = false;  // poses were used too, or alone
  bool has_velocity = true;
  std::optional<DataRange> range;  // of the training data

  // What the checks of every program say of the data, and of the inertia; warnings first.
  std::vector<Finding> findings;

  // Why there is no diagnosis, and nothing below is filled in: no baseline model could be fitted,
  // or it leaves the inertia open and nothing that was found makes up for it.
  std::string message;
  bool IsUsable() const { return message.empty(); }

  Verdict verdict = Verdict::kConsistent;

  // False where no model without a cause fits these logs, but one with a cause does. Then all that
  // is of the baseline, or of a comparison with it, is NaN or empty.
  bool has_baseline = true;
  DiagnosedModel baseline;  // as fathom_identify gives it
  DiagnosedModel extended;  // the baseline again where nothing is named
  std::vector<Cause> causes;
  std::optional<NotNamed> not_named;   // where there are no causes and one was refused
  std::vector<Candidate> candidates;   // best first
  std::vector<ExclusionLimit> limits;  // of effects of one parameter that are not named

  // What share of the baseline's squared error beyond the scatter from sample to sample the causes
  // remove, 0 to 1, on data that no fit has seen: ExplainedShare(). NaN where there are no causes
  // or the share is not known.
  double explained_share = std::numeric_limits<double>::quiet_NaN();

  // The NMAE that the scatter of the measurement from sample to sample gives alone, on data that no
  // fit has seen: noise_floor.h.
  double noise_nmae = std::numeric_limits<double>::quiet_NaN();

  // RMS of the baseline's error over what of it scatters from sample to sample, where nothing is
  // named and the rest passes for noise that wanders; else 0.
  double wander_ratio = 0.0;

  // It is `unexplained` for the red findings alone: the model has no error beyond noise.
  bool is_only_red = false;

  // It is `unexplained` since the search was ended before it was through: the causes leave nothing,
  // but others that were not tried may do so too.
  bool is_only_cut = false;

  // Why it is `unexplained` where nothing else is left.
  std::optional<Coincidence> coincidence;

  // p-value of what is left with the causes in: structure that no effect of the catalogue has.
  double remaining_p_value = 1.0;

  // 1 - NMAE of the extended model / NMAE of the baseline on data that neither has seen, with its
  // 95 % interval over blocks; NaN where nothing was held out.
  double held_out_gain = 0.0;
  double held_out_gain_low = 0.0;
  double held_out_gain_high = 0.0;
  bool gain_is_in_poses = false;    // of causes that act on the poses alone: see Scored
  bool by_left_out_blocks = false;  // the logs hold nothing out: blocks were left out in turn
  bool by_left_out_logs = false;    // the same, and the blocks are whole logs
  std::size_t num_left_out_logs = 0, num_better_logs = 0;  // of them, and those that gain

  MissingForce missing_force;
  std::vector<ResidualTrace> traces;

  // Where a cause acts on the poses alone, or what is unexplained may, and velocities are measured
  // too: the same of the displacements, as PosesByBlock() has them [m] or [rad].
  std::vector<ResidualTrace> pose_traces;
  std::vector<std::string> remarks;  // what was dropped, counted; what could not be tried, and why

  // Whether there is a model without and one with causes.
  bool ComparesTwoModels() const { return has_baseline && !causes.empty(); }
};

// Whether causes are named that the unseen data do not confirm: their gain may be none.
bool AreUnconfirmed(const Diagnosis& diagnosis);

// Whether causes are named that make the prediction of unseen data worse.
bool AreContradicted(const Diagnosis& diagnosis);

// Why a diagnosis is of no use to anyone: its message; or nothing is missing from a baseline that
// leaves the inertia open, by fathom_identify's measure. Empty where it is of use.
std::string WhyOfNoUse(const Diagnosis& diagnosis);

}  // namespace fathom
