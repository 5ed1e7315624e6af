// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_diagnosis.h"

#include <string>

namespace fathom {

// The text of a verdict file of several DOFs, schema "fathom-verdict-2"; docs/file_formats.md. It
// holds the accepted model, which ReadCoupledModel() reads back.
std::string FormatCoupledVerdict(const CoupledDiagnosis& diagnosis,
                                 const CoupledIdentification& identified);

}  // namespace fathom
