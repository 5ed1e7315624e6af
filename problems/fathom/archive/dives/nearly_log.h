// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What somebody may take for a log, and what it lacks.
struct NearlyLog {
  std::string path;  // from the archive on
  std::string why;   // "its first line does not name t, tau and v"
};

// Why a folder without a log.yaml that holds files of these names is nearly a log: two streams of
// one, or a log.yaml of another ending. Nothing if it is not.
std::optional<std::string> WhyFolderIsNearlyLog(const std::vector<std::string>& names);

// Why a file that is no log is nearly one: a CSV file whose first line is close to t,tau,v, units
// aside, or that has them and another ending or separator; not by the name of a stream. Nothing if
// it is not.
std::optional<std::string> WhyFileIsNearlyLog(const std::filesystem::path& file);

// "2 places are nearly logs: a.csv (its first line does not name t, tau and v) and b (holds
// log.yml, expected log.yaml).", the first three by name. Empty if there is none.
std::string NearlyLogsSentence(const std::vector<NearlyLog>& nearly_logs);

}  // namespace fathom
