// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/yaml_without.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(YamlWithout, LeavesOutTheKeyWithAllBelowIt) {
  EXPECT_EQ(
      YamlWithout("# a rov\nname: rov\nmodel:\n  mass: 1.20\n  more: {x: 2}\nsize: [1, 0.50]\n",
                  "model"),
      "name: rov\nsize: [1, 0.50]\n");
  EXPECT_EQ(YamlWithout("{name: rov, model: {mass: 2}}", "model"), "{name: rov}\n");
}

TEST(YamlWithout, LeavesAFileWithoutTheKeyAsItIs) {
  EXPECT_EQ(YamlWithout("name: rov\nsize: [1, 0.50]\n", "model"), "name: rov\nsize: [1, 0.50]\n");
}

}  // namespace
}  // namespace fathom
