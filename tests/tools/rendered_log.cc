// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "rendered_log.h"

namespace fathom {

namespace fs = std::filesystem;

ToolRun Track(const fs::path& log, std::vector<std::string> more) {
  more.push_back("--log=" + log.string());
  return RunToolBinary("fathom_track", more);
}

const fs::path& RenderedLog() {
  static const fs::path log = FATHOM_RENDERED_LOG;
  EXPECT_TRUE(fs::exists(log)) << "ctest -R rendered_log makes " << log;
  return log;
}

fs::path CopyOfTheLog() {
  const fs::path& log = RenderedLog();
  const fs::path copy = EmptyTestFolder() / "copy";
  fs::copy(log, copy, fs::copy_options::recursive);
  return copy;
}

CsvTable PosesIn(const fs::path& log) {
  CsvSpec spec;
  spec.required = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  spec.at_least_one_of = {"sx", "sy", "sz", "sroll", "spitch", "syaw"};
  return ReadCsvTable(log / "pose.csv", spec);
}

}  // namespace fathom
