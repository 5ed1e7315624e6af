// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Surge, sway and yaw refined together with the camera's path.

#include "fathom/coupled_refinement/film_refinement.h"

#include "fathom/coupled_refinement/film_page.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "error_from.h"
#include "filmed_plane.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;

FilmRefinementOptions Symmetric() {
  FilmRefinementOptions options;
  options.identification.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  options.identification.structure = StandardStructure::kSymmetric;
  return options;
}

// The largest error of a number, as a share of it; of an offset, as a share of the largest one.
double WorstError(const FittedCoupledModel& fitted, const CoupledModel& truth) {
  double worst = 0.0;
  for (const FreeEntry& entry : fitted.entries) {
    const double expected = ValueIn(truth, entry);
    worst = std::max(worst, std::abs(ValueIn(fitted.model, entry) / expected - 1.0));
  }
  return worst;
}

TEST(RefineCoupled, FindsModelAndPathOfAFilmedRun) {
  const FilmedPlane filmed = FilmPlane({});
  const FilmRefinement refinement = RefineCoupled(filmed.logs, Symmetric());
  ASSERT_TRUE(refinement.is_usable) << refinement.message;
  EXPECT_TRUE(refinement.joint.settled);
  // Issue 49, step 6: parameters within 1 %, path error at most 0.3 of PnP's.
  EXPECT_LT(WorstError(refinement.fitted, filmed.model), 0.01);
  EXPECT_GT(WorstError(refinement.of_poses.fitted, filmed.model), 0.03);
  const PathErrors errors = PathErrorsOf(refinement, filmed.truth);
  EXPECT_EQ(errors.refined.num_frames, 500);
  EXPECT_LT(errors.refined.position, 0.3 * errors.of_pnp.position);
  EXPECT_LT(errors.refined.angle, 0.3 * errors.of_pnp.angle);
  EXPECT_TRUE(refinement.is_judged_by_velocity);
  for (const Dof dof : refinement.fitted.model.dofs) {
    EXPECT_LT(refinement.fitted.held_out[static_cast<std::size_t>(Index(dof))].nmae, 0.15);
  }
  EXPECT_NEAR(refinement.joint.processes.corner_sigma, 0.3, 0.01);

  const Page page = FilmPage(refinement);
  ASSERT_EQ(page.sections.size(), 2u);
  const std::vector<TimePanel>& panels = page.sections[0].time_panels;
  ASSERT_EQ(panels.size(), 3u);  // a DOF each, held-out part and all
  EXPECT_EQ(panels[0].held_out.size(), 1u);
  EXPECT_THAT(panels[0].responses, testing::SizeIs(2));
  EXPECT_EQ(panels[0].responses[1].values.size(), panels[0].time.size());
}

TEST(RefineCoupled, FindsTheTruthFromPerfectCorners) {
  FilmedPlaneOptions options;
  options.duration = 40.0;
  options.corner_sigma = 0.0;
  options.hold_position = options.hold_angle = 0.0;
  const FilmedPlane filmed = FilmPlane(options);
  const FilmRefinement refinement = RefineCoupled(filmed.logs, Symmetric());
  ASSERT_TRUE(refinement.is_usable) << refinement.message;
  EXPECT_LT(WorstError(refinement.fitted, filmed.model), 1e-4);
  const PathErrors errors = PathErrorsOf(refinement, filmed.truth);
  EXPECT_LT(errors.refined.position, 1e-5);
  EXPECT_LT(errors.refined.angle, 1e-5);
}

Pose TruePoseAt(const Stream& truth, double time) {
  const auto at = std::lower_bound(truth.time.begin(), truth.time.end(), time - 1e-6);
  const auto row = static_cast<std::size_t>(at - truth.time.begin());
  const auto& v = truth.values;
  return {Eigen::Quaterniond(v[6][row], v[3][row], v[4][row], v[5][row]),
          {v[0][row], v[1][row], v[2][row]}};
}

// The mean of squared errors over their variances, along x, y and about z.
Eigen::Vector3d PathScores(const FilmRefinement& refinement, const Stream& truth) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int num = 0;
  for (std::size_t w = 0; w < refinement.film.windows.size(); ++w) {
    const RefinedWindow& window = refinement.joint.windows[w];
    for (std::size_t k = 0; k < window.world_from_body.size(); ++k) {
      const Pose expected = TruePoseAt(truth, refinement.film.windows[w].time[k]);
      const PoseIncrement miss = StepBetween(window.world_from_body[k], expected);
      const PoseCovariance& covariance = window.pose_covariance[k];
      int i = 0;
      for (const int row : {0, 1, 5}) sum[i++] += miss[row] * miss[row] / covariance(row, row);
      ++num;
    }
  }
  return sum / num;
}

// The reported covariances are promises about errors: their squares over the variances are 1 in
// the mean, of the numbers and of the path along the modelled DOFs. (Those of heave and pitch,
// which one wall hardly tells apart, rest on how these wander. Three sines are no process of this
// kind.)
TEST(RefineCoupled, KnowsHowFarOffItIs) {
  double sum = 0.0, path = 0.0;
  int num = 0;
  constexpr int kRuns = 2;
  for (int run = 0; run < kRuns; ++run) {
    FilmedPlaneOptions options;
    options.duration = 35.0;
    options.seed = static_cast<std::uint64_t>(11 + run);
    const FilmedPlane filmed = FilmPlane(options);
    const FilmRefinement refinement = RefineCoupled(filmed.logs, Symmetric());
    ASSERT_TRUE(refinement.is_usable) << refinement.message;
    for (std::size_t k = 0; k < refinement.fitted.entries.size(); ++k) {
      const FreeEntry& entry = refinement.fitted.entries[k];
      const auto at = static_cast<Eigen::Index>(k);
      sum += std::pow(ValueIn(refinement.fitted.model, entry) - ValueIn(filmed.model, entry), 2) /
             refinement.fitted.covariance(at, at);
      ++num;
    }
    path += PathScores(refinement, filmed.truth).mean() / kRuns;
  }
  // 26 numbers of two runs that hang together: about eight independent squares, which scatter by
  // 0.5 about 1. Of the path, whose errors last as long as a window, as many.
  EXPECT_GT(sum / num, 0.2);
  EXPECT_LT(sum / num, 2.5);
  EXPECT_GT(path, 0.2);
  EXPECT_LT(path, 2.5);
}

TEST(RefineCoupled, SaysThatAStructureIsTooLarge) {
  FilmedPlaneOptions options;
  options.duration = 30.0;
  const FilmedPlane filmed = FilmPlane(options);
  CoupledFilm film;
  film.structure =
      StructureOf(StandardStructure::kFull,
                  {Dof::kSurge, Dof::kSway, Dof::kHeave, Dof::kRoll, Dof::kPitch, Dof::kYaw});
  film.windows.resize(1);
  EXPECT_THAT(ErrorFrom([&] { FitFilm(film, filmed.model); }),
              HasSubstr("numbers of 6 DOFs, expected at most"));
}

}  // namespace
}  // namespace fathom
