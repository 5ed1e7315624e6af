// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/joint_identification.h"

#include "fathom/joint_refinement/logs/marker_logs.h"

#include <utility>

namespace fathom {

Identification IdentificationOf(const JointSummary& joint, const Signals& scored) {
  Identification result;
  result.family = Family::kJoint;
  result.source = Source::kCamera;
  result.fitted.dof = scored.dof;
  result.fitted.force_unit = scored.force_unit;
  result.is_usable = joint.IsUsable();
  result.message = joint.message;
  result.fitted.model = joint.model;
  result.fitted.covariance = joint.covariance;
  result.fitted.caveats = joint.caveats;
  if (result.is_usable) ScoreByFreeRuns(scored, &result.fitted);
  return result;
}

Identification IdentifyJointly(std::vector<Log> logs,
                               const Signals& scored,
                               const JointOptions& options,
                               std::vector<std::string>* remarks) {
  for (Log& log : logs) log.pose.reset();
  const MarkerLogs markers = PrepareMarkerLogs(std::move(logs), scored.dof);
  remarks->insert(remarks->end(), markers.remarks.begin(), markers.remarks.end());
  return IdentificationOf(FitJoint(markers.input, options), scored);
}

}  // namespace fathom
