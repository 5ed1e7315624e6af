// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// The thresholds of a verdict, all of them. Gains and losses are shares of the error of free runs
// on data that no fit has seen, unless it says so; docs/diagnosis.md, "Verdict".
struct VerdictRules {
  // What is left, of all structure [share of the log-likelihood's gain], below which it is no
  // matter.
  double material_rest = 0.05;

  // What is left behind causes that would be certain, and follows one input alone, is no chance
  // [p-value]: they only have a shape like what is there.
  double clear_rest_of_one_input = 0.002;
  double material_rest_of_one_input = 0.1;  // as material_rest

  // Of the work that a search may take: what it gets before it is known whether more is worth it.
  double share_of_work_at_first = 0.2;

  // RMS error of a free run over what scatters from sample to sample [1], above which the noise may
  // have taken up what is missing.
  double more_than_scatter = 2.0;

  // A cause refuses itself where it loses so much, however wide the interval of the loss is.
  double loss_too_much = 0.05;

  // The same of the error in training [share of NMAE].
  double loss_too_much_in_training = 0.1;

  // Losses in the displacements that say nothing, as a jump of the poses before the held-out data
  // leaves; and in the velocities, of a cause that acts on poses alone.
  double trace_in_poses = 0.01;
  double trace_in_velocities = 0.005;

  // A gain in the poses that outweighs a loss in the velocities, for certain.
  double material_gain_in_poses = 0.05;

  // Of several logs, each of which gains: what is less is a trace.
  double least_gain_of_each_log = 0.01;

  // A rung of the ladder of free runs is climbed for such a gain, for certain; where the blocks are
  // too few for an interval, for the second.
  double material_gain = 0.05;
  double material_gain_without_interval = 0.2;
};

}  // namespace fathom
