// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

struct SampleLine {
  double t = 0.0;         // [s]
  double force = 0.0;     // tau [N] or [N m], held from t on
  double velocity = 0.0;  // v [m/s] or [rad/s]

  bool operator==(const SampleLine&) const = default;
};

// Reads the lines t,tau,v of a stream that may still grow, each as soon as it is there.
//
// The first line may name the columns: t, tau and v in any order, and others, which are not read.
// Blank lines and those that begin with # are passed over. Nothing else is: see Next().
class SampleLines {
 public:
  // `name` stands for the stream in messages; `in` must outlive this.
  SampleLines(std::string name, std::istream* in);

  // Goes on behind this sample; `from` says where it stands. A stream that begins anew is passed
  // over up to it, and has to hold it: another one may have the same stamps.
  void GoOnBehind(const SampleLine& last, const std::string& from);

  // The next sample; nothing at the end of the stream. Waits for a line. Throws InputError, with
  // line, column, what was found, what was expected and what to do, for a cell that is no finite
  // number, a line with another number of cells or other separators, names without t, tau and v or
  // with units, stamps that do not rise, a carriage return or other bytes that are no plain text, a
  // line of over 4095 bytes and a stream that cannot be read.
  std::optional<SampleLine> Next();

  // How many samples were passed over.
  long num_passed_over() const { return num_passed_over_; }

  // Names of columns that are not read, once the first line was taken.
  const std::vector<std::string>& not_read() const { return not_read_; }

 private:
  bool ReadLine();  // into text_; false at the end
  void RefuseWhatIsNoPlainText() const;
  void RefuseOtherSeparators() const;
  void RefuseUnits() const;
  void TakeNames();
  double NumberIn(std::size_t role) const;
  void RequireRising(double t) const;
  bool IsPassedOver(const SampleLine& sample);
  [[noreturn]] void Fail(const std::string& problem) const;

  std::string name_;
  std::istream* in_;
  long line_ = 0;  // counted from 1
  std::array<char, 4096> buffer_ = {};
  std::string_view text_;
  std::vector<std::string_view> cells_;  // of text_
  bool has_first_line_ = false;
  std::size_t num_cells_ = 3;
  long line_of_names_ = 0;                         // 0: none
  std::array<std::size_t, 3> column_ = {0, 1, 2};  // of t, tau and v
  std::vector<std::string> not_read_;
  std::optional<double> last_stamp_;
  long line_of_last_stamp_ = 0;
  std::optional<SampleLine> behind_;
  std::string behind_from_;
  bool holds_behind_ = false;
  long num_passed_over_ = 0;
};

}  // namespace fathom
