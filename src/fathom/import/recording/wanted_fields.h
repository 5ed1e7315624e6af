// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// The numbers of one kind of message that a selection asks for. `Number` is where one stands;
// ValueOf(number, message) takes it.
template <typename Number>
class WantedFields {
 public:
  // `find`: the number of a field's name, not null.
  template <typename Find>
  WantedFields(std::size_t index, const Selection& selection, const Find& find)
      : index_(index), values_(selection.fields.size()) {
    for (const std::string& field : selection.fields) numbers_.push_back(find(field));
  }

  void HandOn(double time, std::string_view message, const SampleSink& sink) {
    for (std::size_t k = 0; k < numbers_.size(); ++k) values_[k] = ValueOf(*numbers_[k], message);
    sink(index_, time, values_);
  }

 private:
  std::size_t index_;
  std::vector<const Number*> numbers_;
  std::vector<double> values_;
};

}  // namespace fathom
