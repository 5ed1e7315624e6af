// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/store/store.h"

#include <filesystem>
#include <string>

#include "error_from.h"
#include "test_folder.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// What somebody took out of a database while it was in use: SQLite's own words name no file.
class StoreErrors : public testing::Test {
 protected:
  void Drop(const std::string& table, const std::filesystem::path& file) {
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("DROP TABLE " + table);
  }

  template <typename Work>
  std::string ErrorOf(const Work& work) {
    return ErrorFrom([&] { work(); });
  }

  const std::filesystem::path file_ = EmptyTestFolder() / "dives.sqlite";
};

TEST_F(StoreErrors, NameTheirFile) {
  Store store(file_);
  for (const char* table : {"runs", "files", "done", "logs"}) Drop(table, file_);
  const std::string begin = file_.string() + ": no such table: ";
  EXPECT_THAT(ErrorOf([&] { store.FindRun("key"); }), StartsWith(begin + "runs"));
  EXPECT_THAT(ErrorOf([&] { store.KeepRun({}); }), StartsWith(begin + "runs"));
  EXPECT_THAT(ErrorOf([&] { store.KnownContents(); }), StartsWith(begin + "files"));
  EXPECT_THAT(ErrorOf([&] { store.KeepContents({{"a", {}}}); }), StartsWith(begin + "files"));
  EXPECT_THAT(ErrorOf([&] { store.ReplaceLogs({{}}); }), StartsWith(begin));
  EXPECT_THAT(ErrorOf([&] { store.DoneLogs(); }), StartsWith(begin + "done"));
  EXPECT_THAT(ErrorOf([&] { store.RemoveOtherLogs({}); }), StartsWith(begin + "done"));
  EXPECT_THAT(ErrorOf([&] { store.ReplaceDives({}, ""); }), StartsWith(begin + "done"));
  EXPECT_THAT(ErrorOf([&] { store.DoneDives(); }), StartsWith(begin + "done"));
  EXPECT_THAT(ErrorOf([&] { store.ReadTables(); }), StartsWith(begin + "logs"));
  EXPECT_THAT(ErrorOf([&] { store.ReadSummaryTables(); }), StartsWith(begin + "logs"));
}

TEST_F(StoreErrors, OfAMergeNameBothFiles) {
  Store store(file_);
  const std::filesystem::path other = file_.parent_path() / "other.sqlite";
  { const Store made(other); }
  Drop("runs", other);
  const std::string error = ErrorOf([&] { store.Merge(other); });
  EXPECT_THAT(error, HasSubstr(file_.string()));
  EXPECT_THAT(error, HasSubstr("--merge=" + other.string()));
}

}  // namespace
}  // namespace fathom
