// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "bag_writer.h"

#include "dataflash_writer.h"
#include <bzlib.h>
#include <gtest/gtest.h>
#include <lz4frame.h>
#include <zstd.h>

namespace fathom::bag {
namespace {

using dataflash::Bytes;

std::string Bzip2(const std::string& text) {
  std::string out(text.size() + text.size() / 100 + 600, '\0');
  auto size = static_cast<unsigned>(out.size());
  EXPECT_EQ(BZ2_bzBuffToBuffCompress(out.data(),
                                     &size,
                                     const_cast<char*>(text.data()),
                                     static_cast<unsigned>(text.size()),
                                     9,
                                     0,
                                     0),
            BZ_OK);
  out.resize(size);
  return out;
}

std::string Lz4(const std::string& text) {
  std::string out(LZ4F_compressFrameBound(text.size(), nullptr), '\0');
  out.resize(LZ4F_compressFrame(out.data(), out.size(), text.data(), text.size(), nullptr));
  return out;
}

std::string Zstd(const std::string& text) {
  std::string out(ZSTD_compressBound(text.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), text.data(), text.size(), 3));
  return out;
}

}  // namespace

std::string Compressed(const std::string& compression, const std::string& text) {
  if (compression == "bz2") return Bzip2(text);
  if (compression == "lz4") return Lz4(text);
  if (compression == "zstd") return Zstd(text);
  return text;
}

std::string WithLength(const std::string& text) {
  return Bytes(static_cast<std::uint32_t>(text.size())) + text;
}

std::string Record(const std::vector<std::pair<std::string, std::string>>& fields,
                   const std::string& data) {
  std::string header;
  for (const auto& [name, value] : fields) header += WithLength(name + "=" + value);
  return WithLength(header) + WithLength(data);
}

std::string Connection(std::uint32_t number,
                       const std::string& topic,
                       const std::string& type,
                       const std::string& definition) {
  return Record({{"conn", Bytes(number)}, {"op", "\x07"}, {"topic", topic}},
                WithLength("type=" + type) + WithLength("md5sum=*") +
                    WithLength("message_definition=" + definition));
}

std::string Message(std::uint32_t number, std::uint32_t seconds, const std::string& data) {
  return Record({{"conn", Bytes(number)},
                 {"op", "\x02"},
                 {"time", Bytes(seconds) + Bytes<std::uint32_t>(500000000)}},
                data);
}

std::string Chunk(const std::string& compression, const std::string& records) {
  return Record({{"compression", compression},
                 {"op", "\x05"},
                 {"size", Bytes(static_cast<std::uint32_t>(records.size()))}},
                Compressed(compression, records));
}

std::string Index(std::uint32_t number, std::uint32_t first_second, std::uint32_t count) {
  std::string entries;
  for (std::uint32_t i = first_second; i < first_second + count; ++i) {
    entries += Bytes(i) + Bytes<std::uint32_t>(500000000) + Bytes<std::uint32_t>(0);
  }
  return Record(
      {{"conn", Bytes(number)}, {"count", Bytes(count)}, {"op", "\x04"}, {"ver", Bytes(1)}},
      entries);
}

std::string Head(std::uint64_t index_at) {
  return "#ROSBAG V2.0\n" +
         Record({{"index_pos", Bytes(index_at)}, {"op", "\x03"}}, std::string(100, ' '));
}

}  // namespace fathom::bag
