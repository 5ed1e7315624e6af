// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct apriltag_family;  // of libapriltag

namespace fathom {

// The names of the tag families that libapriltag knows: "tag16h5", "tag36h11", ...
const std::vector<std::string>& TagFamilies();

using TagFamilyPtr = std::unique_ptr<apriltag_family, void (*)(apriltag_family*)>;

// A family of tags, of libapriltag. Throws InputError, listing the families there are, if it knows
// none of this name.
TagFamilyPtr CreateTagFamily(const std::string& name);

// Its tags have the ids from 0 on, below this. Throws as CreateTagFamily().
int NumTagsOf(const std::string& family);

// The picture of a tag as it is printed: square cells, row by row from the top left of the upright
// tag.
struct TagPattern {
  int width = 0;                    // of the whole, in cells, with the light margin if it has one
  int border_width = 0;             // of the square whose corners are detected, in the middle of it
  std::vector<std::uint8_t> cells;  // 0 black to 255 white

  std::uint8_t At(int column, int row) const { return cells[row * width + column]; }
};

// Throws InputError if there is no such family, or it has no such tag.
TagPattern PatternOf(const std::string& family, int tag_id);

}  // namespace fathom
