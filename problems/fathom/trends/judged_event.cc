// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/judged_event.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr double kLeastFit = 0.01;
constexpr double kLead = 6.0;

struct Scored {
  std::vector<const Pattern*> parts;
  Pattern pattern;
  PatternFit fit;

  std::string Cause() const {
    std::string text = parts.front()->cause;
    for (std::size_t i = 1; i < parts.size(); ++i) text += " and " + parts[i]->cause;
    return text;
  }
};

bool Fits(const Scored& scored) {
  return scored.fit.has_right_sign && scored.fit.p_value > kLeastFit;
}

// Two causes from the same dive on; at most one of them with a factor.
Pattern Together(const Pattern& a, const Pattern& b) {
  Pattern both = a;
  both.cause += " and " + b.cause;
  both.directions.resize(a.share.size(), a.directions.cols() + b.directions.cols());
  both.directions << a.directions, b.directions;
  both.share += b.share;
  both.sign = PatternSign::kAny;
  return both;
}

// The parameters that this part alone moves go the way that it demands.
bool HasRightSign(const Pattern& part, const Pattern& other, const EventFit& event) {
  if (part.sign == PatternSign::kAny) return true;
  const double sign = part.sign == PatternSign::kGrows ? 1.0 : -1.0;
  double sum = 0.0;
  const Eigen::Index m = event.before.size();
  for (Eigen::Index i = 0; i < m; ++i) {
    const int s = event.series[i];
    if (!part.Moves(s) || other.Moves(s)) continue;
    sum += sign * event.difference(i) / std::sqrt(event.covariance(m + i, m + i));
  }
  return sum > 0.0;
}

bool Overlap(const Pattern& a, const Pattern& b) {
  for (Eigen::Index s = 0; s < a.share.size(); ++s) {
    if (a.Moves(s) && b.Moves(s) && !a.HasFactor() && !b.HasFactor()) return true;
  }
  return false;
}

std::vector<Scored> Singles(const EventFit& event,
                            std::span<const Pattern> patterns,
                            double price) {
  std::vector<Scored> scored;
  for (const Pattern& pattern : patterns) {
    scored.push_back({{&pattern}, pattern, FitPattern(pattern, event, price)});
  }
  return scored;
}

std::vector<Scored> Pairs(const EventFit& event, std::span<const Pattern> patterns, double price) {
  std::vector<Scored> scored;
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    for (std::size_t j = i + 1; j < patterns.size(); ++j) {
      const Pattern& a = patterns[i];
      const Pattern& b = patterns[j];
      if (a.cause == b.cause || (a.HasFactor() && b.HasFactor()) || Overlap(a, b)) continue;
      const Pattern both = Together(a, b);
      PatternFit fit = FitPattern(both, event, price);
      fit.has_right_sign = HasRightSign(a, b, event) && HasRightSign(b, a, event);
      scored.push_back({{&a, &b}, both, fit});
    }
  }
  return scored;
}

const Scored* Best(const std::vector<Scored>& scored) {
  const Scored* best = nullptr;
  for (const Scored& one : scored) {
    if (Fits(one) && (best == nullptr || one.fit.score < best->fit.score)) best = &one;
  }
  return best;
}

JudgedEvent Told(const Scored& best, const std::vector<Scored>& all) {
  JudgedEvent judged;
  for (const Pattern* part : best.parts) judged.causes.push_back({part->cause, *part, best.fit});
  for (const Scored& other : all) {
    const std::string cause = other.Cause();
    const bool is_close = Fits(other) && other.fit.score < best.fit.score + kLead;
    const auto& told = judged.alternatives;
    const bool is_new =
        cause != best.Cause() && std::find(told.begin(), told.end(), cause) == told.end();
    if (is_close && is_new) judged.alternatives.push_back(cause);
  }
  return judged;
}

}  // namespace

JudgedEvent Judge(const EventFit& event, std::span<const Pattern> patterns, int num_dives) {
  const double price = std::log(std::max(num_dives, 8));
  const std::vector<Scored> singles = Singles(event, patterns, price);
  if (const Scored* best = Best(singles)) return Told(*best, singles);
  const std::vector<Scored> pairs = Pairs(event, patterns, price);
  double best_single = 1e300;
  for (const Scored& one : singles) best_single = std::min(best_single, one.fit.score);
  const Scored* best = Best(pairs);
  if (best != nullptr && best->fit.score + kLead < best_single) return Told(*best, pairs);
  return {{NamedCause{}}, {}};
}

}  // namespace fathom
