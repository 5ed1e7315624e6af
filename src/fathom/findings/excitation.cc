// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/excitation.h"

#include "fathom/log/proposed_held_out.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace fathom {
namespace {

constexpr double kBlock = 5.0;      // [s]
constexpr double kLeastSpan = 0.2;  // of the whole log's
constexpr double kFewest = 40.0;    // excited [s], to hold something out

struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void Take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void Take(const Span& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  double Size() const { return high > low ? high - low : 0.0; }
};

struct Block {
  TimeInterval time;
  Span force, velocity;
  bool is_excited = false;
};

double UsualSpan(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::ceil(0.99 * last))] -
         values[static_cast<std::size_t>(std::floor(0.01 * last))];
}

std::vector<Block> BlocksOf(const Segment& segment, const std::vector<double>& force) {
  std::vector<Block> blocks;
  const double duration = segment.time.back() - segment.time.front();
  const auto count = std::max(1, static_cast<int>(duration / kBlock));
  const double size = duration / count;
  for (int k = 0; k < count; ++k) {
    const double from = segment.time.front() + k * size;
    blocks.push_back({{from, from + size}, {}, {}, false});
  }
  for (std::size_t i = 0; i < segment.time.size(); ++i) {
    const double place = size > 0.0 ? (segment.time[i] - segment.time.front()) / size : 0.0;
    Block& block = blocks[std::min(static_cast<std::size_t>(place), blocks.size() - 1)];
    block.force.Take(force[i]);
    block.velocity.Take(segment.velocity[i]);
  }
  return blocks;
}

}  // namespace

Excitation ExcitationOf(const HeldCommand& command, std::span<const Segment> segments) {
  Excitation excitation;
  std::vector<std::vector<double>> forces;
  std::vector<double> all_forces, all_velocities;
  for (const Segment& segment : segments) {
    forces.push_back(command.At(segment.time));
    all_forces.insert(all_forces.end(), forces.back().begin(), forces.back().end());
    all_velocities.insert(all_velocities.end(), segment.velocity.begin(), segment.velocity.end());
    excitation.duration += segment.time.back() - segment.time.front();
  }
  const double least_force = kLeastSpan * UsualSpan(all_forces);
  const double least_velocity = kLeastSpan * UsualSpan(all_velocities);
  if (!(least_force > 0.0) || !(least_velocity > 0.0)) return excitation;

  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::vector<Block> blocks = BlocksOf(segments[s], forces[s]);
    bool goes_on = false;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      Span force = blocks[k].force, velocity = blocks[k].velocity;
      for (const std::size_t beside : {k - 1, k + 1}) {
        if (beside >= blocks.size()) continue;
        force.Take(blocks[beside].force);
        velocity.Take(blocks[beside].velocity);
      }
      const bool is_excited = force.Size() >= least_force && velocity.Size() >= least_velocity;
      if (is_excited) {
        excitation.excited += blocks[k].time.to - blocks[k].time.from;
        if (goes_on) {
          excitation.stretches.back().to = blocks[k].time.to;
        } else {
          excitation.stretches.push_back(blocks[k].time);
        }
      }
      goes_on = is_excited;
    }
  }
  if (excitation.excited < kFewest) return excitation;
  excitation.held_out = ProposedHeldOut(excitation.stretches);
  return excitation;
}

}  // namespace fathom
