// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/tag_family.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <array>
#include <map>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagCircle49h12.h>
#include <apriltag/tagCustom48h12.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>
}

namespace fathom {
namespace {

struct KnownFamily {
  std::string_view name;
  apriltag_family* (*create)();
  void (*destroy)(apriltag_family*);
};

constexpr std::array<KnownFamily, 9> kFamilies = {{
    {"tag16h5", tag16h5_create, tag16h5_destroy},
    {"tag25h9", tag25h9_create, tag25h9_destroy},
    {"tag36h10", tag36h10_create, tag36h10_destroy},
    {"tag36h11", tag36h11_create, tag36h11_destroy},
    {"tagCircle21h7", tagCircle21h7_create, tagCircle21h7_destroy},
    {"tagCircle49h12", tagCircle49h12_create, tagCircle49h12_destroy},
    {"tagCustom48h12", tagCustom48h12_create, tagCustom48h12_destroy},
    {"tagStandard41h12", tagStandard41h12_create, tagStandard41h12_destroy},
    {"tagStandard52h13", tagStandard52h13_create, tagStandard52h13_destroy},
}};

}  // namespace

const std::vector<std::string>& TagFamilies() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const KnownFamily& family : kFamilies) all.emplace_back(family.name);
    return all;
  }();
  return names;
}

TagFamilyPtr CreateTagFamily(const std::string& name) {
  for (const KnownFamily& family : kFamilies) {
    if (family.name == name) return {family.create(), family.destroy};
  }
  throw InputError(fmt::format("tag family {} is not known, expected one of {}.",
                               Quoted(name),
                               fmt::join(TagFamilies(), ", ")));
}

int NumTagsOf(const std::string& family) {
  // Making a family of 48 000 codes takes as long as reading a file.
  static const std::map<std::string, int> nums = [] {
    std::map<std::string, int> all;
    for (const std::string& name : TagFamilies()) {
      all[name] = static_cast<int>(CreateTagFamily(name)->ncodes);
    }
    return all;
  }();
  const auto found = nums.find(family);
  return found != nums.end() ? found->second : static_cast<int>(CreateTagFamily(family)->ncodes);
}

TagPattern PatternOf(const std::string& family_name, int tag_id) {
  const TagFamilyPtr family = CreateTagFamily(family_name);
  if (tag_id < 0 || static_cast<std::uint32_t>(tag_id) >= family->ncodes) {
    throw InputError(fmt::format("tag family {} has no tag {}, expected an id from 0 to {}.",
                                 family_name,
                                 tag_id,
                                 family->ncodes - 1));
  }
  const std::unique_ptr<image_u8_t, void (*)(image_u8_t*)> image(
      apriltag_to_image(family.get(), tag_id), image_u8_destroy);
  TagPattern pattern;
  pattern.width = image->width;
  pattern.border_width = family->width_at_border;
  for (int row = 0; row < image->height; ++row) {
    const std::uint8_t* first = image->buf + row * image->stride;
    pattern.cells.insert(pattern.cells.end(), first, first + image->width);
  }
  return pattern;
}

}  // namespace fathom
