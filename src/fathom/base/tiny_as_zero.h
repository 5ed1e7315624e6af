// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace fathom {

// While it lives, this thread takes numbers below 2e-308 for 0. The derivatives of a long run by
// its initial state decay that far, and a processor takes a hundred times as long for each
// operation on such a number. Without SSE2 nothing changes.
class TinyAsZero {
 public:
#if defined(__SSE2__)
  TinyAsZero() : before_(_mm_getcsr()) {
    constexpr unsigned kResults = 0x8000, kOperands = 0x0040;
    _mm_setcsr(before_ | kResults | kOperands);
  }
  ~TinyAsZero() { _mm_setcsr(before_); }
#else
  TinyAsZero() = default;
#endif
  TinyAsZero(const TinyAsZero&) = delete;
  TinyAsZero& operator=(const TinyAsZero&) = delete;

#if defined(__SSE2__)
 private:
  unsigned before_;
#endif
};

}  // namespace fathom
