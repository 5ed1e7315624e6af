// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/noise/noise_model.h"
#include "fathom/signal/signals.h"
#include "fathom/simulate/effect_simulation.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// One unbroken stretch of a log along one DOF: what drove it and what was measured of it.
struct Record {
  std::string log;  // its name, which no other of the logs has
  bool is_held_out = false;
  std::shared_ptr<const EffectInputs> inputs;  // of the whole log
  OutputStamps stamps;
  std::vector<double> velocity;      // at stamps.velocity [m/s] or [rad/s]
  std::vector<double> displacement;  // at stamps.displacement [m] or [rad]
  InitialState initial;              // guessed from the first samples

  double duration() const;
};

struct Records {
  std::vector<Record> all;
  std::vector<std::string> logs;  // their names, each told from the others, in their order
  std::string force_unit;
  bool has_velocity = true;
  bool has_displacement = false;
  std::vector<Dof> partners;  // other DOFs whose velocity is measured in every log
  std::vector<std::string> remarks;
};

// Velocities where every log has them, displacements from poses where every log has them and the
// DOF's axis keeps its direction. Segments at silences of over 30 s and at the ends of held-out
// intervals.
//
// Throws InputError if a log has no command or no motion of this DOF, if their command units
// differ, or if nothing is left to train on.
Records RecordsOf(std::span<const Log> logs, Dof dof);

// Lets the record start at `time`, one of its stamps or before them, its state guessed anew from
// the samples from there on.
void RestartAt(double time, Record* record);

// The record as the families' segment: velocities, or the derivative of the displacements.
Segment SegmentOfRecord(const Record& record);

// Samples averaged over short bins, so that what follows costs little: a row for each bin.
class Bins {
 public:
  // Bins no shorter than 0.2 s, and longer on long records (up to 0.5 s); never across a gap.
  explicit Bins(std::span<const Record> records);

  int size() const { return static_cast<int>(samples_.size()); }
  const std::vector<NoiseSample>& samples() const { return samples_; }

  // Rows of record `index`: from first_row(index) up to first_row(index + 1).
  int first_row(std::size_t index) const { return first_rows_[index]; }

  // Means over the bins of record `index` of something sampled at its stamps; `to` has the record's
  // rows. For a matrix: column by column, into the given columns.
  void Average(std::size_t index,
               const std::vector<double>& velocity,
               const std::vector<double>& displacement,
               std::span<double> to) const;
  void Average(std::size_t index,
               const SensitivityMatrix& velocity,
               const SensitivityMatrix& displacement,
               Eigen::Ref<SensitivityMatrix> to) const;

 private:
  struct Bin {
    NoiseChannel channel;
    std::size_t begin, end;  // of the channel's samples
  };
  std::vector<Bin> bins_;
  std::vector<NoiseSample> samples_;
  std::vector<int> first_rows_;
};

}  // namespace fathom
