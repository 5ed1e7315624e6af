// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The residual of the corners against finite differences, with everything away from 0.

#include "fathom/coupled_refinement/film_corner_cost.h"

#include <memory>
#include <vector>

#include <ceres/cost_function.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr std::size_t kFrame = 7;

CoupledModel PlanarModel() {
  CoupledModel model;
  model.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  model.coriolis = true;
  model.inertia.diagonal() << 34.0, 47.0, 47.0, 3.0, 3.0, 3.4;
  model.inertia(1, 5) = model.inertia(5, 1) = 1.6;
  model.linear_damping.diagonal() << 9.0, 13.0, 0.0, 0.0, 0.0, 2.1;
  model.quadratic_damping.diagonal() << 28.0, 45.0, 0.0, 0.0, 0.0, 3.5;
  model.offset << 0.4, -0.3, 0.0, 0.0, 0.0, 0.05;
  return model;
}

// Ten frames before one marker.
CoupledFilm ShortFilm() {
  CoupledFilm film;
  film.camera.width = 800;
  film.camera.height = 600;
  film.camera.fx = film.camera.fy = 640.0;
  film.camera.cx = 400.0;
  film.camera.cy = 300.0;
  const Eigen::Quaterniond looks_ahead(0.5, 0.5, 0.5, 0.5);
  film.body_from_camera = {looks_ahead, {0.6, 0.05, -0.1}};
  Marker marker;
  marker.id = 4;
  marker.size = 0.4;
  marker.world_from_tag = {looks_ahead, {4.5, -0.4, -0.35}};
  marker.is_surveyed = true;
  film.map.markers.push_back(marker);
  film.structure = StructureOf(StandardStructure::kSymmetric, PlanarModel().dofs);
  auto inputs = std::make_shared<CoupledInputs>();
  inputs->command.time = {0.0, 0.5};
  inputs->command.force.assign(2, Vector6::Zero());
  inputs->command.force[0] << 20.0, -15.0, 0.0, 0.0, 0.0, 3.0;
  inputs->command.force[1] << -10.0, 25.0, 0.0, 0.0, 0.0, -2.0;
  FilmWindow& window = film.windows.emplace_back();
  window.inputs = inputs;
  for (int k = 0; k < 10; ++k) {
    window.time.push_back(0.1 * k);
    Detection detection;
    detection.tag_id = 4;
    for (auto& corner : detection.corners) corner = {410.0, 290.0};
    window.detections.push_back({detection});
    window.world_from_body.emplace_back();
  }
  window.start.nu << 0.3, -0.2, 0.0, 0.0, 0.0, 0.25;
  return film;
}

class FilmCornerCostTest : public testing::Test {
 protected:
  FilmCornerCostTest() : film_(ShortFilm()), unknowns_(FilmUnknownsAt(film_, PlanarModel())) {
    unknowns_.windows[0].start = {0.05, -0.04, 0.03, 0.06, 0.02, -0.03, 0.01};
    *(unknowns_.shared.end() - 2) = 0.04;  // the trim
    unknowns_.shared.back() = -0.05;
  }

  // Of the detection of kFrame. The blocks as Ceres has them.
  Eigen::Matrix<double, 8, 1> Residual(const std::vector<double*>& blocks, double** jacobians) {
    FilmMotions motions(film_);
    EXPECT_TRUE(motions.Update(unknowns_, jacobians != nullptr));
    const auto cost = MakeFilmCornerCost(
        {film_, motions, moving_, 0.3, 0, kFrame, film_.windows[0].detections[kFrame][0]});
    Eigen::Matrix<double, 8, 1> residual;
    EXPECT_TRUE(cost->Evaluate(blocks.data(), residual.data(), jacobians));
    return residual;
  }

  const std::vector<int> moving_ = {0, 2, 3, 4};
  CoupledFilm film_;
  FilmUnknowns unknowns_;
  std::vector<double> deviation_ = {0.04, -0.02, 0.03, -0.05};
};

TEST_F(FilmCornerCostTest, HasTheJacobianOfItsDifferences) {
  std::vector<double>& shared = unknowns_.shared;
  std::vector<double>& start = unknowns_.windows[0].start;
  const std::vector<double*> blocks = {deviation_.data(), shared.data(), start.data()};
  const std::vector<std::size_t> sizes = {deviation_.size(), shared.size(), start.size()};
  using Rows = Eigen::Matrix<double, 8, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<Rows> jacobians;
  for (const std::size_t size : sizes) jacobians.emplace_back(8, static_cast<Eigen::Index>(size));
  std::vector<double*> out = {jacobians[0].data(), jacobians[1].data(), jacobians[2].data()};
  Residual(blocks, out.data());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::size_t i = 0; i < sizes[b]; ++i) {
      const double value = blocks[b][i];
      const double step = 1e-5 * std::max(1.0, std::abs(value));
      blocks[b][i] = value + step;
      const auto more = Residual(blocks, nullptr);
      blocks[b][i] = value - step;
      const auto less = Residual(blocks, nullptr);
      blocks[b][i] = value;
      const Eigen::Matrix<double, 8, 1> numeric = (more - less) / (2.0 * step);
      const auto analytic = jacobians[b].col(static_cast<Eigen::Index>(i));
      ASSERT_GT(numeric.norm(), 1e-4) << "block " << b << " entry " << i;
      // What the integrator leaves of the variational equation's exactness, step by step.
      EXPECT_LT((numeric - analytic).norm(), 2e-4 * numeric.norm())
          << "block " << b << " entry " << i;
    }
  }
}

TEST_F(FilmCornerCostTest, RefusesAPointWhoseSimulationDiverges) {
  for (double& number : unknowns_.shared) number = -number;
  FilmMotions motions(film_);
  EXPECT_FALSE(motions.Update(unknowns_, false));
  const auto cost = MakeFilmCornerCost(
      {film_, motions, moving_, 0.3, 0, kFrame, film_.windows[0].detections[kFrame][0]});
  const std::vector<double*> blocks = {
      deviation_.data(), unknowns_.shared.data(), unknowns_.windows[0].start.data()};
  Eigen::Matrix<double, 8, 1> residual;
  EXPECT_FALSE(cost->Evaluate(blocks.data(), residual.data(), nullptr));
}

}  // namespace
}  // namespace fathom
