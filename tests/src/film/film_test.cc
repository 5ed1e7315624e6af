// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/film.h"

#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/film/film_file.h"
#include "fathom/synthesize/experiment/experiment_file.h"
#include "fathom/synthesize/synthesize.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "test_folder.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

const std::filesystem::path kData = FATHOM_DATA_DIR;

Film Wall() { return ReadFilmFile(kData / "films/wall.yaml"); }

Experiment Short(const std::string& dof) {
  Experiment experiment = ReadExperimentFile(kData / ("experiments/film_" + dof + ".yaml"));
  experiment.duration = 20.0;
  experiment.held_out = {};
  return experiment;
}

std::vector<StampedPose> PosesOf(const std::string& dof, const Film& film) {
  const Vehicle vehicle = ReadVehicleFile(kData / "vehicles/flatfish.yaml");
  const Experiment experiment = Short(dof);
  const Stream shown = ShownPoses(vehicle, experiment, {}, 3, film.sampling);
  std::vector<Dof> driven;
  for (const Drive& drive : experiment.drives) driven.push_back(drive.dof);
  return HeldPoses(shown, driven, film, 3);
}

// By hand for a still vehicle at the origin: the camera at x = 1, the tag 3.5 m ahead of it.
TEST(Film, ShowsTheMarkerWhereItIs) {
  Film film = Wall();
  film.corner_sigma = 0.0;
  film.rig.camera.lens = LensModel::kNone;
  film.rig.camera.coefficients = {};
  const std::vector<StampedPose> still(1);
  const auto detections = FilmCorners(still, film, 1);
  ASSERT_EQ(detections.size(), 1u);
  EXPECT_EQ(detections[0].tag_id, 4);
  // Bottom-left: 0.2 m to port, 0.2 m down.
  EXPECT_NEAR(detections[0].corners[0].x(), 401.3 - 640.0 * 0.2 / 3.5, 1e-9);
  EXPECT_NEAR(detections[0].corners[0].y(), 297.6 + 641.0 * 0.2 / 3.5, 1e-9);
  EXPECT_NEAR(detections[0].corners[2].x(), 401.3 + 640.0 * 0.2 / 3.5, 1e-9);
  EXPECT_NEAR(detections[0].corners[2].y(), 297.6 - 641.0 * 0.2 / 3.5, 1e-9);
}

TEST(Film, HoldsWhatIsNotDriven) {
  Film film = Wall();
  const auto surge = PosesOf("surge", film);
  double x_most = 0.0, square = 0.0;
  for (const StampedPose& it : surge) {
    x_most = std::max(x_most, std::abs(it.pose.translation.x()));
    square += it.pose.translation.y() * it.pose.translation.y();
  }
  EXPECT_GT(x_most, 0.5);
  // Three sines of a few periods: within a factor of 2 of the size asked.
  const double sway = std::sqrt(square / static_cast<double>(surge.size()));
  EXPECT_GT(sway, 0.005);
  EXPECT_LT(sway, 0.02);
  film.hold_position = film.hold_angle = 0.0;
  for (const StampedPose& it : PosesOf("heave", film)) {
    EXPECT_EQ(it.pose.translation.x(), 0.0);
    EXPECT_EQ(it.pose.rotation.w(), 1.0);
  }
}

TEST(Film, AddsNoiseOfTheSizeAskedAndOutliers) {
  Film film = Wall();
  Film exact = film;
  exact.corner_sigma = 0.0;
  film.outlier_probability = 0.1;
  film.outlier_size = 50.0;
  const auto poses = PosesOf("yaw", film);
  const auto seen = FilmCorners(poses, film, 7);
  const auto truth = FilmCorners(poses, exact, 7);
  ASSERT_EQ(seen.size(), truth.size());
  ASSERT_EQ(seen.size(), 200u);
  int num_outliers = 0, num = 0;
  double square = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    double most = 0.0, sum = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector2d error = seen[i].corners[corner] - truth[i].corners[corner];
      most = std::max(most, error.norm());
      sum += error.squaredNorm();
    }
    if (most > 5.0) {
      ++num_outliers;
    } else {
      square += sum;
      num += 8;
    }
  }
  // 200 trials of 0.1: 20, give or take 4.2; 1400 numbers: sigma to 2 %.
  EXPECT_NEAR(num_outliers, 20, 17);
  EXPECT_NEAR(std::sqrt(square / num), 0.3, 4.0 * 0.02 * 0.3);
}

TEST(Film, MovesTheCameraDuringTheExposure) {
  Film film = Wall();
  film.exposure = 0.08;
  film.rig.body_from_camera = {};
  std::vector<StampedPose> poses(3);
  for (int i = 0; i < 3; ++i) {
    poses[i].time = 0.1 * i;
    poses[i].pose.translation = {0.2 * i, 0.0, 0.0};                                 // 2 m/s
    poses[i].pose.rotation = Eigen::AngleAxisd(0.05 * i, Eigen::Vector3d::UnitZ());  // 0.5 rad/s
  }
  const auto during = PosesDuringExposure(poses, 1, film);
  ASSERT_GT(during.size(), 4u);
  const double share = 0.5 - 0.5 / static_cast<double>(during.size());
  EXPECT_NEAR(during.front().translation.x(), 0.2 - 2.0 * 0.08 * share, 1e-12);
  EXPECT_NEAR(during.back().translation.x(), 0.2 + 2.0 * 0.08 * share, 1e-12);
  EXPECT_NEAR(2.0 * std::asin(during.back().rotation.z()), 0.05 + 0.5 * 0.08 * share, 1e-12);
  film.exposure = 0.0;
  EXPECT_EQ(PosesDuringExposure(poses, 1, film).size(), 1u);
}

TEST(ReadFilmFile, ReadsTheBundledFilms) {
  EXPECT_EQ(Wall().rig.map.markers.size(), 1u);
  EXPECT_EQ(Wall().view.noise, 2.0);
  const Film four = ReadFilmFile(kData / "films/wall_four.yaml");
  EXPECT_EQ(four.true_map.Families().size(), 2u);
}

TEST(ReadFilmFile, RefusesWhatItDoesNotKnow) {
  const std::filesystem::path file = TestFolder() / "film.yaml";
  const std::string folder = (kData / "films").string();
  const std::string start = "camera: " + folder + "/wall_camera.yaml\ntags: " + folder +
                            "/wall_one_tag.yaml\nmount: " + folder + "/wall_mount.yaml\n";
  WriteFile(file, start + "exposure: 0.2\n");
  EXPECT_THROW(ReadFilmFile(file), InputError);  // longer than from frame to frame
  WriteFile(file, start + "shutter: 0.02\n");
  EXPECT_THROW(ReadFilmFile(file), InputError);
  WriteFile(file, start + "exposure: 0.02\n");
  EXPECT_EQ(ReadFilmFile(file).exposure, 0.02);
}

}  // namespace
}  // namespace fathom
