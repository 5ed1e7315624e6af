// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>

namespace fathom {

// Does `work` for 0 to count - 1, `num_threads` of them at a time, begun in this order. What `work`
// throws ends the program.
void SideBySide(std::size_t count, int num_threads, const std::function<void(std::size_t)>& work);

}  // namespace fathom
