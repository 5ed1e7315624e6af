// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/tag_detector.h"

#include "fathom/base/input_error.h"
#include "fathom/camera/tag_family.h"
#include "fathom/detect/image_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glog/logging.h>

extern "C" {
#include <apriltag/apriltag.h>
}

namespace fathom {
namespace {

// The difference of grey values in a patch that libapriltag takes for one of black and white.
int SmallestContrast(const GrayImage& image, double noise_margin) {
  constexpr int kLeast = 5;  // libapriltag's own
  constexpr int kMost = 30;  // texture may pass for noise: a tag of more contrast is never lost
  if (noise_margin == 0.0) return kLeast;
  return std::clamp(static_cast<int>(std::lround(noise_margin * NoiseOf(image))), kLeast, kMost);
}

// libapriltag takes the whole part of every other factor, and then finds nothing.
bool CanDecimateBy(double factor) {
  return factor == 1.5 || (factor >= 1.0 && factor <= 16.0 && factor == std::floor(factor));
}

// The shorter side of the image in which quads are looked for [px].
int DecimatedSide(const GrayImage& image, double factor) {
  const int side = std::min(image.width, image.height);
  return factor == 1.5 ? side / 3 * 2 : 1 + (side - 1) / static_cast<int>(factor);
}

// libapriltag reads and writes beyond an image whose shorter side is less than a tile of its
// threshold, or than half the kernel of its blur. No tag fits into so little.
int LeastDecimatedSide(double quad_sigma) {
  constexpr int kTile = 4;
  const int kernel = static_cast<int>(4.0 * quad_sigma) | 1;
  return std::max(kTile, (kernel + 1) / 2);
}

}  // namespace

std::vector<std::string> TagDetectorOptions::Problems() const {
  std::vector<std::string> problems;
  const auto require = [&](bool rule, const std::string& problem) {
    if (!rule) problems.push_back(problem);
  };
  require(CanDecimateBy(quad_decimate),
          fmt::format("quad_decimate is {}, expected 1.5 or a whole number from 1 to 16",
                      quad_decimate));
  require(quad_sigma >= 0.0 && quad_sigma <= 16.0,
          fmt::format("quad_sigma is {}, expected 0 to 16 px", quad_sigma));
  require(noise_margin >= 0.0 && noise_margin <= 100.0,
          fmt::format("noise_margin is {}, expected 0 to 100", noise_margin));
  require(decode_sharpening >= 0.0 && decode_sharpening <= 10.0,
          fmt::format("decode_sharpening is {}, expected 0 to 10", decode_sharpening));
  // Each further bit multiplies libapriltag's table of codes by the number of bits.
  require(max_hamming >= 0 && max_hamming <= 2,
          fmt::format("max_hamming is {}, expected 0, 1 or 2", max_hamming));
  require(num_threads >= 1 && num_threads <= 256,
          fmt::format("num_threads is {}, expected 1 to 256", num_threads));
  return problems;
}

struct TagDetector::Implementation {
  std::vector<TagFamilyPtr> families;
  std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector{
      apriltag_detector_create(), apriltag_detector_destroy};

  // The detector first, which holds pointers to the families.
  ~Implementation() {
    apriltag_detector_clear_families(detector.get());
    detector.reset();
  }
};

TagDetector::TagDetector(const std::vector<std::string>& families,
                         const TagDetectorOptions& options)
    : options_(options), implementation_(std::make_unique<Implementation>()) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("tag detector: {}.", fmt::join(problems, "; ")));
  }
  if (families.empty()) throw InputError("tag detector: no tag family, expected at least one.");
  apriltag_detector_t* detector = implementation_->detector.get();
  for (const std::string& name : families) {
    implementation_->families.push_back(CreateTagFamily(name));
    const TagFamilyPtr& family = implementation_->families.back();
    apriltag_detector_add_family_bits(detector, family.get(), std::max(1, options.max_hamming));
    if (family->impl == nullptr) {  // its table of codes
      throw InputError(
          fmt::format("tag detector: not enough memory for the codes of {} with up to {} wrong "
                      "bits. Allow fewer (max_hamming).",
                      name,
                      std::max(1, options.max_hamming)));
    }
  }
  detector->quad_decimate = static_cast<float>(options.quad_decimate);
  detector->quad_sigma = static_cast<float>(options.quad_sigma);
  detector->refine_edges = options.refine_edges;
  detector->decode_sharpening = options.decode_sharpening;
  detector->nthreads = options.num_threads;
}

TagDetector::~TagDetector() = default;
TagDetector::TagDetector(TagDetector&&) noexcept = default;
TagDetector& TagDetector::operator=(TagDetector&&) noexcept = default;

std::vector<TagSighting> TagDetector::Detect(const GrayImage& image) {
  CHECK_EQ(image.pixels.size(),
           static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  if (DecimatedSide(image, options_.quad_decimate) < LeastDecimatedSide(options_.quad_sigma)) {
    return {};
  }
  // libapriltag only reads the image, but asks for a pointer that may write.
  apriltag_detector_t* detector = implementation_->detector.get();
  detector->qtp.min_white_black_diff = SmallestContrast(image, options_.noise_margin);
  image_u8_t view = {.width = image.width,
                     .height = image.height,
                     .stride = image.width,
                     .buf = const_cast<std::uint8_t*>(image.pixels.data())};
  const std::unique_ptr<zarray_t, void (*)(zarray_t*)> found(
      apriltag_detector_detect(detector, &view), apriltag_detections_destroy);
  std::vector<TagSighting> sightings;
  for (int i = 0; i < zarray_size(found.get()); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(found.get(), i, &detection);
    TagSighting sighting;
    sighting.family = detection->family->name;
    sighting.tag_id = detection->id;
    sighting.hamming = detection->hamming;
    sighting.decision_margin = detection->decision_margin;
    for (int corner = 0; corner < 4; ++corner) {
      sighting.corners[corner] = {detection->p[corner][0] - 0.5, detection->p[corner][1] - 0.5};
    }
    sightings.push_back(std::move(sighting));
  }
  return sightings;
}

}  // namespace fathom
