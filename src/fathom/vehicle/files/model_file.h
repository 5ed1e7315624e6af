// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace fathom {

// A parameter of an effect as files name it: "thruster_lag.time_constant",
// "velocity_coupling(sway).coefficient".
std::string KeyOf(const ActiveEffect& active, const EffectParameter& parameter);

// The text of a model file, schema "fathom-model-1"; docs/file_formats.md.
std::string FormatModel(const FittedModel& model);

// Reads a model file, or a verdict file ("fathom-verdict-1"), which holds one under "extended".
// Throws InputError, naming the file and the key, for whatever cannot be a model.
FittedModel ReadModel(const std::filesystem::path& path);

// The same from a text; `name` stands for the file in messages.
FittedModel ParseModel(const std::string& name, std::string_view text);

}  // namespace fathom
