// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/joint_state.h"

#include "fathom/joint_refinement/problem/clipped_loss.h"

#include <glog/logging.h>

namespace fathom {

PoseVector PoseAt(const JointSegment& segment, const SegmentUnknowns& unknowns, size_t frame) {
  return segment.motion.Mean(frame) + PoseVector::Map(unknowns.deviation[frame].data());
}

bool Linearise(JointData* data,
               const JointUnknowns& unknowns,
               double corner_sigma,
               std::vector<LinearSegment>* segments) {
  segments->resize(data->segments.size());
  for (size_t r = 0; r < data->segments.size(); ++r) {
    JointSegment& segment = data->segments[r];
    const SegmentUnknowns& own = unknowns.segments[r];
    if (!segment.motion.Update(unknowns.Motion(r))) return false;
    LinearSegment& linear = (*segments)[r];
    LayOutDurations(segment.motion.time(), &linear);
    linear.frames.resize(segment.detections.size());
    linear.JgJg.setZero();
    linear.Jgr.setZero();
    linear.rr = linear.num_rows = linear.clipped = 0.0;
    linear.response = Eigen::Map<const Eigen::Matrix<double, kNumResponse, 1>>(own.response.data());
    for (size_t k = 0; k < segment.detections.size(); ++k) {
      LinearFrame& frame = linear.frames[k];
      frame.JdJd.setZero();
      frame.JdJg.setZero();
      frame.Jdr.setZero();
      const PoseVector eta = PoseAt(segment, own, k);
      const PredictedMotion::Derivatives mean = segment.motion.MeanDerivatives(k);
      const auto deviation = PoseVector::Map(own.deviation[k].data());
      for (const Detection& detection : segment.detections[k]) {
        const Marker* const marker = segment.map.Find(detection.tag_id);
        CHECK(marker != nullptr);
        CornerRows rows;
        if (!EvaluateCorners(
                data->setup, unknowns.setup, *marker, detection, eta, 1.0, true, &rows)) {
          return false;
        }
        const double s = rows.residual.squaredNorm() / (corner_sigma * corner_sigma);
        const ClippedLoss loss = ClippedLoss::Of(s, data->loss_limit);
        const double weight = loss.weight;
        linear.clipped += loss.value - weight * s;
        Eigen::Matrix<double, 8, kNumColumns> Jg = rows.by_pose * mean;
        Jg.middleCols<7>(kSizeColumn) += rows.by_setup;
        const Eigen::Matrix<double, 8, 1> r = rows.residual - rows.by_pose * deviation;
        const Eigen::Matrix<double, 6, 8> JdW = weight * rows.by_pose.transpose();
        frame.JdJd.noalias() += JdW * rows.by_pose;
        frame.JdJg.noalias() += JdW * Jg;
        frame.Jdr.noalias() += JdW * r;
        linear.JgJg.noalias() += weight * Jg.transpose() * Jg;
        linear.Jgr.noalias() += weight * Jg.transpose() * r;
        linear.rr += weight * r.squaredNorm();
        linear.num_rows += 8.0 * weight;
      }
    }
  }
  return true;
}

void Step(const std::vector<Eigen::VectorXd>& change,
          const std::vector<std::vector<Eigen::Matrix<double, 12, 1>>>& deviations,
          JointUnknowns* unknowns) {
  for (int i = 0; i < kModelColumns; ++i) unknowns->model[i] += change[0][i];
  unknowns->setup.size_scale += change[0][kSizeColumn];
  for (int i = 0; i < 6; ++i) unknowns->setup.mount[i] += change[0][kMountColumns + i];
  for (size_t r = 0; r < unknowns->segments.size(); ++r) {
    SegmentUnknowns& segment = unknowns->segments[r];
    for (int i = 0; i < 2; ++i) segment.start[i] += change[r][kStartColumns + i];
    for (int i = 0; i < kNumResponse; ++i) segment.response[i] += change[r][kResponseColumns + i];
    segment.clock_offset += change[r][kClockColumn];
    for (size_t k = 0; k < segment.deviation.size(); ++k) {
      for (int i = 0; i < 6; ++i) {
        segment.deviation[k][i] = deviations[r][k][2 * i];
        segment.rate[k][i] = deviations[r][k][2 * i + 1];
      }
    }
  }
}

}  // namespace fathom
