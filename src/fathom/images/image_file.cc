// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/images/image_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <turbojpeg.h>

namespace fathom {
namespace {

constexpr int kLargestSide = 32768;  // [px]

const std::uint8_t* BytesOf(std::string_view text) {
  return reinterpret_cast<const std::uint8_t*>(text.data());
}

[[noreturn]] void FailToDecode(const std::string& name, const std::string& reason) {
  throw InputError(
      fmt::format("{}: cannot decode this image: {}. It is damaged or cut off; restore it from "
                  "its source.",
                  name,
                  reason));
}

void RequireSize(const std::string& name, int width, int height) {
  if (width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide) return;
  throw InputError(fmt::format("{}: the image has {} x {} pixels, expected at most {} a side.",
                               name,
                               width,
                               height,
                               kLargestSide));
}

// By libjpeg-turbo itself: only it tells of damaged data, which OpenCV decodes in silence.
GrayImage DecodeJpeg(const std::string& name, const std::string& bytes) {
  const std::unique_ptr<void, int (*)(void*)> decoder(tjInitDecompress(), tjDestroy);
  if (decoder == nullptr) throw std::bad_alloc();
  int width = 0, height = 0, subsampling = 0, colours = 0;
  if (tjDecompressHeader3(
          decoder.get(), BytesOf(bytes), bytes.size(), &width, &height, &subsampling, &colours) !=
      0) {
    FailToDecode(name, tjGetErrorStr2(decoder.get()));
  }
  RequireSize(name, width, height);
  GrayImage image(width, height);
  if (tjDecompress2(decoder.get(),
                    BytesOf(bytes),
                    bytes.size(),
                    image.pixels.data(),
                    width,
                    width,
                    height,
                    TJPF_GRAY,
                    TJFLAG_STOPONWARNING | TJFLAG_ACCURATEDCT) != 0) {
    FailToDecode(name, tjGetErrorStr2(decoder.get()));
  }
  return image;
}

// OpenCV asks every decoder it was built with, that of DICOM too, which ends the program where its
// data are damaged. Only what one of these takes for its own is let through; by their signatures,
// as OpenCV tells them.
bool IsOfKnownFormat(std::string_view bytes) {
  using std::string_view_literals::operator""sv;
  const bool is_netpbm = bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' &&
                         bytes[1] <= '6' && " \t\n\v\f\r"sv.find(bytes[2]) != bytes.npos;
  return is_netpbm || bytes.starts_with("\x89PNG\r\n\x1a\n"sv) || bytes.starts_with("BM"sv) ||
         bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv);
}

GrayImage FromMatrix(const cv::Mat& matrix) {
  GrayImage image(matrix.cols, matrix.rows);
  for (int v = 0; v < matrix.rows; ++v) {
    std::copy_n(
        matrix.ptr<std::uint8_t>(v), matrix.cols, &image.pixels[std::size_t(v) * matrix.cols]);
  }
  return image;
}

GrayImage DecodeByOpenCv(const std::string& name, const std::string& bytes) {
  cv::Mat matrix;
  try {
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
    matrix = cv::imdecode(
        buffer, cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception& error) {
    FailToDecode(name, error.err);
  }
  if (matrix.empty()) FailToDecode(name, "its data end too early");
  RequireSize(name, matrix.cols, matrix.rows);
  if (matrix.depth() != CV_8U) {
    throw InputError(name +
                     ": has more than 8 bits per pixel, expected 8. Convert it with a scale that "
                     "is the same for all images.");
  }
  return FromMatrix(matrix);
}

}  // namespace

GrayImage ReadImage(const std::filesystem::path& path) {
  return DecodeImage(path.string(), ReadFile(path));
}

GrayImage DecodeImage(const std::string& name, const std::string& bytes) {
  if (bytes.empty()) throw InputError(name + ": is empty, expected an image.");
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw InputError(fmt::format("{}: has {} bytes, expected an image.", name, bytes.size()));
  }
  if (bytes.starts_with("\xff\xd8")) return DecodeJpeg(name, bytes);
  if (!IsOfKnownFormat(bytes)) {
    throw InputError(name + ": is no image, expected JPEG, PNG, PGM, PPM, TIFF or BMP.");
  }
  return DecodeByOpenCv(name, bytes);
}

}  // namespace fathom
