// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Stands in for any of Fathom's programs in batch_bench: writes at once what one may write, to the
// file of its flag or, as a survey, to stdout.

#include <cstdio>
#include <cstring>

namespace {

constexpr char kSurvey[] = R"({"schema": "fathom-survey-1", "dive": "", "vehicle": "",
 "start": null, "duration": 60.0, "needs_tracking": false,
 "dofs": [{"dof": "surge", "why_not": "", "may_help": true}]}
)";

constexpr char kComparison[] = R"({"rows": [{"dof": "surge", "family": "output_error",
 "source": "velocity", "usable": true, "message": "converged", "mae": 0.001, "nmae": 0.01, "parameters": {
  "inertia": {"value": 40, "std": 0.4, "unit": "kg"},
  "quadratic_damping": {"value": 30, "std": 0.3, "unit": "kg/m"},
  "linear_damping": {"value": 5, "std": 0.2, "unit": "kg/s"},
  "buoyancy": {"value": 1, "std": 0.1, "unit": "N"}}}], "findings": []}
)";

constexpr char kModel[] = R"({"schema": "fathom-model-1", "dof": "surge",
 "structure": {"baseline": "uncoupled", "effects": []}, "force_unit": "N", "parameters": {
  "inertia": {"value": 40, "std": 0.4, "unit": "kg"},
  "quadratic_damping": {"value": 30, "std": 0.3, "unit": "kg/m"},
  "linear_damping": {"value": 5, "std": 0.2, "unit": "kg/s"},
  "buoyancy": {"value": 1, "std": 0.1, "unit": "N"}},
 "covariance": [[0.16, 0, 0, 0], [0, 0.09, 0, 0], [0, 0, 0.04, 0], [0, 0, 0, 0.01]],
 "fit": {"mae": 0.001, "nmae": 0.01, "n": 601, "duration": 60.0}, "caveats": []}
)";

constexpr char kVerdict[] = R"({"dof": "surge", "verdict": "sound", "sentence": "It is sound.",
 "causes": []}
)";

constexpr char kScores[] = R"({"nmae": 0.01}
)";

bool WriteTo(const char* file, const char* text) {
  std::FILE* out = std::fopen(file, "w");
  return out != nullptr && std::fputs(text, out) >= 0 && std::fclose(out) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const bool is_comparison = std::strstr(argv[0], "fathom_compare") != nullptr;
  for (int i = 1; i < argc; ++i) {
    const auto value_of = [&](const char* flag) -> const char* {
      const std::size_t length = std::strlen(flag);
      return std::strncmp(argv[i], flag, length) == 0 ? argv[i] + length : nullptr;
    };
    if (value_of("--survey=")) return std::fputs(kSurvey, stdout) < 0;
    if (const char* file = value_of("--verdict=")) return !WriteTo(file, kVerdict);
    if (const char* file = value_of("--json=")) {
      return !WriteTo(file, is_comparison ? kComparison : kScores);
    }
    // fathom_simulate reads a --model and writes --json, which comes later.
    const bool is_identify = std::strstr(argv[0], "fathom_identify") != nullptr;
    if (const char* file = value_of("--model="); file && is_identify) return !WriteTo(file, kModel);
  }
  return 1;
}
