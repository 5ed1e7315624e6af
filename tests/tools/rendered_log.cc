// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "rendered_log.h"

#include <fstream>
#include <sstream>

#include <unistd.h>

namespace fathom {

namespace fs = std::filesystem;

std::string Bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

ToolRun Track(const fs::path& log, std::vector<std::string> more) {
  more.push_back("--log=" + log.string());
  return RunToolBinary("fathom_track", more);
}

const fs::path& RenderedLog() {
  struct Made {
    fs::path log;
    ~Made() { fs::remove_all(log.parent_path()); }
  };
  static const Made made = {[] {
    // Tests may run side by side, each in a process of its own.
    const fs::path folder = TestFolder().parent_path() / std::to_string(getpid());
    const std::string films = kData + "/films/";
    WriteTestFile(folder / "film.yaml",
                  "camera: " + films + "wall_camera.yaml\ntags: " + films +
                      "wall_four_tags.yaml\nmount: " + films +
                      "wall_mount.yaml\nexposure: 0.02\nwater: {attenuation: 0.1, noise: 2}\n");
    WriteTestFile(folder / "experiment.yaml",
                  "name: rendered\nduration: 1.2\ncommand_rate: 10\nsurge: {control: open_loop, "
                  "initial_speed: 0.3, input: {kind: sine, amplitude: 50, frequency: 1}}\npose: "
                  "{rate: 10}\n");
    RunsWell("fathom_synthesize",
             {"--vehicle=" + kData + "/vehicles/flatfish.yaml",
              "--experiment=" + (folder / "experiment.yaml").string(),
              "--film=" + (folder / "film.yaml").string(),
              "--render",
              "--out=" + (folder / "log").string()});
    return folder / "log";
  }()};
  return made.log;
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
