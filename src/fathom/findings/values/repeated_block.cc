// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/repeated_block.h"

#include "fathom/base/median.h"
#include "fathom/findings/values/large_jump.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr std::size_t kBlockWindow =
    50;  // a block of twice as many rows holds a window from the grid

// A hash of the values in a window, which moves on by one value at a time (Karp and Rabin 1987).
class RollingHash {
 public:
  explicit RollingHash(std::span<const double> window) {
    for (std::size_t i = 0; i + 1 < window.size(); ++i) highest_ *= kBase;
    for (const double value : window) hash_ = hash_ * kBase + BitsOf(value);
  }

  void Move(double out, double in) {
    hash_ = (hash_ - BitsOf(out) * highest_) * kBase + BitsOf(in);
  }

  std::uint64_t value() const { return hash_; }

 private:
  static constexpr std::uint64_t kBase = 0x9E3779B97F4A7C15;  // odd

  static std::uint64_t BitsOf(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return bits ^ (bits >> 29);
  }

  std::uint64_t hash_ = 0;
  std::uint64_t highest_ = 1;
};

bool IsVaried(std::span<const double> window) {
  std::vector<double> values(window.begin(), window.end());
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return 2 * values.size() >= window.size();
}

// The block around two equal windows.
RepeatedBlock Grown(std::span<const double> values, std::size_t first, std::size_t second) {
  std::size_t end = first + kBlockWindow;
  const std::size_t shift = second - first;
  while (first > 0 && values[first - 1] == values[first - 1 + shift]) --first;
  while (end + shift < values.size() && values[end] == values[end + shift]) ++end;
  return {.first = first, .second = first + shift, .num_rows = end - first};
}

// Whether the steps from row to row differ from each other by about as much as they are.
bool HasNoise(std::span<const double> values) {
  constexpr double kNoisy = 0.3;  // 1.7 for noise alone, next to 0 for a smooth motion
  std::vector<double> steps, bends;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    steps.push_back(std::abs(values[i + 1] - values[i]));
    bends.push_back(std::abs(values[i + 1] - 2.0 * values[i] + values[i - 1]));
  }
  return Median(std::move(bends)) > kNoisy * Median(std::move(steps));
}

// Whether the second place of a block begins or ends with a jump.
bool HasSeam(std::span<const double> values, const RepeatedBlock& block) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] != values[i - 1]) steps.push_back(std::abs(values[i] - values[i - 1]));
  }
  const double far = LargeJump(std::move(steps));
  const std::size_t end = block.second + block.num_rows;
  const bool jumps_in =
      block.second > 0 && std::abs(values[block.second] - values[block.second - 1]) > far;
  return jumps_in || (end < values.size() && std::abs(values[end] - values[end - 1]) > far);
}

}  // namespace

std::optional<RepeatedBlock> FindRepeatedBlock(std::span<const double> values) {
  if (values.size() < 2 * kBlockWindow) return std::nullopt;
  RepeatedBlock longest;
  std::unordered_map<std::uint64_t, std::size_t> seen;  // windows at multiples of kBlockWindow
  RollingHash hash(values.first(kBlockWindow));
  for (std::size_t at = 0;; ++at) {
    const auto window = values.subspan(at, kBlockWindow);
    const auto found = seen.find(hash.value());
    if (found == seen.end()) {
      if (at % kBlockWindow == 0) seen.emplace(hash.value(), at);
    } else if (std::ranges::equal(window, values.subspan(found->second, kBlockWindow)) &&
               IsVaried(window)) {
      const RepeatedBlock block = Grown(values, found->second, at);
      if (block.num_rows > longest.num_rows) longest = block;
      // All of the block is known now: goes on behind it.
      const std::size_t next = std::max(at + 1, block.second + block.num_rows - kBlockWindow + 1);
      if (next + kBlockWindow > values.size()) break;
      at = next - 1;
      hash = RollingHash(values.subspan(at, kBlockWindow));
    }
    if (at + kBlockWindow >= values.size()) break;
    hash.Move(values[at], values[at + kBlockWindow]);
  }
  if (longest.num_rows < 2 * kBlockWindow) return std::nullopt;
  if (!HasNoise(values) && !HasSeam(values, longest)) return std::nullopt;
  return longest;
}

}  // namespace fathom
