// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "log_folder.h"

#include "fathom/base/files/output_file.h"

#include "error_from.h"
#include "test_folder.h"

namespace fathom {

std::filesystem::path FolderWith(const LogFiles& changes) {
  LogFiles files = {{"log.yaml", "name: run 7\ndof: surge\n"},
                    {"command.csv", "t,tau_surge\n0,1\n1,2\n2,0\n"},
                    {"velocity.csv", "t,u\n0.5,0\n0.6,0.1\n0.7,0.2\n"}};
  for (const auto& [name, text] : changes) files[name] = text;
  const auto folder = EmptyTestFolder();
  for (const auto& [name, text] : files) {
    if (text != "-") WriteFile(folder / name, text);
  }
  return folder;
}

std::string RefusalOf(const LogFiles& changes, const ReadLogOptions& options) {
  const auto folder = FolderWith(changes);
  std::string text = ErrorFrom([&] { ReadLog(folder, options); });
  for (std::size_t at; (at = text.find(folder.string() + "/")) != std::string::npos;) {
    text.erase(at, folder.string().size() + 1);
  }
  if (text.starts_with(folder.string())) text.erase(0, folder.string().size());
  return text;
}

}  // namespace fathom
