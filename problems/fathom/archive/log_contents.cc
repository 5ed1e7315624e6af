// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/log_contents.h"

#include "fathom/base/files/path_text.h"
#include "fathom/base/input_error.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/log/log_content.h"
#include "fathom/log/log_files.h"

#include <map>

#include <fmt/format.h>
#include <sys/stat.h>

namespace fathom {
namespace {

// What decides what comes out of a log: its files, and of a recording map and vehicle file too.
// What decides a recording's log beside its own bytes. A map that cannot be read is told when it is
// used.
std::vector<std::filesystem::path> FilesBeside(const FoundLog& log) {
  std::vector<std::filesystem::path> files;
  if (!log.vehicle.empty()) files.emplace_back(log.vehicle);
  if (log.map.empty()) return files;
  files.emplace_back(log.map);
  try {
    const auto named = FilesNamedBy(log.map);
    files.insert(files.end(), named.begin(), named.end());
  } catch (const InputError&) {
    return files;
  }
  return files;
}

std::vector<std::filesystem::path> FilesOf(const FoundLog& log) {
  if (!log.is_recording) return InputFilesOf(log.place);
  std::vector<std::filesystem::path> files = FilesOfRecording(log.place);
  const auto beside = FilesBeside(log);
  files.insert(files.end(), beside.begin(), beside.end());
  return files;
}

std::string ContentOfFound(const FoundLog& log) {
  if (!log.is_recording) return ContentOf(log.place);
  std::vector<std::string> contents = {ContentOfRecording(log.place)};
  for (const std::filesystem::path& file : FilesBeside(log)) {
    std::error_code error;
    contents.push_back(std::filesystem::exists(file, error) ? ContentOf(file) : "missing");
  }
  return DigestOf(contents);
}

std::string StampsOf(const FoundLog& log) {
  std::string stamps;
  for (const std::filesystem::path& file : FilesOf(log)) {
    struct stat status = {};
    if (stat(file.c_str(), &status) != 0) return "";
    stamps += fmt::format("{} {} {}.{:09}\n",
                          PathText(file == log.place ? "" : file.lexically_relative(log.place)),
                          status.st_size,
                          status.st_mtim.tv_sec,
                          status.st_mtim.tv_nsec);
  }
  return stamps;
}

}  // namespace

std::vector<HashedLog> HashLogs(const std::vector<FoundLog>& logs, bool rehash, Store* store) {
  const std::map<std::string, KnownContent> known =
      rehash ? std::map<std::string, KnownContent>() : store->KnownContents();
  std::map<std::string, KnownContent> fresh;
  std::map<std::string, std::string> first_of;
  std::vector<HashedLog> hashed;
  for (const FoundLog& log : logs) {
    HashedLog one;
    one.log = log;
    one.path = PathText(log.path);
    try {
      const std::string stamps = StampsOf(log);
      const auto found = known.find(one.path);
      if (found != known.end() && !stamps.empty() && found->second.stamps == stamps) {
        one.content = found->second.content;
      } else {
        one.content = ContentOfFound(log);
        fresh[one.path] = {stamps, one.content};
      }
      one.duplicate_of = first_of.try_emplace(one.content, one.path).first->second;
      if (one.duplicate_of == one.path) one.duplicate_of.clear();
    } catch (const InputError& error) {
      one.unreadable = CleanText(error.what());
    }
    hashed.push_back(std::move(one));
  }
  store->KeepContents(fresh);
  return hashed;
}

}  // namespace fathom
