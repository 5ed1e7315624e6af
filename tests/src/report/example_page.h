// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/page.h"

namespace fathom {

// A page as a comparison would fill it: surge, heave and yaw, each with a measured velocity of 3000
// stamps, four responses, the force, four parameters and a table. Made up, but the same every time.
Page ExamplePage();

}  // namespace fathom
