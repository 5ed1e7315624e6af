// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace fathom {

// Random numbers of one purpose ("velocity.noise.surge"): the same for a seed on every platform,
// and unmoved by how many numbers another purpose draws.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view purpose);

  // Uniform in the open interval (0, 1).
  double Uniform();

  // Normal with mean 0 and standard deviation 1, by Box and Muller.
  double Normal();

 private:
  std::mt19937_64 bits_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace fathom
