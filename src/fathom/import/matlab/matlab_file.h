// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/number_type.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A variable may take so much memory [bytes]; a larger one is passed over.
inline constexpr std::uint64_t kMostMatlabBytes = 200'000'000;

// Structs and cells lie within each other at most so deep.
inline constexpr int kDeepestMatlabArray = 20;

// Takes numbers out of the bytes of a .mat.
struct MatlabByteOrder {
  bool is_big = false;

  std::uint32_t Uint32At(std::string_view bytes, std::size_t offset) const {
    return NumberAt<std::uint32_t>(bytes, offset, is_big);
  }
};

// The numbers of an array, column by column as MATLAB keeps them.
struct MatlabNumbers {
  std::shared_ptr<const std::string> bytes;
  std::size_t offset = 0;  // of the first number
  NumberType type = NumberType::kFloat64;
  MatlabByteOrder order;

  double At(std::size_t index) const {
    return NumberAt(type, *bytes, offset + index * SizeOf(type), order.is_big);
  }
};

// An array of numbers with two dimensions.
struct MatlabArray {
  std::string name;        // "eta", "run.eta", "run[2].eta"
  std::string parent;      // the struct that it is a field of: "run[2]"; empty: it is of none
  std::string field;       // "eta"; empty: it is of none
  std::string class_name;  // "double"
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
  NumberType type = NumberType::kFloat64;  // as it is stored
  std::uint64_t variable = 0;              // where its variable begins in the file
  std::size_t offset = 0;                  // of the numbers within the bytes of the variable

  // The longer dimension is time: the rows, unless there are more columns.
  std::uint64_t num_samples() const { return rows < columns ? columns : rows; }
  std::uint64_t num_fields() const { return rows < columns ? rows : columns; }
  std::uint64_t num_bytes() const { return rows * columns * SizeOf(type); }

  // Of the number of this sample and field, among all in MATLAB's order.
  std::size_t IndexOf(std::size_t sample, std::size_t field_index) const {
    return rows < columns ? sample * rows + field_index : field_index * rows + sample;
  }
};

// What the variables of a .mat hold.
class MatlabListing {
 public:
  // Takes an array whose rows and columns are in `array`; one without use as a channel is counted.
  void Add(MatlabArray array);

  // A text; no channel.
  void AddText() { ++num_texts_; }

  // Something that is no array of numbers in two dimensions, and why.
  void PassOver(std::string_view name, std::string_view why);

  void Remark(std::string remark);

  // A struct with these fields, which may be one that Simulink wrote.
  void TakeFieldNames(std::string_view name, std::span<const std::string> fields);

  const std::vector<MatlabArray>& arrays() const { return arrays_; }

  // What was passed over, and what was counted.
  std::vector<std::string> Remarks() const;

  std::uint64_t damaged_bytes = 0;

 private:
  std::vector<MatlabArray> arrays_;
  std::set<std::string, std::less<>> names_;
  std::uint64_t num_fields_ = 0;
  std::vector<std::string> remarks_;
  std::size_t num_remarks_ = 0;  // with those that are not kept
  std::size_t num_texts_ = 0;
  std::size_t num_scalars_ = 0;
  std::size_t num_empty_ = 0;
};

// The bytes of the variable that was looked at last.
struct MatlabVariable {
  std::uint64_t place = ~std::uint64_t{0};
  std::shared_ptr<const std::string> bytes;
};

// A .mat of one of the versions.
class MatlabFile {
 public:
  virtual ~MatlabFile() = default;

  virtual std::string format() const = 0;  // "mat4", "mat5", "mat7.3"

  virtual const MatlabListing& listing() const = 0;

  // The numbers of an array that is listed. `variable` keeps what the next array may need too.
  virtual MatlabNumbers Numbers(const MatlabArray& array, MatlabVariable* variable) const = 0;
};

// Of the element of a struct or a cell array with `count` elements: "run", "run[2]".
std::string MatlabElementName(const std::string& name, std::uint64_t index, std::uint64_t count);

}  // namespace fathom
