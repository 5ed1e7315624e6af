// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "compiled_c.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/process/run_child.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "test_folder.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using Path = std::filesystem::path;

void Write(const Path& path, const std::string& text) { std::ofstream(path) << text; }

}  // namespace

std::string Row(const Eigen::VectorXd& values) {
  std::string row;
  for (const double value : values) row += (row.empty() ? "{" : ", ") + LiteralOf(value);
  return row + "}";
}

std::vector<double> NumbersPrinted(const std::string& name,
                                   const std::string& header,
                                   const std::string& body) {
  const Path folder = TestFolder();
  Write(folder / (name + ".h"), header);
  Write(folder / "main.c",
        fmt::format("#include \"{}.h\"\n#include <stdio.h>\nint main(void) {{\n{}return 0;\n}}\n",
                    name,
                    body));
  const std::string program = (folder / "program").string();
  const ChildResult compiled = RunChild({"cc",
                                         {"-std=c99",
                                          "-Wall",
                                          "-Wextra",
                                          "-Werror",
                                          "-pedantic",
                                          "-o",
                                          program,
                                          (folder / "main.c").string(),
                                          "-lm"}});
  EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
  const ChildResult run = RunChild({program, {}});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::istringstream out(run.out);
  std::vector<double> numbers;
  for (double number = 0.0; out >> number;) numbers.push_back(number);
  return numbers;
}

}  // namespace fathom
