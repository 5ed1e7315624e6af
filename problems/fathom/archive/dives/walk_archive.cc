// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/walk_archive.h"

#include "fathom/base/files/path_text.h"
#include "fathom/base/input_error.h"
#include "fathom/import/open_recording.h"
#include "fathom/log/log_files.h"
#include "fathom/log/single_csv.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <deque>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

// Which folder it is, whatever its name.
std::pair<dev_t, ino_t> IdentityOf(const fs::path& folder) {
  struct stat status = {};
  if (stat(folder.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino};
}

bool IsFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// Whether the first line of a file names the columns of a single CSV log.
bool IsCsvLog(const fs::path& file) {
  if (file.extension() != ".csv") return false;
  std::ifstream in(file, std::ios::binary);
  std::array<char, 4096> begin = {};
  in.read(begin.data(), begin.size());
  return IsSingleCsvLog({begin.data(), static_cast<std::size_t>(in.gcount())});
}

std::string KindOf(const fs::directory_entry& entry) {
  std::error_code error;
  const fs::file_status status = entry.status(error);
  switch (status.type()) {
    case fs::file_type::fifo:
      return "pipe";
    case fs::file_type::socket:
      return "socket";
    case fs::file_type::block:
    case fs::file_type::character:
      return "device";
    case fs::file_type::regular:
      break;
    default:
      return entry.is_symlink(error) ? "broken link" : "unknown";
  }
  std::string ending = PathText(entry.path().extension());
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending.empty() ? "without an ending" : ending;
}

struct Walk {
  const fs::path& archive;
  const ArchiveSettings& settings;
  std::set<std::pair<dev_t, ino_t>> seen = {};
  std::deque<fs::path> links = {};  // to folders, for after the folders themselves
  FoundArchive found = {};

  // From the archive on; empty for the archive itself.
  fs::path PathOf(const fs::path& place) const {
    return place == archive ? fs::path() : place.lexically_relative(archive);
  }
};

// Nothing if the entry is no recording.
std::optional<FoundLog> RecordingAt(const fs::directory_entry& entry,
                                    const fs::path& path,
                                    const ArchiveSettings& settings) {
  std::error_code ignored;
  const ArchiveImport* import = ImportOf(path.string(), settings);
  const bool is_named =
      import != nullptr && (entry.is_regular_file(ignored) || entry.is_directory(ignored));
  if (!is_named && !(entry.is_regular_file(ignored) && IsRecording(entry.path()))) {
    return std::nullopt;
  }
  FoundLog found = {.place = entry.path(), .path = path, .is_recording = true};
  found.vehicle = is_named ? import->vehicle : settings.vehicle;
  if (is_named) found.map = import->map;
  return found;
}

std::vector<fs::directory_entry> EntriesOf(const fs::path& folder, std::error_code* error) {
  std::vector<fs::directory_entry> entries;
  for (fs::directory_iterator it(folder, *error), end; !*error && it != end; it.increment(*error)) {
    entries.push_back(*it);
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

// Of a folder without a log.yaml.
void NoteIfNearlyLog(const fs::path& folder,
                     const std::vector<fs::directory_entry>& entries,
                     Walk* walk) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : entries) {
    std::error_code ignored;
    if (!entry.is_regular_file(ignored)) continue;
    if (IsLeftOut(walk->PathOf(entry.path()).string(), walk->settings)) continue;
    names.push_back(PathText(entry.path().filename()));
  }
  auto why = WhyFolderIsNearlyLog(names);
  if (!why) return;
  const fs::path path = walk->PathOf(folder);
  walk->found.nearly_logs.push_back(
      {path.empty() ? std::string(".") : PathText(path), *std::move(why)});
}

void WalkFolder(const fs::path& folder, Walk* walk) {
  if (!walk->seen.insert(IdentityOf(folder)).second) {
    ++walk->found.other_files["link to a folder seen already"];
    return;
  }
  std::error_code error;
  const auto entries = EntriesOf(folder, &error);
  if (error) {
    walk->found.unreadable.push_back({walk->PathOf(folder), error.message()});
    return;
  }
  // A log.yaml of any kind makes a log: what is wrong with it is told of the log.
  const bool is_log = std::any_of(entries.begin(), entries.end(), [](const auto& entry) {
    return entry.path().filename() == "log.yaml";
  });
  std::set<std::string> of_log;
  bool has_images = false;
  if (!is_log) NoteIfNearlyLog(folder, entries, walk);
  if (is_log) {
    const fs::path path = walk->PathOf(folder);
    walk->found.logs.push_back({.place = folder, .path = path.empty() ? "." : path});
    for (const fs::path& file : InputFilesOf(folder)) of_log.insert(file.filename().string());
    has_images = IsFile(folder / "frames.csv");
  }
  for (const fs::directory_entry& entry : entries) {
    const fs::path path = walk->PathOf(entry.path());
    if (IsLeftOut(path.string(), walk->settings)) {
      ++walk->found.other_files["left out"];
      continue;
    }
    std::error_code ignored;
    if (path == "archive.yaml" || of_log.contains(entry.path().filename().string())) continue;
    const bool may_be_other = !is_log || entry.is_directory(ignored);
    if (auto recording = may_be_other ? RecordingAt(entry, path, walk->settings) : std::nullopt) {
      walk->found.logs.push_back(*std::move(recording));
      continue;
    }
    if (entry.is_directory(ignored)) {
      if (has_images) continue;
      if (entry.is_symlink(ignored)) {
        walk->links.push_back(entry.path());
      } else {
        WalkFolder(entry.path(), walk);
      }
      continue;
    }
    if (!is_log && entry.is_regular_file(ignored) && IsCsvLog(entry.path())) {
      walk->found.logs.push_back({.place = entry.path(), .path = path});
      continue;
    }
    ++walk->found.other_files[KindOf(entry)];
    if (is_log || !entry.is_regular_file(ignored)) continue;
    if (auto why = WhyFileIsNearlyLog(entry.path())) {
      walk->found.nearly_logs.push_back({PathText(path), *std::move(why)});
    }
  }
}

}  // namespace

FoundArchive WalkArchive(const fs::path& archive, const ArchiveSettings& settings) {
  std::error_code error;
  if (!fs::is_directory(archive, error)) {
    throw InputError(
        fmt::format("--archive={}: is no folder, expected a folder of logs.", archive.string()));
  }
  Walk walk{.archive = archive, .settings = settings};
  WalkFolder(archive, &walk);
  if (!walk.found.unreadable.empty() && walk.found.unreadable.front().path.empty()) {
    throw InputError(fmt::format("--archive={}: cannot be read: {}.",
                                 archive.string(),
                                 walk.found.unreadable.front().message));
  }
  while (!walk.links.empty()) {
    const fs::path link = walk.links.front();
    walk.links.pop_front();
    WalkFolder(link, &walk);
  }
  std::sort(walk.found.logs.begin(), walk.found.logs.end(), [](const auto& a, const auto& b) {
    return fs::path(a.path) < fs::path(b.path);  // "a/b" before "a-b/c"
  });
  return std::move(walk.found);
}

void RequireAnyLog(const FoundArchive& found, const fs::path& archive) {
  if (!found.logs.empty() || !found.unreadable.empty()) return;
  std::vector<std::string> others;
  for (const auto& [kind, count] : found.other_files) {
    others.push_back(fmt::format("{} {}", count, kind));
  }
  throw InputError(fmt::format(
      "--archive={}: holds no log ({}), expected at any depth a folder with a log.yaml, a CSV "
      "file whose first line names t, tau and v, or a recording. See docs/archive.md.",
      archive.string(),
      others.empty() ? "it is empty" : fmt::format("but {}", fmt::join(others, ", "))));
}

}  // namespace fathom
