// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

namespace fathom {

// How many threads ParallelFor() may use in this process, at least 1. As many as there are cores
// unless set; not to be set while one runs.
void SetNumThreads(int count);

// Calls work(0) ... work(count - 1), several at once; a call within `work` takes the threads that
// are idle as it begins. Each must write what is its own: then the result is the same whatever the
// number of threads. Rethrows the exception of the lowest index, if any.
void ParallelFor(int count, const std::function<void(int)>& work);

}  // namespace fathom
