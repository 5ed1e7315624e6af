// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/figures/figure.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "example_page.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

bool HasGnuplot() { return std::system("command -v gnuplot >/dev/null") == 0; }

// Without printing the whole file where it fails.
bool Holds(const std::string& file, const std::string& text) {
  return file.find(text) != std::string::npos;
}

// True if every element that is opened is closed in the right order.
bool IsBalanced(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    if (xml[at + 1] == '?' || xml[at + 1] == '!' || xml[end - 1] == '/') continue;
    const bool is_closing = xml[at + 1] == '/';
    const std::size_t begin = at + (is_closing ? 2 : 1);
    const std::string name = xml.substr(begin, xml.find_first_of(" \n\t>", begin) - begin);
    if (!is_closing) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

TEST(Figure, DrawsCurvesIntoAnSvgThatNamesThem) {
  if (!HasGnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  TimePanel panel = ExamplePage().sections[0].time_panels[0];
  panel.title = "It's <surge> & $more \"here\"";
  panel.responses[0].values.assign(panel.time.size(), std::nan(""));  // a fit that gave nothing
  WriteFigure(panel, TestFolder() / "curves.svg");
  const std::string svg = ReadFile(TestFolder() / "curves.svg");
  EXPECT_TRUE(IsBalanced(svg));
  for (const char* text : {"measured",
                           "least_squares",
                           "adaptive",
                           "output_error",
                           "joint",
                           "held out",
                           "surge velocity [m/s]",
                           "residual [m/s]",
                           "It's &lt;surge> &amp; $more"}) {
    EXPECT_TRUE(Holds(svg, text)) << text;
  }
}

TEST(Figure, DrawsEstimatesIntoAnSvgThatNamesThem) {
  if (!HasGnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  WriteFigure(ExamplePage().sections[2].parameter_panels, TestFolder() / "estimates.svg");
  const std::string svg = ReadFile(TestFolder() / "estimates.svg");
  EXPECT_TRUE(IsBalanced(svg));
  for (const char* text :
       {"inertia [kg m²]", "buoyancy [N m]", "output_error", "truth 212.0", "±"}) {
    EXPECT_TRUE(Holds(svg, text)) << text;
  }
}

TEST(Figure, DrawsPng) {
  if (!HasGnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  const Page page = ExamplePage();
  WriteFigure(page.sections[0].time_panels[0], TestFolder() / "curves.png");
  WriteFigure(page.sections[0].parameter_panels, TestFolder() / "estimates.png");
  for (const char* name : {"curves.png", "estimates.png"}) {
    const std::string png = ReadFile(TestFolder() / name);
    EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n")) << name;
    EXPECT_GT(png.size(), 20'000u) << name;  // an empty sheet of this size has below 10 000 bytes
  }
}

TEST(Figure, DrawsPanelsWithoutData) {
  if (!HasGnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_NO_THROW(WriteFigure(TimePanel{}, TestFolder() / "empty.svg"));
  EXPECT_NO_THROW(
      WriteFigure(std::vector<ParameterPanel>{ParameterPanel{}}, TestFolder() / "empty.svg"));
}

TEST(Figure, RefusesOtherFormats) {
  EXPECT_THAT(
      [] { WriteFigure(TimePanel{}, "plot.bmp"); },
      ThrowsMessage<InputError>("plot.bmp: this figure ends in '.bmp', expected .svg or .png."));
}

TEST(Figure, NamesThePackageWhereGnuplotIsMissing) {
  const char* const path = std::getenv("PATH");
  const std::string saved = path == nullptr ? "" : path;
  setenv("PATH", "/nowhere", 1);
  EXPECT_THAT([] { WriteFigure(TimePanel{}, "plot.svg"); },
              ThrowsMessage<InputError>(AllOf(StartsWith("plot.svg: "), HasSubstr("gnuplot-nox"))));
  setenv("PATH", saved.c_str(), 1);
}

}  // namespace
}  // namespace fathom
