// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <vector>

namespace fathom {

// A piece of work. It gives back the jobs that may begin once it is through.
struct Job {
  std::function<std::vector<Job>()> run;
};

// Runs the jobs and those that follow from them, so many at a time: in this order, what follows a
// job before what still waits. An exception out of one ends the rest and is thrown on.
void RunInParallel(int at_a_time, std::vector<Job> jobs);

}  // namespace fathom
