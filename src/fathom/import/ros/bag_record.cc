// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ros/bag_record.h"

#include <utility>

namespace fathom {
namespace {

// The first field, which is taken off. Nothing where the bytes do not hold it.
std::optional<std::string_view> TakeField(std::string_view* bytes) {
  if (bytes->size() < 4) return std::nullopt;
  const auto length = NumberAt<std::uint32_t>(*bytes, 0);
  if (length > bytes->size() - 4) return std::nullopt;
  const std::string_view field = bytes->substr(4, length);
  bytes->remove_prefix(4 + std::size_t{length});
  return field;
}

}  // namespace

std::optional<BagFields> BagFields::Parse(std::string_view bytes) {
  BagFields fields;
  fields.bytes_ = bytes;
  while (!bytes.empty()) {
    const auto field = TakeField(&bytes);
    if (!field || field->find('=') == std::string_view::npos) return std::nullopt;
  }
  return fields;
}

std::string_view BagFields::Text(std::string_view name) const {
  for (std::string_view bytes = bytes_; !bytes.empty();) {
    const std::string_view field = *TakeField(&bytes);
    if (field.size() > name.size() && field[name.size()] == '=' && field.starts_with(name)) {
      return field.substr(name.size() + 1);
    }
  }
  return {};
}

std::optional<BagRecord> BagRecordAt(std::string_view bytes) {
  if (bytes.size() < 4) return std::nullopt;
  const auto header_size = NumberAt<std::uint32_t>(bytes, 0);
  if (header_size > bytes.size() - 4 || bytes.size() - 4 - header_size < 4) return std::nullopt;
  auto fields = BagFields::Parse(bytes.substr(4, header_size));
  if (!fields) return std::nullopt;
  const std::string_view op = fields->Text("op");
  if (op.size() != 1) return std::nullopt;
  BagRecord record;
  record.op = op.front();
  record.header = *std::move(fields);
  record.data_offset = 8 + std::uint64_t{header_size};
  record.data_size = NumberAt<std::uint32_t>(bytes, 4 + header_size);
  record.data = bytes.substr(record.data_offset, record.data_size);
  return record;
}

std::optional<BagRecord> BagRecordIn(ByteFile* file, std::uint64_t at) {
  constexpr std::size_t kUsualHeader = 512;
  const std::string_view begin = file->View(at, kUsualHeader);
  if (begin.size() < 4) return std::nullopt;
  const std::uint64_t header_size = NumberAt<std::uint32_t>(begin, 0);
  if (header_size > kLargestBagRecord) return std::nullopt;
  const auto head = BagRecordAt(file->View(at, static_cast<std::size_t>(header_size + 8)));
  if (!head) return std::nullopt;
  const bool takes_all = head->op == kBagMessage || head->op == kBagConnection;
  if (!takes_all || head->data_size > kLargestBagRecord) return head;
  return BagRecordAt(file->View(at, static_cast<std::size_t>(head->data_offset + head->data_size)));
}

}  // namespace fathom
