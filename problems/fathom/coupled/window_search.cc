// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/window_search.h"

#include "fathom/base/parallel_for.h"
#include "fathom/coupled/physical_barrier.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr double kLeastDamping = 1e-12;
constexpr int kMostTries = 12;           // of one step, with ever more damping
constexpr double kStartPrecision = 0.1;  // of each start, in standard deviations
constexpr double kSmallestGain = 1e-10;  // of the cost
constexpr int kStartSteps = 2;
constexpr const char* kBeginsNowhere = "the simulation diverges where the search begins";
constexpr double kForetoldFor = 3.0;       // times what a gain missed of what was foretold is left
constexpr double kWorthAnotherLook = 0.3;  // by so much another share than the whole step

// Normal equations of one window: entries t, start s.
struct WindowNormal {
  Eigen::MatrixXd tt, ts, ss;
  Eigen::VectorXd t, s;
  double cost = 0.0;
  int num_rows = 0;
};

bool NormalOf(const WindowProblem& problem,
              const std::vector<ChannelWeight>& weights,
              const WindowPoint& point,
              std::size_t w,
              WindowNormal* normal) {
  thread_local WindowResiduals residuals;  // megabytes, for many windows of the same size
  if (!ResidualsIn(problem, point, w, true, &residuals)) return false;
  const auto num_entries = static_cast<Eigen::Index>(problem.entries.size());
  const Eigen::Index num = 1 + num_entries + problem.free.size();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(num, num);
  for (WindowResiduals::Piece& piece : residuals.pieces) {
    normal->cost += WeighRows(weights[piece.channel], &piece);
    normal->num_rows += static_cast<int>(piece.rows.rows());
    gram.selfadjointView<Eigen::Lower>().rankUpdate(piece.rows.transpose());
  }
  gram = gram.selfadjointView<Eigen::Lower>();
  const Eigen::Index m = problem.free.size();
  normal->tt = gram.block(1, 1, num_entries, num_entries);
  normal->ts = gram.block(1, 1 + num_entries, num_entries, m);
  normal->ss = gram.bottomRightCorner(m, m);
  normal->t = gram.col(0).segment(1, num_entries);
  normal->s = gram.col(0).tail(m);
  return true;
}

// Infinite where a run diverges, or as soon as it is above `limit`.
double CostAt(const WindowProblem& problem,
              const std::vector<ChannelWeight>& weights,
              const WindowPoint& point,
              double limit) {
  // What is summed in the order of who is first decides nothing but to stop, well above the limit.
  const double far = limit + 1e-9 * std::abs(limit);
  std::vector<double> costs(problem.windows.size(), 0.0);
  std::atomic<double> sum = 0.0;
  ParallelFor(static_cast<int>(costs.size()), [&](int w) {
    if (sum > far) return;
    double& cost = costs[static_cast<std::size_t>(w)];
    WindowResiduals residuals;
    if (!ResidualsIn(problem, point, static_cast<std::size_t>(w), false, &residuals)) {
      cost = std::numeric_limits<double>::infinity();
    }
    for (WindowResiduals::Piece& piece : residuals.pieces) {
      cost += WeighRows(weights[piece.channel], &piece);
    }
    sum += cost;
  });
  const double cost = std::accumulate(costs.begin(), costs.end(), 0.0);
  return cost > limit ? std::numeric_limits<double>::infinity() : cost;
}

struct Linearised {
  std::vector<WindowNormal> windows;
  double cost = 0.0;
  int num_rows = 0;
};

bool Linearise(const WindowProblem& problem,
               const std::vector<ChannelWeight>& weights,
               const WindowPoint& point,
               Linearised* out) {
  out->windows.assign(problem.windows.size(), {});
  out->cost = 0.0;
  out->num_rows = 0;
  std::atomic<bool> runs = true;
  ParallelFor(static_cast<int>(out->windows.size()), [&](int w) {
    const auto window = static_cast<std::size_t>(w);
    if (runs && !NormalOf(problem, weights, point, window, &out->windows[window])) runs = false;
  });
  for (const WindowNormal& window : out->windows) {
    out->cost += window.cost;
    out->num_rows += window.num_rows;
  }
  return runs;
}

ReducedWindows Reduce(const Linearised& lines, Eigen::Index num_entries, double damping) {
  ReducedWindows reduced = {lines.cost,
                            Eigen::MatrixXd::Zero(num_entries, num_entries),
                            Eigen::VectorXd::Zero(num_entries),
                            lines.num_rows};
  for (const WindowNormal& window : lines.windows) {
    const auto solver = StartSolver(window.ss, damping);
    const Eigen::MatrixXd by = solver.solve(window.ts.transpose());
    reduced.normal += window.tt - window.ts * by;
    reduced.gradient += window.t - by.transpose() * window.s;
  }
  return reduced;
}

struct Step {
  Eigen::VectorXd entries;
  std::vector<Eigen::VectorXd> starts;
  // Squared lengths of the step in standard deviations: of the entries, and of the starts as well.
  double of_entries = 0.0;
  double decrement = 0.0;
  double foretold = 0.0;   // gain
  double held_back = 0.0;  // squared length of what the damping leaves to go, of the entries
};

bool StepOf(const Linearised& lines, const PhysicalBarrier& barrier, double damping, Step* step) {
  const auto num = barrier.gradient.size();
  const ReducedWindows reduced = Reduce(lines, num, damping);
  Eigen::MatrixXd normal = reduced.normal + barrier.hessian;
  const Eigen::VectorXd gradient = reduced.gradient + barrier.gradient;
  // By columns of unit length.
  const Eigen::VectorXd scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  scaled.diagonal().array() += damping + 1e-13;
  const Eigen::LDLT<Eigen::MatrixXd> solver(scaled);
  if (solver.info() != Eigen::Success || !solver.isPositive()) return false;
  const Eigen::VectorXd scaled_step = -solver.solve(scale.cwiseProduct(gradient));
  step->entries = scale.cwiseProduct(scaled_step);
  step->of_entries = -scaled_step.dot(scale.cwiseProduct(gradient));
  step->decrement = step->of_entries;
  scaled.diagonal().array() -= damping;
  const Eigen::VectorXd rest = damping * scaled_step;
  step->held_back = std::max(rest.dot(SolveSymmetric(scaled, rest)), 0.0);
  step->starts.clear();
  for (const WindowNormal& window : lines.windows) {
    const Eigen::VectorXd right = window.s + window.ts.transpose() * step->entries;
    step->starts.emplace_back(-StartSolver(window.ss, damping).solve(right));
    step->decrement += window.s.dot(StartSolver(window.ss, damping).solve(window.s));
  }
  step->foretold = 0.5 * (step->decrement + damping * scaled_step.squaredNorm());
  return step->entries.allFinite();
}

// Whether what is left to go is small for the entries, and on average for each start.
bool IsSmall(const Step& step, const Linearised& lines, const WindowSearchOptions& options) {
  const double precision = options.precision;
  const double rest = step.decrement - step.of_entries;
  return (step.of_entries < precision * precision &&
          rest < kStartPrecision * kStartPrecision * static_cast<double>(lines.windows.size())) ||
         step.decrement < options.smallest_gain * lines.cost;
}

// Whether a whole step has left little to go: by how well its gain was foretold, the slope at its
// end is known without another look at all derivatives.
bool LeavesLittle(const Step& step, double gain, double precision) {
  const double bent = std::abs(1.0 - gain / std::max(step.foretold, 1e-300));
  return std::sqrt(step.held_back) + kForetoldFor * bent * std::sqrt(step.decrement) < precision;
}

// A share of a step from where it was taken.
WindowPoint Stepped(const WindowProblem& problem,
                    const WindowPoint& from,
                    const Step& step,
                    double share) {
  WindowPoint to = from;
  for (std::size_t k = 0; k < problem.entries.size(); ++k) {
    const FreeEntry& entry = problem.entries[k];
    const double move = share * step.entries[static_cast<Eigen::Index>(k)];
    SetValue(entry, ValueIn(from.model, entry) + move, &to.model);
  }
  for (std::size_t w = 0; w < to.starts.size(); ++w) {
    to.starts[w] = Moved(from.starts[w], problem.free, share * step.starts[w]);
  }
  return to;
}

// Where a step ends.
struct StepEnd {
  WindowPoint point;
  PhysicalBarrier barrier;
  double gain = -std::numeric_limits<double>::infinity();  // of cost and barrier
};

StepEnd EndOf(const WindowProblem& problem,
              const std::vector<ChannelWeight>& weights,
              const WindowPoint& from,
              const Step& step,
              double share,
              double before) {
  StepEnd end = {Stepped(problem, from, step, share), {}};
  end.barrier = BarrierIn(problem, end.point.model);
  if (!std::isfinite(end.barrier.cost)) return end;
  const double limit = before - end.barrier.cost;
  end.gain = limit - CostAt(problem, weights, end.point, limit);
  return end;
}

// Where the parabola through a step's slope and its gain has its least, as a share of the step. The
// squares know nothing of how the residuals bend: with large ones a step may go twice too far, time
// and again.
double BestShare(const Step& step, double gain) {
  const double bend = step.decrement - gain;
  return bend > 0.0 ? std::clamp(step.decrement / (2.0 * bend), 0.2, 3.0) : 3.0;
}

// As SearchWindows(), where what a small step from the start changes is known.
WindowSearch SearchFrom(const WindowProblem& problem,
                        const std::vector<ChannelWeight>& weights,
                        const WindowPoint& start,
                        Linearised lines,
                        const WindowSearchOptions& options) {
  WindowSearch search;
  search.point = start;
  search.cost = lines.cost;
  const auto num = static_cast<Eigen::Index>(problem.entries.size());
  PhysicalBarrier barrier = BarrierIn(problem, start.model);
  double damping = options.first_damping;
  search.message = "the search did not come to its end: these data may not tell the numbers apart";
  while (search.num_iterations < options.max_iterations) {
    ++search.num_iterations;
    Step step;
    StepEnd end;
    double growth = 2.0;
    bool is_small = false;
    const double before = lines.cost + barrier.cost;
    for (int tries = 0; tries < kMostTries && !is_small; ++tries) {
      if (StepOf(lines, barrier, damping, &step)) {
        is_small = IsSmall(step, lines, options);
        end = EndOf(problem, weights, search.point, step, 1.0, before);
      }
      if (end.gain > 0.0) break;
      damping *= growth;
      growth *= 2.0;
    }
    if (!(end.gain > 0.0)) {
      search.converged = true;  // rounding lets no step lower the error any more
      break;
    }
    is_small = is_small || LeavesLittle(step, end.gain, options.precision) ||
               end.gain < options.smallest_gain * lines.cost;
    const double share = BestShare(step, end.gain);
    if (!is_small && std::abs(share - 1.0) > kWorthAnotherLook) {
      StepEnd nearer = EndOf(problem, weights, search.point, step, share, before);
      if (nearer.gain > end.gain) end = std::move(nearer);
    }
    // Less damping the better the squares foretold the gain.
    const double quality = std::min(end.gain / std::max(0.5 * step.decrement, 1e-300), 1.0);
    damping *= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * quality - 1.0, 3.0));
    damping = std::max(damping, kLeastDamping);
    search.cost = before - end.gain - end.barrier.cost;
    barrier = std::move(end.barrier);
    search.point = std::move(end.point);
    if (is_small) {
      search.converged = true;
      break;
    }
    if (!Linearise(problem, weights, search.point, &lines)) {
      search.message = "the simulation diverges";
      return search;
    }
  }
  if (search.converged) search.message = "converged";
  search.near = Reduce(lines, num, 0.0);
  return search;
}

// Linearises where the starts are best for the model: nearly, since runs bend. A step of a start
// that raises its window's cost is taken back.
bool SettleStarts(const WindowProblem& problem,
                  const std::vector<ChannelWeight>& weights,
                  WindowPoint* point,
                  Linearised* lines) {
  WindowProblem held = problem;
  held.entries.clear();
  std::vector<double> costs(problem.windows.size(), std::numeric_limits<double>::infinity());
  std::vector<CoupledState> best = point->starts;
  for (int step = 0; step < kStartSteps; ++step) {
    if (!Linearise(held, weights, *point, lines)) return false;
    for (std::size_t w = 0; w < costs.size(); ++w) {
      const WindowNormal& window = lines->windows[w];
      if (!(window.cost < costs[w])) {
        point->starts[w] = best[w];
        continue;
      }
      costs[w] = window.cost;
      best[w] = point->starts[w];
      point->starts[w] = Moved(best[w], problem.free, -StartSolver(window.ss, 0.0).solve(window.s));
    }
  }
  if (!Linearise(problem, weights, *point, lines)) return false;
  bool is_settled = true;
  for (std::size_t w = 0; w < costs.size(); ++w) {
    if (!(lines->windows[w].cost > costs[w])) continue;
    point->starts[w] = best[w];
    is_settled = false;
  }
  return is_settled || Linearise(problem, weights, *point, lines);
}

}  // namespace

WindowSearch SearchWindows(const WindowProblem& problem,
                           const std::vector<ChannelWeight>& weights,
                           const WindowPoint& start,
                           const WindowSearchOptions& options) {
  Linearised lines;
  if (!Linearise(problem, weights, start, &lines)) {
    WindowSearch search;
    search.point = start;
    search.message = kBeginsNowhere;
    return search;
  }
  return SearchFrom(problem, weights, start, std::move(lines), options);
}

std::vector<WindowSearch> SearchParts(const WindowProblem& problem,
                                      const std::vector<ChannelWeight>& weights,
                                      const WindowPoint& start,
                                      const std::vector<std::vector<std::size_t>>& parts,
                                      const WindowSearchOptions& options) {
  std::vector<WindowSearch> searches(parts.size());
  WindowPoint settled = start;
  Linearised lines;
  if (!SettleStarts(problem, weights, &settled, &lines)) {
    for (WindowSearch& search : searches) {
      search.point = start;
      search.message = kBeginsNowhere;
    }
    return searches;
  }
  ParallelFor(static_cast<int>(parts.size()), [&](int p) {
    const auto at = static_cast<std::size_t>(p);
    WindowProblem part = problem;
    part.windows.clear();
    WindowPoint point = {settled.model, {}};
    Linearised part_lines;
    for (const std::size_t w : parts[at]) {
      part.windows.push_back(problem.windows[w]);
      point.starts.push_back(settled.starts[w]);
      part_lines.windows.push_back(lines.windows[w]);
      part_lines.cost += lines.windows[w].cost;
      part_lines.num_rows += lines.windows[w].num_rows;
    }
    searches[at] = SearchFrom(part, weights, point, std::move(part_lines), options);
  });
  return searches;
}

}  // namespace fathom
