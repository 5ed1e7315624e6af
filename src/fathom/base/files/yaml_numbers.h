// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/files/yaml_file.h"

#include <string_view>

namespace fathom {

// Numbers of an experiment file within bounds. Each throws InputError, naming file, line and key,
// for what lies outside.

inline constexpr double kLargest = 1e9;  // of any amplitude: no force or position is larger

// `number`, which was found under `key`.
double Within(const YamlMap& map, std::string_view key, double number, double from, double to);

double NumberWithin(const YamlMap& map, std::string_view key, double from, double to);
double NumberWithin(
    const YamlMap& map, std::string_view key, double from, double to, double if_missing);

// Above 0.
double Positive(const YamlMap& map, std::string_view key);

double Amplitude(const YamlMap& map, std::string_view key);

}  // namespace fathom
