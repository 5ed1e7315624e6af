// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// The basic types of ULog; docs.px4.io, "ULog File Format", Data types.
enum class UlogType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat,
  kDouble,
  kBool,
  kChar,
};

// Bytes of one.
std::size_t SizeOf(UlogType type);

// A number of a message, nested types and arrays taken apart: "timestamp", "q[3]", "esc[0].rpm".
struct UlogNumber {
  std::string name;
  UlogType type = UlogType::kUint8;
  std::size_t offset = 0;  // from the first byte of the message's data
};

// Where the numbers of one kind of message stand. Texts (char) and padding are none.
struct UlogLayout {
  std::vector<UlogNumber> numbers;
  std::size_t size = 0;  // of the data [bytes], without padding at its end, which is not logged

  // Null if there is none.
  const UlogNumber* Find(std::string_view name) const;
};

// The number as it stands; NaN where the data ends before it.
double ValueOf(const UlogNumber& number, std::string_view data);

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
