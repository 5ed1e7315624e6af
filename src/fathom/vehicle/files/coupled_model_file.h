// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace fathom {

// The text of a model file of several DOFs, schema "fathom-model-2"; docs/file_formats.md.
std::string FormatCoupledModel(const FittedCoupledModel& model);

// Of such a text, or of a verdict file of several DOFs, which holds one. Throws InputError, naming
// the file and the key, for whatever cannot be a model. `name` stands for the file in messages.
FittedCoupledModel ParseCoupledModel(const std::string& name, std::string_view text);
FittedCoupledModel ReadCoupledModel(const std::filesystem::path& path);

// Whether a text is a model or verdict file of several DOFs: what its schema says. False for what
// is no JSON.
bool IsCoupledModel(std::string_view text);

}  // namespace fathom
