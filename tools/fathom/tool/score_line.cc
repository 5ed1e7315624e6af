// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/score_line.h"

#include "fathom/report/format_value.h"

#include <fmt/format.h>

namespace fathom {

std::string ScoreLine(const char* part, const FitFigures& figures, Dof dof) {
  if (figures.num_samples == 0) return "";
  return fmt::format("{}{}: velocity MAE {:.5f} {}, velocity NMAE {} over {} samples, {:.0f} s\n",
                     Name(dof),
                     part,
                     figures.mae,
                     VelocityUnit(dof),
                     ShareText(figures.nmae, 4),
                     figures.num_samples,
                     figures.duration);
}

}  // namespace fathom
