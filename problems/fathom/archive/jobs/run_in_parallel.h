// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>

namespace fathom {

// Calls job(0), ..., job(count - 1), so many at a time, in about this order. An exception out of
// one ends the rest and is thrown on.
void RunInParallel(int at_a_time, std::size_t count, const std::function<void(std::size_t)>& job);

}  // namespace fathom
