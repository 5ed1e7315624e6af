// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/vrx.h"

#include <cmath>
#include <string>

#include "exported_xml.h"
#include "generic_models.h"
#include "written_out_rate.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

pugi::xml_node VrxPluginIn(const ExportedFile& file, pugi::xml_document* document) {
  Parse(file, document);
  return document->child("sdf").child("model").child("plugin");
}

// Its elements all have defaults other than 0, so that all are written: osrf/vrx,
// vrx_gz/src/SimpleHydrodynamics.cc (7f00977b).
TEST(VrxModel, HasTheNamesOfThePlugin) {
  pugi::xml_document document;
  const auto plugin =
      VrxPluginIn(VrxModel(ExportModelOf(GenericBoat(), "boat.json"), GenericTarget()), &document);
  EXPECT_STREQ(plugin.attribute("name").as_string(), "vrx::SimpleHydrodynamics");
  EXPECT_THAT(NamesBelow(plugin),
              UnorderedElementsAre("link_name",
                                   "xDotU",
                                   "yDotV",
                                   "zDotW",
                                   "kDotP",
                                   "mDotQ",
                                   "nDotR",
                                   "xU",
                                   "xUU",
                                   "yV",
                                   "yVV",
                                   "zW",
                                   "zWW",
                                   "kP",
                                   "kPP",
                                   "mQ",
                                   "mQQ",
                                   "nR",
                                   "nRR"));
}

// The plugin's law: -M_A dnu/dt - (X_u + X_uu |u|) u and its like.
TEST(VrxModel, HasTheDiagonalOfTheModel) {
  const CoupledModel model = GenericBoat().model;
  pugi::xml_document document;
  const auto plugin =
      VrxPluginIn(VrxModel(ExportModelOf(GenericBoat(), "boat.json"), GenericTarget()), &document);
  const struct {
    int at;
    const char *added, *linear, *quadratic;
    double body;
  } dofs[] = {{0, "xDotU", "xU", "xUU", 30.0},
              {1, "yDotV", "yV", "yVV", 30.0},
              {5, "nDotR", "nR", "nRR", 2.3}};
  for (const auto& dof : dofs) {
    EXPECT_NEAR(NumberOf(plugin, dof.added) + dof.body, model.inertia(dof.at, dof.at), 1e-12);
    EXPECT_EQ(NumberOf(plugin, dof.linear), model.linear_damping(dof.at, dof.at));
    EXPECT_EQ(NumberOf(plugin, dof.quadratic), model.quadratic_damping(dof.at, dof.at));
  }
  EXPECT_EQ(NumberOf(plugin, "zW"), 0.0);
}

TEST(VrxModel, NamesWhatItCannotHold) {
  const ExportedFile file = VrxModel(ExportModelOf(GenericRov(), "rov.json"), GenericTarget());
  for (const char* said :
       {"VRX before jazzy computes the Coriolis forces",
        "inertia.sway.yaw of 2.2 kg m is left out: the plugin takes the diagonal",
        "linear_damping.yaw.sway of -0.4 kg m/s is left out",
        "quadratic_damping.sway.roll of 0.2 kg m is left out",
        "net_buoyancy of 2 N is left out: the hull of vrx::Surface",
        "righting_moment.pitch of 7 N m is left out",
        "offset.pitch of 0.15 N m is left out"}) {
    EXPECT_THAT(file.remarks, Contains(HasSubstr(said)));
  }
}

}  // namespace
}  // namespace fathom
