// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/sources/choose_source.h"

#include "fathom/signal/pose_velocity.h"

namespace fathom {

std::vector<Source> SourcesOf(const Log& log, Dof dof) {
  std::vector<Source> sources;
  if (log.velocity && log.velocity->Find(VelocityColumn(dof)) != nullptr) {
    sources.push_back(Source::kPoseEstimator);
  }
  if (log.pose && TellsMotion(*log.pose, dof)) sources.push_back(Source::kCamera);
  return sources;
}

Source BestSourceOf(const Log& log, Dof dof) {
  const std::vector<Source> sources = SourcesOf(log, dof);
  return sources.empty() ? Source::kPoseEstimator : sources.front();
}

Log WithSourceOnly(Log log, Source source) {
  if (source == Source::kCamera) {
    if (log.pose) log.velocity.reset();
  } else if (log.velocity) {
    log.pose.reset();
  }
  return log;
}

}  // namespace fathom
