// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/film_corner_cost.h"

#include "fathom/coupled_refinement/deviated_pose.h"

#include <algorithm>
#include <array>

#include <ceres/cost_function.h>

namespace fathom {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class FilmCornerCost final : public ceres::CostFunction {
 public:
  explicit FilmCornerCost(const FilmCornerCostOf& of)
      : of_(of), marker_(*of.film.map.Find(of.detection.tag_id)) {
    const WindowMotion& motion = of.motions.at(of.window);
    set_num_residuals(8);
    auto* const sizes = mutable_parameter_block_sizes();
    if (!of.moving.empty()) sizes->push_back(static_cast<int>(of.moving.size()));
    sizes->insert(sizes->end(), {motion.num_shared(), motion.num_start()});
  }

  bool Evaluate(const double* const* parameters,
                double* residuals,
                double** jacobians) const override {
    if (!of_.motions.is_valid(of_.window)) return false;
    const WindowMotion& motion = of_.motions.at(of_.window);
    std::array<double, 6> deviation = {};
    for (std::size_t i = 0; i < of_.moving.size(); ++i) deviation[of_.moving[i]] = parameters[0][i];
    const DeviatedPose pose = Deviated(motion.PoseAt(of_.frame), deviation);
    PoseCornerRows rows;
    if (!CornersAtPose({of_.film.camera, of_.film.body_from_camera},
                       marker_,
                       of_.detection,
                       pose.world_from_body,
                       of_.corner_sigma,
                       &rows)) {
      return false;
    }
    std::copy_n(rows.residual.data(), 8, residuals);
    if (jacobians == nullptr) return true;
    if (!of_.moving.empty()) {
      if (double* const out = *jacobians++; out != nullptr) {
        const Eigen::Matrix<double, 8, 6> by_deviation = rows.by_pose * pose.by_deviation;
        Eigen::Map<Rows>(out, 8, static_cast<Eigen::Index>(of_.moving.size())) =
            by_deviation(Eigen::all, of_.moving);
      }
    }
    const Eigen::Matrix<double, 8, 6> by_simulated = rows.by_pose * pose.by_simulated;
    const WindowMotion::Derivatives& mean = motion.DerivativesAt(of_.frame);
    const int n = motion.num_shared(), m = motion.num_start();
    if (jacobians[0] != nullptr) {
      Eigen::Map<Rows>(jacobians[0], 8, n).noalias() = by_simulated * mean.leftCols(n);
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<Rows>(jacobians[1], 8, m).noalias() = by_simulated * mean.rightCols(m);
    }
    return true;
  }

 private:
  const FilmCornerCostOf of_;
  const Marker& marker_;
};

}  // namespace

std::unique_ptr<ceres::CostFunction> MakeFilmCornerCost(const FilmCornerCostOf& of) {
  return std::make_unique<FilmCornerCost>(of);
}

}  // namespace fathom
