// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_data.h"

#include <span>
#include <vector>

namespace fathom {

// Data to fit and data to predict: what one fold predicts, all others fit.
struct Fold {
  std::vector<CoupledData> train, unseen;
};

// Whole logs in turn where there are four or more, else a quarter of each; without what is held
// out.
std::vector<Fold> FoldsOf(std::span<const CoupledData> logs);

}  // namespace fathom
