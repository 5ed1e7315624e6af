// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/unpacked_file.h"

#include "fathom/base/files/temporary.h"
#include "fathom/base/input_error.h"
#include "fathom/import/recording/byte_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <zstd.h>

namespace fathom {
namespace {

constexpr std::size_t kUnpackStep = std::size_t{1} << 20;  // [bytes]

std::uint64_t MostUnpackedOfFile(std::uint64_t size) {
  constexpr std::uint64_t kRatio = 1000, kLeast = std::uint64_t{64} << 20,
                          kMost = std::uint64_t{64} << 30;
  return std::clamp(size > kMost / kRatio ? kMost : kRatio * size, kLeast, kMost);
}

void Unpack(const std::filesystem::path& path, const std::filesystem::path& to) {
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(),
                                                                             ZSTD_freeDStream);
  if (stream == nullptr) throw std::bad_alloc();
  ByteFile file(path);
  std::ofstream unpacked(to, std::ios::binary);
  std::vector<char> buffer(kUnpackStep);
  std::uint64_t written = 0;
  std::size_t is_open = 1;  // 0 at the end of a frame
  for (std::uint64_t at = 0; at < file.size();) {
    const std::string_view bytes = file.View(at, kUnpackStep);
    at += bytes.size();
    ZSTD_inBuffer in = {bytes.data(), bytes.size(), 0};
    bool is_full = true;  // what fills the buffer may go on
    while (in.pos < in.size || is_full) {
      ZSTD_outBuffer out = {buffer.data(), buffer.size(), 0};
      is_open = ZSTD_decompressStream(stream.get(), &out, &in);
      if (ZSTD_isError(is_open) != 0) {
        throw InputError(fmt::format("{}: is compressed by zstd and damaged before byte {}: {}.",
                                     path.string(),
                                     at,
                                     ZSTD_getErrorName(is_open)));
      }
      written += out.pos;
      if (written > MostUnpackedOfFile(file.size())) {
        throw InputError(fmt::format("{}: {} bytes unpack to over {}: no recording does.",
                                     path.string(),
                                     file.size(),
                                     MostUnpackedOfFile(file.size())));
      }
      unpacked.write(buffer.data(), static_cast<std::streamsize>(out.pos));
      is_full = out.pos == out.size;
      if (is_open == 0 && in.pos == in.size) break;
    }
  }
  if (is_open != 0) {
    throw InputError(path.string() + ": is compressed by zstd and cut: it ends within a frame.");
  }
  if (!unpacked.flush()) {
    throw InputError(fmt::format("{}: cannot be unpacked into {}: is that disk full?",
                                 path.string(),
                                 to.parent_path().string()));
  }
}

class UnpackedRecording final : public Recording {
 public:
  UnpackedRecording(
      const std::filesystem::path& path,
      const std::function<std::unique_ptr<Recording>(const std::filesystem::path&)>& open)
      : path_(path), file_(std::filesystem::temp_directory_path() / path.stem()) {
    Unpack(path, file_.path());
    Named([&] { recording_ = open(file_.path()); });
  }

  const Contents& contents() const override { return recording_->contents(); }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override {
    std::vector<std::string> remarks;
    Named([&] { remarks = recording_->Read(selections, sink); });
    return remarks;
  }

 private:
  // Has what is thrown name the file that the user knows.
  template <typename Action>
  void Named(const Action& action) const {
    try {
      action();
    } catch (const InputError& error) {
      std::string text = error.what();
      const std::string unpacked = file_.path().string();
      const std::size_t at = text.find(unpacked);
      if (at != std::string::npos) text.replace(at, unpacked.size(), path_.string());
      throw InputError(text);
    }
  }

  std::filesystem::path path_;
  Temporary file_;
  std::unique_ptr<Recording> recording_;
};

}  // namespace

bool LooksLikeZstd(std::string_view first_bytes) {
  return first_bytes.starts_with("\x28\xb5\x2f\xfd");
}

std::unique_ptr<Recording> OpenUnpacked(
    const std::filesystem::path& path,
    const std::function<std::unique_ptr<Recording>(const std::filesystem::path&)>& open) {
  return std::make_unique<UnpackedRecording>(path, open);
}

}  // namespace fathom
