// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/plan_request.h"
#include "fathom/planning/stamp_noise.h"

#include <Eigen/Core>

namespace fathom {

// The Fisher information about the parameters of `model` that measured stretches hold, docs/plan.md
// (6): by the sensitivities of the model's run over each, from the start that fits it best, which
// counts as unknown. What belongs to one run, as a current does, is unknown anew in each. `noise`:
// of one velocity, its colour over the samples. Throws InputError where the model's run
// diverges; `name` stands for its file in the message.
Eigen::MatrixXd FlownInformation(const FittedModel& model,
                                 const std::vector<Segment>& flown,
                                 const StampNoise& noise,
                                 const std::string& name);

// The same of the logs of a request; 0 without any.
Eigen::MatrixXd FlownInformation(const PlanRequest& request);

}  // namespace fathom
