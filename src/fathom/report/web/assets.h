// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

// The files that a page carries inside it, embedded at build time.
namespace fathom::web {

extern const std::string_view uplot_js;
extern const std::string_view uplot_css;
extern const std::string_view uplot_license;
extern const std::string_view chart_style_js;
extern const std::string_view time_cuts_js;
extern const std::string_view time_plot_js;
extern const std::string_view legend_js;
extern const std::string_view chart_keys_js;
extern const std::string_view chart_touch_js;
extern const std::string_view csv_js;
extern const std::string_view reload_js;
extern const std::string_view page_selftest_js;
extern const std::string_view page_js;
extern const std::string_view page_css;

}  // namespace fathom::web
