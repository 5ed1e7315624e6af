// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/rock/pocolog_file.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/decompress.h"
#include "fathom/import/recording/number_type.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::string_view kPocologMagic("POCOSIM\0", 8);
constexpr std::size_t kPrologue = 16;
constexpr std::size_t kBlockHeader = 8;
constexpr std::size_t kSampleHeader = 21;
constexpr std::uint32_t kLargestBlock = 1U << 27;  // that is read

// Kinds of blocks.
constexpr char kStream = 1, kSample = 2, kControl = 3;

// The text behind its length at *at, which it moves on; nothing if it is cut.
std::optional<std::string> TextAt(std::string_view bytes, std::size_t* at) {
  if (bytes.size() - *at < 4) return std::nullopt;
  const auto length = NumberAt<std::uint32_t>(bytes, *at);
  if (length > bytes.size() - *at - 4) return std::nullopt;
  std::string text(bytes.substr(*at + 4, length));
  *at += 4 + std::size_t{length};
  return text;
}

std::optional<MessageChannel> StreamIn(std::string_view block) {
  if (block.empty()) return std::nullopt;
  std::size_t at = 1;  // behind the kind of stream
  auto name = TextAt(block, &at);
  auto type = TextAt(block, &at);
  if (!name || !type) return std::nullopt;
  MessageChannel channel;
  channel.topic = *std::move(name);
  channel.type = *std::move(type);
  channel.definition = TextAt(block, &at).value_or("");
  channel.encoding = MessageEncoding::kTypelib;
  return channel;
}

double TimeAt(std::string_view block, std::size_t at) {
  return NumberAt<std::uint32_t>(block, at) + NumberAt<std::uint32_t>(block, at + 4) / 1e6;
}

class PocologFile final : public MessageContainer {
 public:
  explicit PocologFile(const std::filesystem::path& path) : path_(path) {
    ByteFile file(path);
    const std::string_view prologue = file.View(0, kPrologue);
    if (prologue.size() < kPrologue) {
      throw InputError(path.string() + ": ends within its first 16 bytes, expected a log of Rock.");
    }
    const auto version = NumberAt<std::uint32_t>(prologue, 8);
    if (version != 2) {
      throw InputError(fmt::format(
          "{}: has version {} of pocolog, expected 2. Rock's program pocolog turns old logs into "
          "new ones (--to-new-format).",
          path.string(),
          version));
    }
    if (NumberAt<std::uint32_t>(prologue, 12) != 0) {
      throw InputError(path.string() +
                       ": is of a machine with the most significant byte first, expected one with "
                       "the least.");
    }
  }

  std::string format() const override { return "pocolog"; }

  ContainerWalk Walk(std::vector<MessageChannel>* channels, const MessageSink& take) const override;

 private:
  std::filesystem::path path_;
};

ContainerWalk PocologFile::Walk(std::vector<MessageChannel>* channels,
                                const MessageSink& take) const {
  ByteFile file(path_);
  ContainerWalk walk;
  std::string buffer;  // of a sample that was compressed
  walk.size_bytes = file.size();
  std::map<std::uint16_t, std::size_t> channel_of;
  std::size_t num_unknown = 0, num_large = 0, num_controls = 0;
  std::uint64_t at = kPrologue;
  while (at < file.size()) {
    const std::string_view header = file.View(at, kBlockHeader);
    if (header.size() < kBlockHeader) break;
    const char kind = header[0];
    const auto stream = NumberAt<std::uint16_t>(header, 2);
    const auto size = NumberAt<std::uint32_t>(header, 4);
    if (size > file.size() - at - kBlockHeader) break;
    const std::uint64_t end = at + kBlockHeader + size;
    if (kind == kControl || (kind == kSample && size > kLargestBlock)) {
      ++(kind == kControl ? num_controls : num_large);
      at = end;
      continue;
    }
    if (size > kLargestBlock || (kind == kSample && size < kSampleHeader)) break;
    const std::string_view block = file.View(at + kBlockHeader, size);
    if (kind == kStream) {
      auto channel = StreamIn(block);
      if (!channel) break;
      channel_of[stream] = channels->size();
      channels->push_back(*std::move(channel));
    } else if (kind == kSample) {
      const auto channel = channel_of.find(stream);
      const std::string_view sample = block.substr(kSampleHeader);
      const bool is_packed = block[kSampleHeader - 1] != 0;
      if (channel == channel_of.end()) {
        ++num_unknown;
      } else if (is_packed) {
        const std::string_view plain =
            Decompressed(Compression::kZlib, sample, kLargestBlock, &buffer);
        take(channel->second, TimeAt(block, 8), plain);
      } else {
        take(channel->second, TimeAt(block, 8), sample);
      }
    } else {
      break;
    }
    at = end;
  }
  walk.read_bytes = at;
  if (at < file.size()) {
    walk.remarks.push_back(
        fmt::format("the log is cut or damaged at byte {}: what is before it is read.", at));
  }
  if (num_unknown > 0) {
    walk.remarks.push_back(Plural(num_unknown, "sample") + " belong to no stream.");
  }
  if (num_large > 0) {
    walk.remarks.push_back(fmt::format(
        "{} of more than {} bytes passed over.", Plural(num_large, "sample"), kLargestBlock));
  }
  if (num_controls > 0) {
    walk.remarks.push_back(Plural(num_controls, "control block") + " passed over.");
  }
  return walk;
}

}  // namespace

bool LooksLikePocolog(std::string_view first_bytes) {
  return first_bytes.starts_with(kPocologMagic);
}

std::unique_ptr<MessageContainer> OpenPocolog(const std::filesystem::path& path) {
  return std::make_unique<PocologFile>(path);
}

}  // namespace fathom
