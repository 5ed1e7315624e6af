// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/inflated.h"

#include <algorithm>
#include <memory>
#include <new>

#include <zlib.h>

namespace fathom {
namespace {

constexpr std::size_t kInflateStep = std::size_t{1} << 18;  // [bytes]

}  // namespace

std::optional<std::string> Inflated(ByteFile* file,
                                    std::uint64_t offset,
                                    std::uint64_t count,
                                    std::size_t most,
                                    DeflateFrame frame) {
  z_stream stream = {};
  const int window = frame == DeflateFrame::kZlib ? MAX_WBITS : -MAX_WBITS;
  if (inflateInit2(&stream, window) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, inflateEnd);
  std::string out;
  // Deflate shrinks to a thousandth at most. Memory that is reserved and not touched is not taken.
  out.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(most, 1100 * count)) + kInflateStep);
  const std::uint64_t end = offset + count;
  int result = Z_OK;
  while (result == Z_OK && offset < end) {
    const std::string_view in = file->View(
        offset, static_cast<std::size_t>(std::min<std::uint64_t>(kInflateStep, end - offset)));
    if (in.empty()) return std::nullopt;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(in.data()));  // zlib reads only
    stream.avail_in = static_cast<uInt>(in.size());
    do {
      const std::size_t before = out.size();
      out.resize(before + kInflateStep);
      stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);
      stream.avail_out = static_cast<uInt>(kInflateStep);
      result = inflate(&stream, Z_NO_FLUSH);
      out.resize(before + kInflateStep - stream.avail_out);
      if (out.size() > most) return std::nullopt;
    } while (result == Z_OK && stream.avail_out == 0);
    if (result == Z_BUF_ERROR) result = Z_OK;  // asks for more
    offset += in.size();
  }
  if (result != Z_STREAM_END) return std::nullopt;
  return out;
}

std::optional<std::size_t> InflatedSize(std::string_view data, std::size_t most) {
  z_stream stream = {};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, inflateEnd);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));  // zlib reads only
  stream.avail_in = static_cast<uInt>(data.size());
  std::string out(kInflateStep, '\0');
  int result = Z_OK;
  while (result == Z_OK && stream.total_out <= most) {
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(kInflateStep);
    result = inflate(&stream, Z_NO_FLUSH);
  }
  if (result != Z_STREAM_END || stream.total_out > most) return std::nullopt;
  return stream.total_out;
}

}  // namespace fathom
