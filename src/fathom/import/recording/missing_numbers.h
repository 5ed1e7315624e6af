// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace fathom {

// Counts what arrays hold in place of numbers. Rows of a stream are left out there, so that a list
// of the file has to tell it.
class MissingNumbers {
 public:
  // Looks at all samples of all fields; `at` gives the number of one.
  void Look(const Channel& channel,
            const std::function<double(std::size_t sample, std::size_t field)>& at);

  // A sentence for each channel that misses some, but for at most 50.
  void WriteTo(std::vector<std::string>* remarks) const;

 private:
  std::vector<std::string> sentences_;
  std::size_t num_more_ = 0;
};

}  // namespace fathom
