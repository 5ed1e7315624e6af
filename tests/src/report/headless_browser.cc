// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "headless_browser.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "test_folder.h"
#include <fmt/format.h>

namespace fathom {
namespace {

std::string OutputOf(const std::string& command) {
  std::string output;
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    output.append(buffer.data(), n);
  }
  pclose(pipe);
  return output;
}

// Chromium's windows do not get narrower [px].
constexpr int kLeastWidth = 500;

// A page that shows another one within a frame, and its findings as its own.
constexpr const char* kFrame = R"(<!doctype html><body><script>
addEventListener("message", (event) => {{
  const report = document.createElement("pre");
  report.id = "selftest";
  report.textContent = event.data;
  document.body.append(report);
}});
</script><iframe width="{}" height="{}" style="border:0" src="file://{}{}"></iframe></body>)";

// What a reader's script finds it with.
constexpr const char* kReader = R"(<script>
addEventListener("load", async () => {
  const findings = {errors: ""};
  addEventListener("error", (event) => { findings.errors += event.message; });
  addEventListener("securitypolicyviolation", (event) => { findings.errors += event.violatedDirective; });
  const wait = () => new Promise((done) => setTimeout(done, 60));
  const inkOf = (canvas, color) => {
    const wanted = [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
    const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      if (wanted.every((level, k) => Math.abs(pixels[i + k] - level) < 12)) ++count;
    }
    return count;
  };
  const read = async () => {
    READER
  };
  await wait();
  await read().catch((error) => { findings.errors += error; });
  const report = document.createElement("pre");
  report.id = "selftest";
  report.textContent = Object.entries(findings).map(([name, value]) => `${name}=${value}\n`).join("");
  document.body.append(report);
});
</script>)";

// What Chromium writes to stdout when it opens the page at `hash`.
std::string OutputOfChromium(const std::string& html,
                             const std::string& hash,
                             const std::string& flags) {
  const std::filesystem::path folder = TestFolder() / "browser", file = folder / "page.html";
  WriteFile(file, html);
  const std::string output = OutputOf(fmt::format(
      "timeout 60 '{}' --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking --disable-component-update --disable-sync "
      "--user-data-dir='{}' {} 'file://{}{}' 2>/dev/null",
      Chromium(),
      (folder / "profile").string(),
      flags,
      file.string(),
      hash));
  std::filesystem::remove_all(folder);
  return output;
}

}  // namespace

std::string Chromium() {
  std::string path =
      OutputOf("command -v chromium || command -v chromium-browser || command -v google-chrome");
  path.erase(path.find_last_not_of('\n') + 1);
  return path;
}

std::string DomOf(const Page& page) { return DomOf(RenderPage(page), {}); }

std::string DomOf(const std::string& html, const Window& window) {
  if (window.width < kLeastWidth) {
    const std::filesystem::path file = TestFolder() / "browser" / "in_frame.html";
    WriteFile(file, html);
    const std::string frame =
        fmt::format(kFrame, window.width, window.height, file.string(), window.hash);
    return DomOf(frame, {.height = window.height});
  }
  return OutputOfChromium(html,
                          window.hash,
                          fmt::format("--window-size={},{} {} --dump-dom",
                                      window.width,
                                      window.height,
                                      window.has_real_time ? "" : "--virtual-time-budget=8000"));
}

std::map<std::string, std::string> FindingsOf(const std::string& html, const std::string& script) {
  std::string reader = kReader;
  reader.replace(reader.find("READER"), std::string("READER").size(), script);
  std::string page = html;
  page.insert(page.rfind("</body>"), reader);
  const std::string dom = DomOf(page, {.hash = ""});
  auto findings = FindingsIn(dom);
  if (findings.empty()) findings["errors"] = "no findings in: " + dom.substr(0, 500);
  return findings;
}

std::string PrintOf(const std::string& html) {
  const std::filesystem::path pdf = TestFolder() / "printed.pdf";
  OutputOfChromium(html, "", fmt::format("--print-to-pdf='{}'", pdf.string()));
  if (!std::filesystem::exists(pdf)) return "";
  const std::string bytes = ReadFile(pdf);
  std::filesystem::remove(pdf);
  return bytes;
}

std::map<std::string, std::string> FindingsIn(const std::string& dom, const std::string& id) {
  std::map<std::string, std::string> findings;
  const std::size_t begin = dom.find(fmt::format("id=\"{}\">", id));
  if (begin == std::string::npos) return findings;
  std::istringstream lines(dom.substr(dom.find('>', begin) + 1));
  for (std::string line; std::getline(lines, line) && line.find("</pre>") == std::string::npos;) {
    const std::size_t equals = line.find('=');
    findings[line.substr(0, equals)] = line.substr(equals + 1);
  }
  return findings;
}

}  // namespace fathom
