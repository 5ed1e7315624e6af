// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/random_stream.h"

#include <cmath>
#include <numbers>

namespace fathom {
namespace {

// A bijection of 64 bits in which every bit of the input moves half of the output (splitmix64).
std::uint64_t Mix(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

// FNV-1a.
std::uint64_t Hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char character : text) {
    hash = (hash ^ static_cast<unsigned char>(character)) * 0x100000001b3;
  }
  return hash;
}

}  // namespace

// The standard fixes mt19937_64's numbers; it leaves those of its distributions to each library.
RandomStream::RandomStream(std::uint64_t seed, std::string_view purpose)
    : bits_(Mix(Mix(seed) ^ Hash(purpose))) {}

double RandomStream::Uniform() { return (static_cast<double>(bits_() >> 11) + 0.5) * 0x1p-53; }

double RandomStream::Normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2.0 * std::log(Uniform()));
  const double angle = 2.0 * std::numbers::pi * Uniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

}  // namespace fathom
