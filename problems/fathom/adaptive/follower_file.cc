// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/follower_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/trimmed.h"
#include "fathom/vehicle/files/json_value.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glog/logging.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using FollowerJson = nlohmann::ordered_json;

constexpr char kFollowerSchema[] = "fathom-follow-1";
constexpr double kMostFollowed = 1e15;  // samples: below it, a double counts exactly

// Count, mean and squares of a block, in this order.
constexpr std::size_t kNumbersOfBlock = 1 + 2 * kNumParameters;

std::array<double, 5> NumbersOf(const AdaptiveGains& gains) {
  return {gains.a_m, gains.lambda[0], gains.lambda[1], gains.lambda[2], gains.lambda[3]};
}

FollowerJson RowOf(const RecentScatter::Block& block) {
  FollowerJson row = {block.count};
  for (const double mean : block.mean) row.push_back(mean);
  for (const double square : block.squares) row.push_back(square);
  return row;
}

template <std::size_t kCount>
std::array<double, kCount> ReadNumbers(const JsonValue& json) {
  const std::vector<JsonValue> list = json.List();
  if (list.size() != kCount) {
    json.Fail(fmt::format("has {} entries, expected {}", list.size(), kCount));
  }
  std::array<double, kCount> numbers;
  for (std::size_t k = 0; k < kCount; ++k) numbers[k] = list[k].Number();
  return numbers;
}

long ReadCount(const JsonValue& json, double least) {
  const double count = json.Number();
  if (!(count >= least && count <= kMostFollowed && count == std::floor(count))) {
    json.Fail(fmt::format("is {}, expected a whole number from {} on", count, least));
  }
  return static_cast<long>(count);
}

RecentScatter::Block ReadBlock(const JsonValue& json) {
  const auto numbers = ReadNumbers<kNumbersOfBlock>(json);
  RecentScatter::Block block;
  block.count = ReadCount(json.List().front(), 1.0);
  for (int k = 0; k < kNumParameters; ++k) {
    block.mean[k] = numbers[1 + k];
    block.squares[k] = numbers[1 + kNumParameters + k];
    if (block.squares[k] < 0.0) json.Fail("holds a sum of squares below 0");
  }
  return block;
}

RecentScatter ReadScatter(const JsonValue& json, long num_samples) {
  json.RequireKeysOf({"block_size", "blocks"});
  const long block_size = ReadCount(json.Member("block_size"), 1.0);
  const JsonValue list = json.Member("blocks");
  std::vector<RecentScatter::Block> blocks;
  long count = 0;
  for (const JsonValue& row : list.List()) {
    if (!blocks.empty() && blocks.back().count != block_size) {
      list.Fail(fmt::format("holds a block of {} before the last one, expected {} in each",
                            blocks.back().count,
                            block_size));
    }
    blocks.push_back(ReadBlock(row));
    if (blocks.back().count > block_size) {
      row.Fail(fmt::format("counts {}, expected at most {}", blocks.back().count, block_size));
    }
    count += blocks.back().count;
    if (blocks.size() > RecentScatter::kMostBlocks) {
      list.Fail(fmt::format("has more than {} entries", RecentScatter::kMostBlocks));
    }
  }
  if (count != num_samples) {
    list.Fail(fmt::format(
        "counts {} samples in all, expected {} as num_samples says", count, num_samples));
  }
  return {block_size, std::move(blocks)};
}

AdaptiveState ReadState(const JsonValue& json) {
  AdaptiveState state;
  state.estimated_velocity = json.Member("estimated_velocity").Number();
  state.lumped = ReadNumbers<4>(json.Member("lumped"));
  state.t = json.Member("t").Number();
  state.force = json.Member("force").Number();
  state.velocity = json.Member("velocity").Number();
  state.num_samples = ReadCount(json.Member("num_samples"), 1.0);
  state.segment_started = true;
  return state;
}

void RequireSameOptions(const JsonValue& json, Dof dof, const AdaptiveOptions& options) {
  if (json.Member("dof").Text() != Name(dof)) {
    json.Member("dof").Fail(
        fmt::format("is {}, expected {} as --dof says", json.Member("dof").Text(), Name(dof)));
  }
  const std::string integrator(Name(options.integrator));
  if (json.Member("integrator").Text() != integrator) {
    json.Member("integrator")
        .Fail(fmt::format("is {}, expected {} as --integrator says",
                          json.Member("integrator").Text(),
                          integrator));
  }
  const auto gains = ReadNumbers<5>(json.Member("gains"));
  if (gains != NumbersOf(*options.gains)) {
    json.Member("gains").Fail(fmt::format("is {}, expected {} as --gains says",
                                          fmt::join(gains, ","),
                                          fmt::join(NumbersOf(*options.gains), ",")));
  }
}

}  // namespace

std::string FormatFollower(Dof dof,
                           const AdaptiveOptions& options,
                           const AdaptiveFollower& follower) {
  CHECK(options.gains.has_value());
  CHECK(follower.IsFinite());
  const AdaptiveState state = follower.state();
  FollowerJson blocks = FollowerJson::array();
  for (const RecentScatter::Block& block : follower.scatter().blocks()) {
    blocks.push_back(RowOf(block));
  }
  const FollowerJson json = {
      {"schema", kFollowerSchema},
      {"dof", Name(dof)},
      {"gains", NumbersOf(*options.gains)},
      {"integrator", Name(options.integrator)},
      {"num_samples", state.num_samples},
      {"t", state.t},
      {"force", state.force},
      {"velocity", state.velocity},
      {"estimated_velocity", state.estimated_velocity},
      {"lumped", state.lumped},
      {"scatter", {{"block_size", follower.scatter().block_size()}, {"blocks", blocks}}}};
  return json.dump() + "\n";
}

AdaptiveFollower ParseFollower(const std::string& name,
                               std::string_view text,
                               Dof dof,
                               const AdaptiveOptions& options) {
  CHECK(options.gains.has_value());
  if (!Trimmed(text, " \t\n").starts_with('{')) {
    throw InputError(name +
                     ": is no state of a stream, expected the JSON of fathom_follow --state.");
  }
  const JsonValue json = JsonValue::Parse(name, text);
  json.RequireKeysOf({"schema",
                      "dof",
                      "gains",
                      "integrator",
                      "num_samples",
                      "t",
                      "force",
                      "velocity",
                      "estimated_velocity",
                      "lumped",
                      "scatter"});
  if (json.Member("schema").Text() != kFollowerSchema) {
    json.Member("schema").Fail(fmt::format("is no {}", kFollowerSchema));
  }
  RequireSameOptions(json, dof, options);
  const AdaptiveState state = ReadState(json);
  return {options, state, ReadScatter(json.Member("scatter"), state.num_samples)};
}

AdaptiveFollower ReadFollower(const std::filesystem::path& path,
                              Dof dof,
                              const AdaptiveOptions& options) {
  return ParseFollower(path.string(), ReadFile(path), dof, options);
}

}  // namespace fathom
