// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace fathom {

// Every channel holds one number over and over.
class ConstantRecording final : public Recording {
 public:
  explicit ConstantRecording(Contents contents, double value = 0.0)
      : contents_(std::move(contents)), value_(value) {}
  const Contents& contents() const override { return contents_; }
  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override {
    for (std::size_t i = 0; i < selections.size(); ++i) {
      sink(i, 0.0, std::vector<double>(selections[i].fields.size(), value_));
    }
    return {};
  }

 private:
  Contents contents_;
  double value_;
};

}  // namespace fathom
