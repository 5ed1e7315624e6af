// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

#include <string>
#include <vector>

namespace fathom {

// The text of a verdict file, schema "fathom-verdict-1"; docs/file_formats.md. ReadModel() reads
// the extended model back from it. `log_fingerprints` are FingerprintOf() the diagnosed logs, so
// that what belongs to one run is not taken for a trait of the vehicle.
std::string FormatVerdict(const Diagnosis& diagnosis,
                          const std::vector<std::string>& log_fingerprints = {});

// The extended model as a model file holds it, without log fingerprints.
FittedModel ModelOf(const Diagnosis& diagnosis, const DiagnosedModel& model);

}  // namespace fathom
