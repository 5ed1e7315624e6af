// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/page.h"

#include "fathom/report/web/assets.h"

namespace fathom {

std::string RenderPage(const Page& page) { return "<!doctype html>" + page.title; }

}  // namespace fathom
