// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

// The files that an archive page carries inside it, embedded at build time.
namespace fathom::web {

extern const std::string_view archive_css;
extern const std::string_view dom_js;
extern const std::string_view parameter_charts_js;
extern const std::string_view effect_matrix_js;
extern const std::string_view dive_table_js;
extern const std::string_view dive_comparison_js;
extern const std::string_view archive_selftest_js;
extern const std::string_view archive_js;

}  // namespace fathom::web
