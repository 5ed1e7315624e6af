// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/advice.h"

#include <algorithm>
#include <iterator>

namespace fathom {
namespace {

struct Entry {
  std::string_view code;
  Advice advice;
};

// By code.
constexpr Entry kAdvice[] = {
    {"arrival_stamps",
     {"A sample is told to lie where it arrived: inertia and a delay come out too large, and "
      "speeds "
      "from poses are wrong.",
      "Log the sensor's own stamps, or give the map its `rate` in place of the stamps."}},
    {"camera_delay",
     {"Models from the two sources differ in their dynamics, and in a fit of both each spoils the "
      "other.",
      "Put the clocks together: take the stamps of the exposure, not of the arrival of the image, "
      "or shift those of detections.csv by this delay."}},
    {"clipped_command",
     {"Nothing, if the thrusters got the same limit. If they got more, damping comes out too "
      "small.",
      "Check that command.csv holds what was sent to the thrusters, after all limits."}},
    {"closed_loop",
     {"Noise of the speed gets into the command. Least squares and the adaptive law become biased; "
      "output error does not.",
      "Take output error. Drive open loop, or add steps to the controller's set point."}},
    {"command_delay",
     {"Inertia and damping take the delay for dynamics: both come out wrong.",
      "Put the clocks together: `delay` in the map of fathom_import, or shift the stamps of one "
      "file. "
      "fathom_diagnose measures it as `time_offset`."}},
    {"constant_command",
     {"There is no model: nothing tells inertia from damping.",
      "Drive steps of several sizes, or fit this log together with others."}},
    {"constant_velocity",
     {"There is no model.",
      "Check that the column is the vehicle's motion, and that it was moving."}},
    {"few_changes",
     {"One or two parameters are known, the others are not.",
      "Drive steps of several sizes, forwards and back."}},
    {"force_sign",
     {"Inertia comes out negative, or as nonsense.",
      "Turn the sign of the command or of the motion around. Check that the column is a speed and "
      "no "
      "acceleration."}},
    {"fin_angle",
     {"No model of several DOFs: such a log is refused.",
      "Divide the angles by 57.296, or import the log with the unit `deg`."}},
    {"free_decay",
     {"Only ratios to the inertia come of it, but no error of a command is in them.",
      "Give `inertia` in the vehicle file for the parameters themselves: docs/free_decay.md."}},
    {"gap",
     {"Little: a fit runs through it by the command alone. One of over 30 s cuts the log into "
      "pieces; in a model of several DOFs, one of over 2 s does.",
      "Find out why the sensor paused."}},
    {"heavy",
     {"None, if the vehicle is flat or floods. Otherwise all parameters are too large by one "
      "factor.",
      "Check `mass`, and the units of command and motion. A vehicle file with `size` says how flat "
      "the vehicle is."}},
    {"held_samples",
     {"The motion comes late, by half the interval on average, and noise seems to be small.",
      "Export the sensor at its own rate."}},
    {"inertia",
     {"All parameters are wrong by one factor, or by several.",
      "Check the units of command and motion, and `mass` in log.yaml or the vehicle file."}},
    {"jitter",
     {"Little, if the stamps are right. If they are times of arrival, speeds from poses get noise.",
      "Take the sensor's own stamps."}},
    {"lost_values",
     {"The zeros are taken for motion: inertia grows, and effects are named that do not exist.",
      "Take the rows without a reading out of the file that is named."}},
    {"lever_arm",
     {"Each turn adds to these velocities: sway and yaw seem to be coupled, surge and pitch too.",
      "Move velocity.csv to the point of pose.csv (minus the rates times this arm), or take the "
      "poses alone."}},
    {"mass",
     {"None of its own, but units are checked by the mass: a wrong one hides a wrong unit, or "
      "names "
      "one that is right.",
      "Weigh the vehicle. Mend `mass` in log.yaml, or leave it out: then the vehicle file's "
      "counts."}},
    {"mounting_angle",
     {"A part of surge is taken for sway: couplings are named that do not exist.",
      "Turn u and v by this angle, or take the poses alone. If the sensor sits straight, the axes "
      "of pose.csv are turned."}},
    {"no_model",
     {"This log alone gives none.",
      "Drive what the sentence asks for. If it asks for nothing, look for a wrong sign, clock or "
      "unit "
      "of command and motion first, then for too little motion. Or fit several logs together."}},
    {"other_axes",
     {"Inertia and damping take a part of the other axes' force: they are biased by more than "
      "their intervals say.",
      "Drive one axis at a time, or take the axes as one motion: --dofs of fathom_identify fits "
      "it, --dofs of fathom_diagnose looks for what it lacks."}},
    {"passivity",
     {"Damping comes out negative.",
      "Check sign and frame of command and motion (FLU or FRD), the allocation of the thrusters, "
      "and "
      "both clocks."}},
    {"poor_fit",
     {"It predicts badly, and its intervals do not cover what it lacks.",
      "Mend what is red. Then run fathom_diagnose on this log: it looks for what the model "
      "lacks."}},
    {"pose_flip",
     {"Speeds from these poses are wrong there, and a heading that is unwrapped through it gains a "
      "turn.",
      "Leave these rows of pose.csv out."}},
    {"pose_jump",
     {"The speed from the poses has a peak there, which no thrust explains.",
      "Of one jump or two: cut the log there, or take the poses of an estimator that is not "
      "realigned. Of more: take the rows without tracking out of pose.csv. Of markers: check their "
      "places."}},
    {"pose_twist_apart",
     {"One of the two is not the motion of this axis.",
      "Check which column is which axis, in both files."}},
    {"pose_twist_delay",
     {"Models from the two sources differ in their dynamics.",
      "Put the clocks of both sensors together. A late column of velocity.csv is read off later "
      "with `late: {COLUMN: 0.25}` in log.yaml, or --correct=COLUMN:0.25s, in seconds."}},
    {"pose_twist_frame",
     {"A vehicle that turns gets the velocity of another axis.",
      "Turn velocity.csv by the attitude in pose.csv into the axes of the vehicle, or leave it "
      "out: "
      "the poses suffice."}},
    {"pose_twist_scale",
     {"Models from the two sources differ by this factor.",
      "Check the units of both, and the size of the markers."}},
    {"pose_twist_sign",
     {"One of the two gives a model of the wrong sign.",
      "Turn the axis around: FLU or FRD, ENU or NED. Where velocity.csv is the wrong one: "
      "`correct: {COLUMN: -1}` in log.yaml, or --correct=COLUMN:-1."}},
    {"pulse_widths",
     {"The buoyancy takes the 1500 us of a stopped thruster in, and the other parameters have no "
      "unit.",
      "Import the log with a vehicle file that holds the thrust of each pulse width "
      "(docs/import.md), or subtract 1500 and name the unit: `command_unit: us` in log.yaml."}},
    {"repeated_block",
     {"The same data count twice: intervals are too narrow, and a jump is in the motion.",
      "Take one of the two out."}},
    {"row_counter",
     {"Inertia and damping are wrong by the number of rows in a second.",
      "Say how many there are: `rate` in each stream of the map of fathom_import, or `time` where "
      "another field holds the stamps."}},
    {"sampling_rate",
     {"The fit is slow, or sees nothing of the dynamics.", "Check the unit of `t`."}},
    {"scaled_decay",
     {"The parameters are wrong by the factor by which the inertia of the vehicle file is. No "
      "error "
      "of a command is in them.",
      "Fit them: fathom_identify takes the inertia as it stands."}},
    {"sentinel",
     {"Single rows decide the model.", "Take the rows without a reading out of the file."}},
    {"short_log",
     {"Intervals are wide.", "Drive for two minutes or more, or fit several logs together."}},
    {"speed_range", {"All parameters are wrong.", "Check the unit of the speed: m/s and rad/s."}},
    {"stamp_order",
     {"Rows stand at wrong times: order does not mend stamps that are wrong.",
      "Look at how the stamps are written. Where whole seconds and nanoseconds stand in columns of "
      "their own, the map of fathom_import takes them: `time: {seconds: S, nanoseconds: N}`."}},
    {"stuck_values",
     {"A model that stands still is fitted to a vehicle that moves.",
      "Take these rows out of the file."}},
    {"swapped_axes", {"There is no model, or one of noise.", "Change the two columns over."}},
    {"unsigned_command",
     {"There is no model, or one of noise.",
      "Give the command its sign: log what the controller asked for, or a direction beside it."}},
    {"unsigned_speed",
     {"There is no model, or one of noise.",
      "Take the component along the axis, not the speed over ground or through the water."}},
};

}  // namespace

Advice AdviceOn(std::string_view code) {
  const auto* const found = std::find_if(std::begin(kAdvice),
                                         std::end(kAdvice),
                                         [&](const Entry& entry) { return entry.code == code; });
  return found == std::end(kAdvice) ? Advice{} : found->advice;
}

std::string RemedyOf(const Finding& finding) {
  constexpr std::string_view kPlace = "COLUMN";
  std::string remedy(AdviceOn(finding.code).remedy);
  if (!finding.where) return remedy;
  for (auto at = remedy.find(kPlace); at != std::string::npos; at = remedy.find(kPlace)) {
    remedy.replace(at, kPlace.size(), finding.where->axis);
  }
  return remedy;
}

}  // namespace fathom
