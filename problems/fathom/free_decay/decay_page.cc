// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_page.h"

#include "fathom/free_decay/decay_text.h"

#include <fmt/format.h>

namespace fathom {

PageSection DecaySection(const LogDecay& decay) {
  PageSection section;
  section.heading = fmt::format("Free decay of {}", Name(decay.dof));
  section.text = DecayComments(decay);
  if (!decay.summary.IsUsable()) return section;
  section.tables = {QuantityTable(decay)};
  const bool is_speed = decay.output == DecayOutput::kVelocity;
  Eigen::Index row = 0;
  for (const DecayStretch& stretch : decay.measured) {
    TimePanel& panel = section.time_panels.emplace_back();
    panel.quantity = fmt::format("{} {}", Name(decay.dof), is_speed ? "velocity" : "displacement");
    panel.unit = is_speed ? VelocityUnit(decay.dof) : DisplacementUnit(decay.dof);
    panel.time = stretch.time;
    panel.measured = Series{.name = "measured", .values = stretch.motion};
    Series& simulated = panel.responses.emplace_back();
    simulated.name = "free decay";
    for (const double measured : stretch.motion) {
      simulated.values.push_back(measured + decay.summary.residuals[row++]);
    }
  }
  return section;
}

}  // namespace fathom
