// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"
#include "fathom/report/table.h"

#include <span>
#include <string>

namespace fathom {

// What the columns of the tables mean that need a word, and what a free run is where a row tells of
// one, a line each; empty where there is nothing to explain.
std::string LegendOf(std::span<const Table> tables);

// The line below the NMAE of the models that says what noise alone gives; empty where that is not
// known.
std::string NoiseFloorText(const Diagnosis& diagnosis);

}  // namespace fathom
