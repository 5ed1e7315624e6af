// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/decompress.h"

#include "fathom/import/recording/number_type.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <new>

#include <bzlib.h>
#include <lz4frame.h>
#include <xxhash.h>
#include <zlib.h>
#include <zstd.h>

namespace fathom {
namespace {

constexpr std::size_t kOutputStep = std::size_t{1} << 20;  // [bytes] by which the output grows

// Lets `step` write into the output until it has nothing more to give. Memory grows with what comes
// out, not with what a damaged header promises.
template <typename Step>
std::string_view Grow(std::size_t size, std::string* buffer, const Step& step) {
  std::size_t done = 0;
  while (done < size) {
    const std::size_t room = std::min(size - done, kOutputStep);
    if (buffer->size() < done + room) buffer->resize(done + room);
    bool goes_on = false;
    done += step(buffer->data() + done, room, &goes_on);
    if (!goes_on) break;
  }
  return std::string_view(*buffer).substr(0, done);
}

std::string_view FromBzip2(std::string_view data, std::size_t size, std::string* buffer) {
  bz_stream stream = {};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) throw std::bad_alloc();
  const std::unique_ptr<bz_stream, int (*)(bz_stream*)> guard(&stream, BZ2_bzDecompressEnd);
  stream.next_in = const_cast<char*>(data.data());  // bzlib reads only
  stream.avail_in = static_cast<unsigned>(
      std::min<std::size_t>(data.size(), std::numeric_limits<unsigned>::max()));
  return Grow(size, buffer, [&](char* out, std::size_t room, bool* goes_on) {
    stream.next_out = out;
    stream.avail_out = static_cast<unsigned>(room);
    const int result = BZ2_bzDecompress(&stream);
    *goes_on = result == BZ_OK && stream.avail_out == 0;
    return room - stream.avail_out;
  });
}

// The number whose bytes end where these begin.
XXH32_hash_t SumBefore(std::string_view bytes) {
  constexpr std::size_t kSize = sizeof(XXH32_hash_t);
  return NumberAt<XXH32_hash_t>(std::string_view(bytes.data() - kSize, kSize), 0);
}

// The check sum is XXH32 of all that comes out. It takes most of the time, half of it with xxhash's
// own function; a frame whose blocks have sums too leaves all of them to LZ4.
std::string_view FromLz4(std::string_view data, std::size_t size, std::string* buffer) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0) {
    throw std::bad_alloc();
  }
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> guard(
      context, LZ4F_freeDecompressionContext);
  LZ4F_frameInfo_t frame = {};
  std::size_t head = data.size();
  if (LZ4F_isError(LZ4F_getFrameInfo(context, &frame, data.data(), &head)) != 0) return {};
  data.remove_prefix(head);
  LZ4F_decompressOptions_t options = {};
  // What came out before stays where it is, and so need not be kept twice, unless the buffer moves.
  options.stableDst = size <= kOutputStep || size <= buffer->size() ? 1 : 0;
  options.skipChecksums = frame.blockChecksumFlag == LZ4F_noBlockChecksum ? 1 : 0;
  bool is_ended = false;
  const std::string_view plain =
      Grow(size, buffer, [&](char* out, std::size_t room, bool* goes_on) {
        std::size_t written = 0;
        while (written < room) {
          std::size_t taken = data.size();
          std::size_t given = room - written;
          const std::size_t result =
              LZ4F_decompress(context, out + written, &given, data.data(), &taken, &options);
          if (LZ4F_isError(result) != 0) return written;
          written += given;
          data.remove_prefix(taken);
          is_ended = result == 0;
          if (is_ended || (taken == 0 && given == 0)) return written;
        }
        *goes_on = true;
        return written;
      });
  const bool is_checked = is_ended && frame.contentChecksumFlag == LZ4F_contentChecksumEnabled;
  // The sum is the last that was taken.
  if (is_checked && XXH32(plain.data(), plain.size(), 0) != SumBefore(data)) return {};
  return plain;
}

std::string_view FromZlib(std::string_view data, std::size_t size, std::string* buffer) {
  z_stream stream = {};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, inflateEnd);
  // zlib reads only.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
  stream.avail_in =
      static_cast<uInt>(std::min<std::size_t>(data.size(), std::numeric_limits<uInt>::max()));
  return Grow(size, buffer, [&](char* out, std::size_t room, bool* goes_on) {
    stream.next_out = reinterpret_cast<Bytef*>(out);
    stream.avail_out = static_cast<uInt>(room);
    const int result = inflate(&stream, Z_NO_FLUSH);
    *goes_on = result == Z_OK && stream.avail_out == 0;
    return room - stream.avail_out;
  });
}

std::string_view FromZstd(std::string_view data, std::size_t size, std::string* buffer) {
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(),
                                                                             ZSTD_freeDStream);
  if (stream == nullptr) throw std::bad_alloc();
  ZSTD_inBuffer in = {data.data(), data.size(), 0};
  return Grow(size, buffer, [&](char* to, std::size_t room, bool* goes_on) {
    ZSTD_outBuffer out = {to, room, 0};
    while (out.pos < out.size) {
      const std::size_t taken = in.pos;
      const std::size_t given = out.pos;
      const std::size_t result = ZSTD_decompressStream(stream.get(), &out, &in);
      if (ZSTD_isError(result) != 0 || result == 0) return out.pos;
      if (in.pos == taken && out.pos == given) return out.pos;
    }
    *goes_on = true;
    return out.pos;
  });
}

}  // namespace

std::size_t MostUnpackedOf(std::size_t num_compressed) {
  constexpr std::size_t kRatio = 1000, kLeast = std::size_t{64} << 20, kMost = std::size_t{1} << 30;
  return num_compressed > kMost / kRatio ? kMost : std::max(kLeast, kRatio * num_compressed);
}

std::string_view Decompressed(Compression compression,
                              std::string_view data,
                              std::size_t size,
                              std::string* buffer) {
  if (compression != Compression::kNone) size = std::min(size, MostUnpackedOf(data.size()));
  switch (compression) {
    case Compression::kBzip2:
      return FromBzip2(data, size, buffer);
    case Compression::kLz4:
      return FromLz4(data, size, buffer);
    case Compression::kZlib:
      return FromZlib(data, size, buffer);
    case Compression::kZstd:
      return FromZstd(data, size, buffer);
    case Compression::kNone:
      break;
  }
  return data.substr(0, size);
}

}  // namespace fathom
