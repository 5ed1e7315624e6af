// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/images/gray_image.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Settings of libapriltag. The defaults are those with the smallest corner errors that lose no
// small tag, in docs/vision.md ("Detection").
struct TagDetectorOptions {
  // Quads are looked for in an image smaller by this factor: 1.5, or a whole number from 1 to 16. 2
  // takes a third of the time, and tags of less than 50 px with it.
  double quad_decimate = 1.0;

  // Standard deviation of the blur before that [px]; 0: none. 0.8 saves time on noisy images, and
  // loses tags of less than 30 px.
  double quad_sigma = 0.0;

  // Where the grey values of a patch spread less than this many standard deviations of the image's
  // noise, no quad is looked for; 0: search everywhere. Sensor noise on a bare wall otherwise takes
  // ten times the time of all the rest.
  double noise_margin = 7.0;

  // Moves each edge to the strongest gradient near it, in the full image.
  bool refine_edges = true;

  double decode_sharpening = 0.25;

  // Bits of a tag's code that may be read wrongly, 0 to 2. With one, half of what is found in a
  // small family such as tag16h5 is not there.
  int max_hamming = 0;

  int num_threads = 1;

  // Every broken rule; empty if there is none.
  std::vector<std::string> Problems() const;
};

// A tag that the detector believes to see, whether or not it is one.
struct TagSighting {
  std::string family;
  int tag_id = 0;
  int hamming = 0;               // bits of the code that were read wrongly
  double decision_margin = 0.0;  // mean grey difference of a bit to the threshold

  // As Detection::corners: distorted pixels, the centre of the first pixel at (0, 0).
  std::array<Eigen::Vector2d, 4> corners;
};

// Finds tags of one or several families in images, by libapriltag. Tags whose codes have one wrong
// bit are reported even where max_hamming is 0, so that what is rejected can be counted.
//
// libapriltag puts the corner of the first pixel at (0, 0): half a pixel is taken off its corners.
class TagDetector {
 public:
  // Throws InputError if a family is not known, there is none, the options break a rule, or memory
  // does not suffice for the codes of a family with so many wrong bits.
  explicit TagDetector(const std::vector<std::string>& families,
                       const TagDetectorOptions& options = {});
  ~TagDetector();
  TagDetector(TagDetector&&) noexcept;
  TagDetector& operator=(TagDetector&&) noexcept;

  // In no order that means anything. None in an image too small for any tag.
  std::vector<TagSighting> Detect(const GrayImage& image);

  const TagDetectorOptions& options() const { return options_; }

 private:
  struct Implementation;

  TagDetectorOptions options_;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fathom
