// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/ordinary_dives/ordinary_dives.h"
#include "fathom/report/page.h"

namespace fathom {

// The chosen stretches on the speed of each log that holds some, and what they tell. Of dives that
// are usable.
Page OrdinaryPage(const OrdinaryRequest& request, const OrdinaryDives& dives);

}  // namespace fathom
