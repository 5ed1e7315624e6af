// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/packed_number.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Where the numbers of one kind of message stand. Texts (char) and padding are none.
struct UlogLayout {
  std::vector<PackedNumber> numbers;
  std::size_t size = 0;  // of the data [bytes], without padding at its end, which is not logged

  const PackedNumber* Find(std::string_view name) const { return FindNumber(numbers, name); }
};

// The formats of a file, by their names, from its messages 'F'.
class UlogFormats {
 public:
  // "name:type field;type[4] field;". Of two of one name the first holds.
  void Take(std::string_view text);

  int num_redefined() const { return num_redefined_; }  // otherwise than the first
  int num_unreadable() const { return num_unreadable_; }

  // Throws InputError, without the file, if there is no such format, or it nests a type that there
  // is not or itself, or takes more bytes than a message has. Each field and each element of an
  // array takes one of `budget`; at 0 it throws too, so that a bad file cannot ask for everything.
  UlogLayout LayoutOf(const std::string& name, std::size_t* budget) const;

 private:
  struct UlogField {
    std::string type;
    std::string name;
    std::size_t count = 1;
    bool is_array = false;
    bool operator==(const UlogField&) const = default;
  };

  static bool ParseUlogField(std::string_view text, UlogField* field);
  void AddFields(const std::string& format,
                 const std::string& prefix,
                 int depth,
                 std::size_t* budget,
                 UlogLayout* layout) const;

  std::map<std::string, std::vector<UlogField>> formats_;
  std::size_t text_bytes_ = 0;
  int num_redefined_ = 0;
  int num_unreadable_ = 0;
};

}  // namespace fathom
