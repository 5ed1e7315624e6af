// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "filmed_minute.h"

#include "run_tool.h"

namespace fathom {

std::filesystem::path SynthesizeMinute(const std::filesystem::path& log,
                                       const std::string& film,
                                       double amplitude,
                                       int seed) {
  const std::filesystem::path experiment =
      WriteTestFile(log.string() + ".yaml",
                    "name: minute\nduration: 60\ncommand_rate: 10\nsurge: {control: open_loop, "
                    "initial_speed: 0, input: {kind: square, amplitude: " +
                        std::to_string(amplitude) +
                        ", frequency: 0.5, offset: -0.81}}\nvelocity: {rate: 10, noise: {surge: "
                        "0.01}}\npose: {rate: 10}\nheld_out: [48, 60]\n");
  const std::string data = FATHOM_DATA_DIR;
  RunsWell("fathom_synthesize",
           {"--vehicle=" + data + "/vehicles/flatfish.yaml",
            Flag("experiment", experiment),
            "--film=" + data + "/films/" + film,
            "--seed=" + std::to_string(seed),
            Flag("out", log)});
  return log;
}

}  // namespace fathom
