// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/camera_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::int64_t kLargestSide = 100000;  // [px]

void SetSize(const YamlMap& map,
             std::string_view key,
             std::int64_t width,
             std::int64_t height,
             CameraModel* camera) {
  if (std::min(width, height) < 1 || std::max(width, height) > kLargestSide) {
    map.Fail(
        key,
        fmt::format(
            "gives an image of {} x {} pixels, expected 1 to {}.", width, height, kLargestSide));
  }
  camera->width = static_cast<int>(width);
  camera->height = static_cast<int>(height);
}

void SetIntrinsics(const YamlMap& map,
                   std::string_view key,
                   const std::array<double, 4>& fx_fy_cx_cy,
                   CameraModel* camera) {
  const auto [fx, fy, cx, cy] = fx_fy_cx_cy;
  if (!(fx > 0.0 && fy > 0.0)) {
    map.Fail(key, fmt::format("has focal lengths {:g} and {:g}, expected above 0 px.", fx, fy));
  }
  camera->fx = fx;
  camera->fy = fy;
  camera->cx = cx;
  camera->cy = cy;
  if (!camera->Contains({cx, cy})) {
    map.Fail(key,
             fmt::format("has its optical centre at ({:g}, {:g}), expected it on the image of {} x "
                         "{} pixels. Is this the calibration of another resolution?",
                         cx,
                         cy,
                         camera->width,
                         camera->height));
  }
}

// Coefficients in the order of the lens, any of `counts` many.
void SetCoefficients(const YamlMap& map,
                     std::string_view key,
                     const std::vector<double>& numbers,
                     const std::vector<std::size_t>& counts,
                     CameraModel* camera) {
  if (std::find(counts.begin(), counts.end(), numbers.size()) == counts.end()) {
    map.Fail(key,
             fmt::format("holds {} numbers, expected {}{} for this distortion_model.",
                         numbers.size(),
                         counts.front(),
                         counts.size() > 1 ? fmt::format(" or {}", counts.back()) : ""));
  }
  std::copy(numbers.begin(), numbers.end(), camera->coefficients.begin());
  constexpr double kSmallestField = 0.05;  // [rad], 3 degrees
  if (const double angle = LargestAngle(*camera); angle < kSmallestField) {
    map.Fail(key,
             fmt::format("holds coefficients that fold the image {:.2g} degrees off its centre, "
                         "expected those of a lens. Check their order.",
                         angle * 57.29578));
  }
}

// No coefficients, or zeros.
void RequireNoDistortion(const YamlMap& map,
                         std::string_view key,
                         const std::vector<double>& numbers) {
  if (std::all_of(numbers.begin(), numbers.end(), [](double k) { return k == 0.0; })) return;
  map.Fail(key, "holds numbers other than 0, expected none for distortion_model 'none'.");
}

[[noreturn]] void FailLens(const YamlMap& map, const std::string& name, const char* expected) {
  map.Fail("distortion_model", fmt::format("is {}, expected {}.", Quoted(name), expected));
}

// {rows: .., cols: .., data: [..]}
std::vector<double> MatrixAt(const YamlMap& map, std::string_view key) {
  const YamlMap matrix = map.Map(key);
  const std::int64_t rows = matrix.Integer("rows");
  const std::int64_t cols = matrix.Integer("cols");
  std::vector<double> data = matrix.Numbers("data");
  matrix.Ignore("dt");  // of OpenCV's files
  constexpr std::int64_t kMost = 100;
  if (rows < 0 || cols < 0 || rows > kMost || cols > kMost ||
      rows * cols != static_cast<std::int64_t>(data.size())) {
    matrix.Fail("data",
                fmt::format("holds {} numbers, expected {} x {}.", data.size(), rows, cols));
  }
  return data;
}

CameraModel ReadCameraInfo(const YamlMap& file) {
  CameraModel camera;
  const std::int64_t width = file.Integer("image_width");
  const std::int64_t height = file.Integer("image_height");
  SetSize(file, "image_width", width, height, &camera);
  for (const char* key : {"camera_name", "rectification_matrix", "projection_matrix"}) {
    file.Ignore(key);
  }
  const std::vector<double> matrix = MatrixAt(file, "camera_matrix");
  if (matrix.size() != 9 || matrix[1] != 0.0 || matrix[3] != 0.0 || matrix[6] != 0.0 ||
      matrix[7] != 0.0 || matrix[8] != 1.0) {
    file.Fail("camera_matrix", "is not of the form [fx, 0, cx, 0, fy, cy, 0, 0, 1], as expected.");
  }
  SetIntrinsics(file, "camera_matrix", {matrix[0], matrix[4], matrix[2], matrix[5]}, &camera);

  constexpr char kCoefficients[] = "distortion_coefficients";
  const std::string lens = file.String("distortion_model");
  if (lens == "none" && !file.Has(kCoefficients)) return camera;
  const std::vector<double> numbers = MatrixAt(file, kCoefficients);
  if (lens == "plumb_bob") {
    camera.lens = LensModel::kPlumbBob;
    SetCoefficients(file, kCoefficients, numbers, {5, 4}, &camera);
  } else if (lens == "rational_polynomial") {
    camera.lens = LensModel::kRationalPolynomial;
    SetCoefficients(file, kCoefficients, numbers, {8}, &camera);
  } else if (lens == "equidistant" || lens == "fisheye") {
    camera.lens = LensModel::kEquidistant;
    SetCoefficients(file, kCoefficients, numbers, {4}, &camera);
  } else if (lens == "none") {
    RequireNoDistortion(file, kCoefficients, numbers);
  } else {
    FailLens(file, lens, "plumb_bob, rational_polynomial, equidistant, fisheye or none");
  }
  return camera;
}

CameraModel ReadCamchain(const YamlMap& file,
                         const std::vector<std::string>& cameras,
                         std::vector<std::string>* remarks) {
  if (cameras.size() > 1) {
    file.Fail(fmt::format("holds {} cameras, expected the one that took the frames. Keep only it.",
                          cameras.size()));
  }
  const YamlMap map = file.Map(cameras.front());
  for (const char* key : {"cam_overlaps", "rostopic", "T_cam_imu", "T_cn_cnm1"}) map.Ignore(key);
  if (const double shift = map.Number("timeshift_cam_imu", 0.0); shift != 0.0 && remarks) {
    remarks->push_back(
        fmt::format("camera.yaml: timeshift_cam_imu is {} s and not used: where the camera's clock "
                    "is off, shift the stamps of the frames.",
                    shift));
  }
  if (const std::string model = map.String("camera_model"); model != "pinhole") {
    map.Fail("camera_model", fmt::format("is {}, expected pinhole.", Quoted(model)));
  }
  CameraModel camera;
  const std::vector<double> size = map.Numbers("resolution", 2);
  for (const double side : size) {
    if (!(side >= 1.0 && side <= kLargestSide && side == std::floor(side))) {
      map.Fail("resolution",
               fmt::format("holds {:g}, expected whole pixels from 1 to {}.", side, kLargestSide));
    }
  }
  SetSize(map,
          "resolution",
          static_cast<std::int64_t>(size[0]),
          static_cast<std::int64_t>(size[1]),
          &camera);
  const std::vector<double> numbers = map.Numbers("intrinsics", 4);
  SetIntrinsics(map, "intrinsics", {numbers[0], numbers[1], numbers[2], numbers[3]}, &camera);

  constexpr char kCoefficients[] = "distortion_coeffs";
  const std::string lens = map.String("distortion_model");
  if (lens == "none" && !map.Has(kCoefficients)) return camera;
  const std::vector<double> coefficients = map.Numbers(kCoefficients);
  if (lens == "radtan") {
    camera.lens = LensModel::kPlumbBob;
    SetCoefficients(map, kCoefficients, coefficients, {4}, &camera);
  } else if (lens == "equidistant") {
    camera.lens = LensModel::kEquidistant;
    SetCoefficients(map, kCoefficients, coefficients, {4}, &camera);
  } else if (lens == "none") {
    RequireNoDistortion(map, kCoefficients, coefficients);
  } else {
    FailLens(map, lens, "radtan, equidistant or none");
  }
  return camera;
}

// "cam0", "cam1": the keys of a camchain.
std::vector<std::string> CamerasOf(const YamlMap& file) {
  std::vector<std::string> cameras;
  for (const std::string& key : file.Keys()) {
    if (key.size() > 3 && key.starts_with("cam") &&
        key.find_first_not_of("0123456789", 3) == std::string::npos) {
      cameras.push_back(key);
    }
  }
  return cameras;
}

}  // namespace

CameraModel ReadCameraFile(const std::filesystem::path& path, std::vector<std::string>* remarks) {
  return ParseCameraFile(path.string(), ReadFile(path), remarks);
}

CameraModel ParseCameraFile(const std::string& name,
                            const std::string& text,
                            std::vector<std::string>* remarks) {
  const YamlMap file = ParseYaml(name, text);
  const std::vector<std::string> cameras = CamerasOf(file);
  const CameraModel camera =
      cameras.empty() ? ReadCameraInfo(file) : ReadCamchain(file, cameras, remarks);
  file.Finish();
  return camera;
}

void RequireFrameSize(const CameraModel& camera,
                      const std::string& camera_file,
                      const std::string& frames,
                      int width,
                      int height) {
  if (camera.width == width && camera.height == height) return;
  throw InputError(
      fmt::format("{}: is {} x {} pixels, expected {} x {} as in {}. Calibrate the camera at the "
                  "size of its frames, or give the calibration that belongs to them.",
                  frames,
                  width,
                  height,
                  camera.width,
                  camera.height,
                  camera_file));
}

}  // namespace fathom
