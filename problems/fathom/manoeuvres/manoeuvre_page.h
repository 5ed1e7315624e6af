// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/manoeuvres/manoeuvre_prediction.h"
#include "fathom/report/page.h"

#include <string>

namespace fathom {

// A manoeuvre as a page: the track with those of the drawn models, heading, rudder, yaw rate and
// speed over time with 95 % bands, and the figures beside what the log measured and the limits.
// `name`: as
// --manoeuvre gives it, `log`: the log's name. Without an origin.
Page ManoeuvrePage(const ManoeuvrePrediction& report,
                   const std::string& name,
                   const std::string& log);

}  // namespace fathom
