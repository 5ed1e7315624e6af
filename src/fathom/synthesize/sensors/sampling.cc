// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/sensors/sampling.h"

#include "fathom/base/random_stream.h"
#include "fathom/synthesize/experiment/resolution.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

namespace fathom {

SampleTimes DrawSampleTimes(const Sampling& sampling,
                            double duration,
                            std::uint64_t seed,
                            const std::string& purpose) {
  CHECK_GT(sampling.rate, 0.0);
  RandomStream jitter(seed, purpose + ".jitter");
  RandomStream drop_outs(seed, purpose + ".drop_outs");
  const double period = 1.0 / sampling.rate;
  const DropOuts& bursts = sampling.drop_outs;

  SampleTimes samples;
  double silent_until = 0.0;
  for (int k = 0; k / sampling.rate < duration; ++k) {
    const double even_time = k / sampling.rate;
    // Neighbours stay a fifth of a period apart.
    const double shift = std::clamp(sampling.jitter * jitter.Normal(), -0.4 * period, 0.4 * period);
    const double time = std::max(0.0, RoundTo(even_time + shift, 1e-6));

    // Two numbers a sample, used or not: the next bursts do not depend on the length of this one.
    const bool starts = drop_outs.Uniform() < bursts.probability;
    const double length =
        bursts.shortest + (bursts.longest - bursts.shortest) * drop_outs.Uniform();
    if (starts && even_time >= silent_until) {
      silent_until = even_time + length;
      ++samples.num_drop_outs;
    }
    samples.time.push_back(time);
    samples.has_arrived.push_back(even_time >= silent_until);
    if (!samples.has_arrived.back()) ++samples.num_lost;
  }
  return samples;
}

}  // namespace fathom
