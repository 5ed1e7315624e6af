// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/camera_file.h"

#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr char kRos[] =
    "image_width: 640\n"
    "image_height: 480\n"
    "camera_name: front\n"
    "camera_matrix: {rows: 3, cols: 3, data: [600, 0, 320.5, 0, 590, 241, 0, 0, 1]}\n"
    "distortion_model: plumb_bob\n"
    "distortion_coefficients: {rows: 1, cols: 5, data: [-0.1, 0.01, 0.002, -0.003, 0.004]}\n"
    "rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}\n"
    "projection_matrix: {rows: 3, cols: 4, data: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]}\n";

constexpr char kKalibr[] =
    "cam0:\n"
    "  cam_overlaps: []\n"
    "  camera_model: pinhole\n"
    "  distortion_coeffs: [-0.21, 0.06, 0.0013, -0.0021]\n"
    "  distortion_model: radtan\n"
    "  intrinsics: [812.5, 808.25, 633.1, 487.4]\n"
    "  resolution: [1280, 960]\n"
    "  rostopic: /camera/image_raw\n";

std::string With(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string Error(const std::string& text) {
  return ErrorFrom([&] { ParseCameraFile("camera.yaml", text); });
}

TEST(CameraFile, ReadsCameraInfo) {
  const CameraModel camera = ParseCameraFile("camera.yaml", kRos);
  EXPECT_EQ(camera.width, 640);
  EXPECT_EQ(camera.height, 480);
  EXPECT_EQ(camera.fx, 600.0);
  EXPECT_EQ(camera.fy, 590.0);
  EXPECT_EQ(camera.cx, 320.5);
  EXPECT_EQ(camera.cy, 241.0);
  EXPECT_EQ(camera.lens, LensModel::kPlumbBob);
  EXPECT_THAT(camera.coefficients, ElementsAre(-0.1, 0.01, 0.002, -0.003, 0.004, 0, 0, 0));
}

TEST(CameraFile, ReadsEveryLensOfCameraInfo) {
  const auto lens_of = [](const std::string& name, const std::string& coefficients) {
    std::string text = With(kRos, "plumb_bob", name);
    return ParseCameraFile("camera.yaml",
                           With(text,
                                "{rows: 1, cols: 5, data: [-0.1, 0.01, 0.002, -0.003, 0.004]}",
                                coefficients))
        .lens;
  };
  EXPECT_EQ(lens_of("plumb_bob", "{rows: 1, cols: 4, data: [-0.1, 0, 0, 0]}"),
            LensModel::kPlumbBob);
  EXPECT_EQ(lens_of("rational_polynomial", "{rows: 8, cols: 1, data: [0, 0, 0, 0, 0, 0, 0, 0.1]}"),
            LensModel::kRationalPolynomial);
  EXPECT_EQ(lens_of("equidistant", "{rows: 4, cols: 1, data: [0, 0, 0, 0]}"),
            LensModel::kEquidistant);
  EXPECT_EQ(lens_of("fisheye", "{rows: 4, cols: 1, data: [0, 0, 0, 0]}"), LensModel::kEquidistant);
  EXPECT_EQ(lens_of("none", "{rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}"), LensModel::kNone);
}

TEST(CameraFile, ReadsACamchain) {
  const CameraModel camera = ParseCameraFile("camchain.yaml", kKalibr);
  EXPECT_EQ(camera.width, 1280);
  EXPECT_EQ(camera.height, 960);
  EXPECT_EQ(camera.fx, 812.5);
  EXPECT_EQ(camera.fy, 808.25);
  EXPECT_EQ(camera.cx, 633.1);
  EXPECT_EQ(camera.cy, 487.4);
  EXPECT_EQ(camera.lens, LensModel::kPlumbBob);
  EXPECT_THAT(camera.coefficients, ElementsAre(-0.21, 0.06, 0.0013, -0.0021, 0, 0, 0, 0));
  EXPECT_EQ(ParseCameraFile("camchain.yaml", With(kKalibr, "radtan", "equidistant")).lens,
            LensModel::kEquidistant);
}

TEST(CameraFile, NamesAClockOffsetThatIsNotApplied) {
  std::vector<std::string> remarks;
  ParseCameraFile("dive/camera.yaml", std::string(kKalibr) + "  timeshift_cam_imu: 0\n", &remarks);
  EXPECT_THAT(remarks, ElementsAre());
  ParseCameraFile(
      "dive/camera.yaml", std::string(kKalibr) + "  timeshift_cam_imu: 0.1\n", &remarks);
  EXPECT_THAT(remarks,
              ElementsAre("camera.yaml: timeshift_cam_imu is 0.1 s and not used: where the "
                          "camera's clock is off, shift the stamps of the frames."));
}

TEST(CameraFile, RefusesWhatIsNoCalibration) {
  EXPECT_EQ(Error("distortion_model: none\n"),
            "camera.yaml:1: key 'image_width' is missing, expected a whole number.");
  EXPECT_EQ(Error(With(kRos, "640", "0")),
            "camera.yaml:1: key 'image_width' gives an image of 0 x 480 pixels, expected 1 to "
            "100000.");
  EXPECT_EQ(Error(With(kRos, "320.5", "640")),
            "camera.yaml:4: key 'camera_matrix' has its optical centre at (640, 241), expected it "
            "on the image of 640 x 480 pixels. Is this the calibration of another resolution?");
  EXPECT_EQ(Error(With(kRos, "[600, 0,", "[600, 0.5,")),
            "camera.yaml:4: key 'camera_matrix' is not of the form [fx, 0, cx, 0, fy, cy, 0, 0, "
            "1], as expected.");
  EXPECT_EQ(Error(With(kRos, "590", "-590")),
            "camera.yaml:4: key 'camera_matrix' has focal lengths 600 and -590, expected above 0 "
            "px.");
  EXPECT_EQ(Error(With(kRos, "plumb_bob", "fov")),
            "camera.yaml:5: key 'distortion_model' is 'fov', expected plumb_bob, "
            "rational_polynomial, equidistant, fisheye or none.");
  EXPECT_EQ(Error(With(kRos, "plumb_bob", "equidistant")),
            "camera.yaml:6: key 'distortion_coefficients' holds 5 numbers, expected 4 for this "
            "distortion_model.");
  EXPECT_EQ(Error(With(kRos, "plumb_bob", "none")),
            "camera.yaml:6: key 'distortion_coefficients' holds numbers other than 0, expected "
            "none for distortion_model 'none'.");
  EXPECT_EQ(Error(With(kRos, "cols: 5", "cols: 6")),
            "camera.yaml:6: key 'distortion_coefficients.data' holds 5 numbers, expected 1 x 6.");
  // r (1 - 1000 r^2) turns back at r = 0.0183.
  EXPECT_EQ(Error(With(kRos, "-0.1,", "-1000,")),
            "camera.yaml:6: key 'distortion_coefficients' holds coefficients that fold the image 1 "
            "degrees off its centre, expected those of a lens. Check their order.");
  EXPECT_THAT(Error(With(kRos, "camera_name", "cameraname")),
              StartsWith("camera.yaml:3: key 'cameraname' is not known here"));
}

TEST(CameraFile, RefusesCamchainsItCannotUse) {
  EXPECT_EQ(Error(std::string(kKalibr) + "cam1: {camera_model: pinhole}\n"),
            "camera.yaml:1: holds 2 cameras, expected the one that took the frames. Keep only it.");
  EXPECT_EQ(Error(With(kKalibr, "pinhole", "omni")),
            "camera.yaml:3: key 'cam0.camera_model' is 'omni', expected pinhole.");
  EXPECT_EQ(Error(With(kKalibr, "radtan", "fov")),
            "camera.yaml:5: key 'cam0.distortion_model' is 'fov', expected radtan, equidistant or "
            "none.");
  EXPECT_EQ(Error(With(kKalibr, "1280, 960", "1280.5, 960")),
            "camera.yaml:7: key 'cam0.resolution' holds 1280.5, expected whole pixels from 1 to "
            "100000.");
  EXPECT_THAT(Error(With(kKalibr, "rostopic", "topic")), HasSubstr("'cam0.topic' is not known"));
}

TEST(CameraFile, RefusesFramesOfAnotherSize) {
  const CameraModel camera = ParseCameraFile("camera.yaml", kRos);
  EXPECT_NO_THROW(RequireFrameSize(camera, "camera.yaml", "a.png", 640, 480));
  EXPECT_EQ(ErrorFrom([&] { RequireFrameSize(camera, "log/camera.yaml", "a.png", 1280, 960); }),
            "a.png: is 1280 x 960 pixels, expected 640 x 480 as in log/camera.yaml. Calibrate "
            "the camera at the size of its frames, or give the calibration that belongs to "
            "them.");
}

}  // namespace
}  // namespace fathom
