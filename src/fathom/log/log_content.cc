// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_content.h"

#include "fathom/base/input_error.h"
#include "fathom/log/log_files.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

namespace fathom {
namespace {

class Digest {
 public:
  Digest() : state_(XXH3_createState(), XXH3_freeState) { XXH3_128bits_reset(state_.get()); }

  void AddBytes(const char* data, std::size_t size) {
    XXH3_128bits_update(state_.get(), data, size);
  }
  // With its length, so that no two lists of texts are alike.
  void Add(std::string_view text) {
    const std::uint64_t size = text.size();
    AddBytes(reinterpret_cast<const char*>(&size), sizeof size);
    AddBytes(text.data(), text.size());
  }
  std::string Text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
  }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

[[noreturn]] void Refuse(const std::filesystem::path& file, int error) {
  throw InputError(fmt::format("{}: cannot be read: {}.", file.string(), std::strerror(error)));
}

void AddFile(const std::filesystem::path& file, Digest* digest) {
  struct Closed {
    int number;
    ~Closed() {
      if (number >= 0) close(number);
    }
  };
  // Opening a pipe would wait for who writes into it.
  const Closed in = {open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (in.number < 0) Refuse(file, errno);
  struct stat status = {};
  if (fstat(in.number, &status) != 0) Refuse(file, errno);
  if (!S_ISREG(status.st_mode)) {
    throw InputError(fmt::format("{}: is a {}, expected a file.",
                                 file.string(),
                                 S_ISFIFO(status.st_mode)  ? "pipe"
                                 : S_ISDIR(status.st_mode) ? "folder"
                                                           : "device"));
  }
  std::vector<char> buffer(1 << 18);
  std::uint64_t size = 0;
  while (true) {
    const ssize_t n = read(in.number, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) Refuse(file, errno);
    if (n == 0) break;
    digest->AddBytes(buffer.data(), static_cast<std::size_t>(n));
    size += static_cast<std::uint64_t>(n);
  }
  digest->Add(std::to_string(size));
}

}  // namespace

std::string ContentOf(const std::filesystem::path& log) {
  Digest digest;
  for (const std::filesystem::path& file : InputFilesOf(log)) {
    // The name of a single CSV is not part of what it says.
    digest.Add(file == log ? "" : file.lexically_relative(log).string());
    AddFile(file, &digest);
  }
  return digest.Text();
}

std::string DigestOf(std::string_view text) {
  Digest digest;
  digest.Add(text);
  return digest.Text();
}

std::string DigestOf(const std::vector<std::string>& texts) {
  Digest digest;
  for (const std::string& text : texts) digest.Add(text);
  return digest.Text();
}

}  // namespace fathom
