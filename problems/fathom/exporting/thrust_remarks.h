// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

#include <string>
#include <vector>

namespace fathom {

// Adds a sentence where commands are not in newtons: numbers are then only ratios.
void AddUnitRemark(const ExportModel& model, std::vector<std::string>* remarks);

// Adds a sentence for each thrust gain whose thruster the vehicle file does not have.
void AddGainRemarks(const ExportModel& model,
                    const ExportTarget& target,
                    std::vector<std::string>* remarks);

}  // namespace fathom
