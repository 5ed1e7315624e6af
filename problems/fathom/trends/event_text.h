// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/event_fit.h"
#include "fathom/trends/judged_event.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// One sentence on one cause of an event: "From dive 12 on the vehicle is 14 kg heavier (± 2) in
// surge, sway and heave: payload." Numbers after ± are standard deviations. `told` are the series
// that a sentence on an unnamed cause is about.
std::string EventText(const NamedCause& named,
                      std::span<const std::string> alternatives,
                      const EventFit& event,
                      const Column& column,
                      std::span<const DiveSeries> series,
                      std::span<const char> told,
                      std::span<const std::string> dive_names);

}  // namespace fathom
