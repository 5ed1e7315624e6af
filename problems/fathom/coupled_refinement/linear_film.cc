// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/linear_film.h"

#include "fathom/coupled/physical_barrier.h"
#include "fathom/coupled_refinement/deviated_pose.h"
#include "fathom/coupled_refinement/film_motions.h"
#include "fathom/coupled_refinement/film_problem.h"
#include "fathom/joint_refinement/problem/chain_smoother.h"
#include "fathom/joint_refinement/problem/clipped_loss.h"
#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/joint_refinement/search/process_fit.h"

#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr double kLeastShare = 1e-7;  // of a column that the others cannot imitate

void ClearSegment(std::size_t num_frames, LinearSegment* linear) {
  linear->frames.resize(num_frames);
  for (LinearFrame& frame : linear->frames) {
    frame.JdJd.setZero();
    frame.JdJg.setZero();
    frame.Jdr.setZero();
  }
  linear->JgJg.setZero();
  linear->Jgr.setZero();
  linear->response.setZero();
}

// Adds a detection, its residuals in pixels.
void AddRows(const PoseCornerRows& rows,
             const DeviatedPose& pose,
             const WindowMotion::Derivatives& mean,
             const std::array<double, 6>& deviation,
             double corner_sigma,
             double loss_limit,
             LinearFrame* frame,
             LinearSegment* linear) {
  const double s = rows.residual.squaredNorm() / (corner_sigma * corner_sigma);
  const ClippedLoss loss = ClippedLoss::Of(s, loss_limit);
  const double weight = loss.weight;
  const Eigen::Matrix<double, 8, 6> Jd = rows.by_pose * pose.by_deviation;
  Eigen::Matrix<double, 8, kNumColumns> Jg = Eigen::Matrix<double, 8, kNumColumns>::Zero();
  Jg.leftCols(mean.cols()) = rows.by_pose * pose.by_simulated * mean;
  const Eigen::Matrix<double, 8, 1> r = rows.residual - Jd * PoseIncrement(deviation.data());
  frame->JdJd.noalias() += weight * Jd.transpose() * Jd;
  frame->JdJg.noalias() += weight * Jd.transpose() * Jg;
  frame->Jdr.noalias() += weight * Jd.transpose() * r;
  linear->JgJg.noalias() += weight * Jg.transpose() * Jg;
  linear->Jgr.noalias() += weight * Jg.transpose() * r;
  linear->rr += weight * r.squaredNorm();
  linear->clipped += loss.value - weight * s;
  linear->num_rows += 8.0 * weight;
}

// What is left of one window once its deviations are eliminated, over (what is shared, its start).
struct LeftOfWindow {
  ChainSmoother smoother;
  Eigen::MatrixXd start_inverse;  // of the start's part
  Eigen::MatrixXd start_by_shared;
};

// A symmetric positive definite matrix inverted on columns of unit length; nothing if it is not.
std::optional<Eigen::MatrixXd> Inverted(const Eigen::MatrixXd& H) {
  if (!(H.diagonal().minCoeff() > 0.0)) return std::nullopt;
  const Eigen::VectorXd unscale = H.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LLT<Eigen::MatrixXd> llt(unscale.asDiagonal() * H * unscale.asDiagonal());
  if (llt.info() != Eigen::Success || !(llt.matrixLLT().diagonal().minCoeff() > kLeastShare)) {
    return std::nullopt;
  }
  const Eigen::MatrixXd inverse = llt.solve(Eigen::MatrixXd::Identity(H.rows(), H.cols()));
  return unscale.asDiagonal() * inverse * unscale.asDiagonal();
}

// Knowledge of nothing but one column that no corner depends on: all others are held.
GlobalsPrior HeldGlobals() {
  GlobalsPrior prior;
  prior.std.fill(0.0);
  prior.std[kClockColumn] = 1.0;
  return prior;
}

}  // namespace

std::optional<std::vector<LinearSegment>> LineariseFilm(const CoupledFilm& film,
                                                        const FilmUnknowns& unknowns,
                                                        double corner_sigma,
                                                        double loss_limit) {
  FilmMotions motions(film);
  if (!motions.Update(unknowns, true)) return std::nullopt;
  std::vector<LinearSegment> windows(film.windows.size());
  for (std::size_t w = 0; w < windows.size(); ++w) {
    const FilmWindow& window = film.windows[w];
    LinearSegment& linear = windows[w];
    LayOutDurations(window.time, &linear);
    ClearSegment(window.time.size(), &linear);
    for (std::size_t k = 0; k < window.time.size(); ++k) {
      const std::array<double, 6>& deviation = unknowns.windows[w].deviation[k];
      const DeviatedPose pose = Deviated(motions.at(w).PoseAt(k), deviation);
      for (const Detection& detection : window.detections[k]) {
        PoseCornerRows rows;
        if (!CornersAtPose({film.camera, film.body_from_camera},
                           *film.map.Find(detection.tag_id),
                           detection,
                           pose.world_from_body,
                           1.0,
                           &rows)) {
          return std::nullopt;
        }
        AddRows(rows,
                pose,
                motions.at(w).DerivativesAt(k),
                deviation,
                corner_sigma,
                loss_limit,
                &linear.frames[k],
                &linear);
      }
    }
  }
  return windows;
}

std::optional<FilmProcesses> FitFilmProcesses(std::span<const LinearSegment> windows,
                                              const ProcessSet& start,
                                              int freely) {
  // The clock's column stands for nothing: without one the linear problem has no globals.
  const std::vector<GlobalsPrior> priors(windows.size(), HeldGlobals());
  std::vector<LinearSegment> held(windows.begin(), windows.end());
  for (LinearSegment& window : held) {
    for (LinearFrame& frame : window.frames) frame.JdJg.setZero();
    window.JgJg.setZero();
    window.Jgr.setZero();
  }
  const ProcessFit fit = FitProcesses(held, priors, start, freely);
  if (!std::isfinite(fit.log_likelihood)) return std::nullopt;
  return FilmProcesses{fit.converged, fit.processes, fit.log_likelihood};
}

std::optional<FilmSpread> FilmSpreadOf(const CoupledFilm& film,
                                       const FilmUnknowns& unknowns,
                                       std::span<const LinearSegment> windows,
                                       const ProcessSet& processes) {
  FilmMotions motions(film);
  if (!motions.Update(unknowns, true)) return std::nullopt;
  const int n = motions.at(0).num_shared(), m = motions.at(0).num_start();
  std::vector<int> columns(static_cast<std::size_t>(n + m));
  std::iota(columns.begin(), columns.end(), 0);
  const CoupledModel model = unknowns.Model(film.structure);
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n, n);
  const auto num_entries = static_cast<Eigen::Index>(film.structure.entries.size());
  H.topLeftCorner(num_entries, num_entries) =
      BarrierAt(model, film.structure.entries, film.body).hessian;
  std::vector<LeftOfWindow> left;
  for (const LinearSegment& window : windows) {
    ChainSmoother smoother(window, processes, FreelyMoving(film), columns);
    if (!smoother.is_positive_definite()) return std::nullopt;
    const Eigen::MatrixXd& own = smoother.H();
    const auto inverse = Inverted(own.bottomRightCorner(m, m));
    if (!inverse) return std::nullopt;
    const Eigen::MatrixXd by_shared = *inverse * own.bottomLeftCorner(m, n);
    H += own.topLeftCorner(n, n) - own.topRightCorner(n, m) * by_shared;
    left.push_back({std::move(smoother), *inverse, by_shared});
  }
  const auto covariance = Inverted(H);
  if (!covariance) return std::nullopt;
  FilmSpread spread;
  spread.entries = covariance->topLeftCorner(num_entries, num_entries);
  for (std::size_t w = 0; w < left.size(); ++w) {
    // Of (shared, start): the start follows what is shared.
    Eigen::MatrixXd joint(n + m, n + m);
    const Eigen::MatrixXd& follows = left[w].start_by_shared;
    joint.topLeftCorner(n, n) = *covariance;
    joint.bottomLeftCorner(m, n) = -follows * *covariance;
    joint.topRightCorner(n, m) = joint.bottomLeftCorner(m, n).transpose();
    joint.bottomRightCorner(m, m) =
        left[w].start_inverse + follows * *covariance * follows.transpose();
    std::vector<PoseCovariance>& poses = spread.of_pose.emplace_back(film.windows[w].time.size());
    left[w].smoother.ForEachFrame(
        [&](std::size_t k, const ChainSmoother::Square& P, const ChainSmoother::Border& G) {
          const DeviatedPose pose =
              Deviated(motions.at(w).PoseAt(k), unknowns.windows[w].deviation[k]);
          Eigen::MatrixXd own(6, n + m);
          PoseCovariance known;
          for (int i = 0; i < 6; ++i) {
            own.row(i) = G.row(2 * i);
            for (int j = 0; j < 6; ++j) known(i, j) = P(2 * i, 2 * j);
          }
          const Eigen::MatrixXd J =
              pose.by_simulated * motions.at(w).DerivativesAt(k) + pose.by_deviation * own;
          poses[k] =
              J * joint * J.transpose() + pose.by_deviation * known * pose.by_deviation.transpose();
        });
  }
  return spread;
}

}  // namespace fathom
