// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A model as a file of another program: a C header, a model of a simulator, a function of MATLAB.

#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/utc_time.h"
#include "fathom/exporting/export_checks.h"
#include "fathom/exporting/export_format.h"
#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"
#include "fathom/exporting/format_features.h"
#include "fathom/exporting/model_in_format.h"
#include "fathom/tool/flag_values.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/version.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_string(model, "", "Model or verdict file (JSON); several of one DOF each.");
DEFINE_string(vehicle, "", "Vehicle file (YAML): the body without its water, and thrusters.");
DEFINE_string(format, "", "c, csv, gazebo, mss, stonefish, uuv or vrx.");
DEFINE_double(speed, 0.5, "Of stonefish: where its drag equals the model's, above 0 [m/s].");
DEFINE_bool(table, false, "Print what each format holds of a model, and end.");
DEFINE_string(out, "", "Write the exported model to this file; its name becomes the model's.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_export",
    "Writes a model for another program: a C header, simulators, MATLAB and Octave, a table.",
    "--model=FILE [--model=FILE ...] [--vehicle=FILE] [--speed=0.5] --out=FILE "
    "--format=c|csv|gazebo|mss|stonefish|uuv|vrx\n"
    "--table",
    "fathom_identify --log=data/flatfish --dof=surge --model=surge.json\n"
    "  fathom_export --model=surge.json --format=c --out=flatfish.h",
    "A model of several degrees of freedom is exported as it is, models and verdicts of one each "
    "are joined. What a format does not hold is named in the file and on stderr. Before it is "
    "written, the model is checked: its inertia, its Coriolis forces, a free decay, a free sink, "
    "its "
    "trim at rest. Simulators of bodies need --vehicle with mass and rigid_body. docs/export.md.",
    {"model"},
    "",
    "0: the file is written; 1: input or flags cannot be used; 2: a check of the model failed"};

std::string Today() {
  const double seconds =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  return FormatUtc(seconds).substr(0, 10);
}

// Words of the languages, as `iskeyword` lists them in MATLAB and Octave, each between blanks.
constexpr std::string_view kReservedWords =
    " break case catch classdef continue do else elseif end end_try_catch end_unwind_protect"
    " endclassdef endenumeration endevents endfor endfunction endif endmethods endparfor"
    " endproperties endswitch endwhile for function global if otherwise parfor persistent return"
    " spmd switch try until unwind_protect unwind_protect_cleanup while ";

// MATLAB finds a function by the name of its file.
void RequireFunctionFile(const std::filesystem::path& file) {
  if (kReservedWords.find(" " + file.stem().string() + " ") != std::string_view::npos) {
    throw InputError(
        fmt::format("--out: is {}, expected a name such as boat.m for mss: '{}' is a reserved word "
                    "of MATLAB or Octave, which no function can be called by.",
                    file.string(),
                    file.stem().string()));
  }
  if (file.extension() == ".m" && file.stem() == IdentifierOf(file)) return;
  throw InputError(
      fmt::format("--out: is {}, expected a name such as boat.m for mss: MATLAB calls the function "
                  "by it, so that it holds letters, digits and _ alone.",
                  file.string()));
}

int Run() {
  if (FLAGS_table) {
    PrintText(stdout, FeatureTable());
    return kExitUsable;
  }
  RequireFlag("model", FLAGS_model, "a model or verdict file");
  RequireFlag("format", FLAGS_format, ExportFormatNames());
  if (!(FLAGS_speed > 0.0)) {
    throw InputError(fmt::format("--speed: is {}, expected a speed above 0 m/s.", FLAGS_speed));
  }
  RequireFlag("out", FLAGS_out, "the file to write");
  RequireOnePath("out", FLAGS_out);
  const ExportFormat format = ParseFlag("format", FLAGS_format, ParseExportFormat);
  if (format == ExportFormat::kMss) RequireFunctionFile(FLAGS_out);
  if (format != ExportFormat::kStonefish &&
      !gflags::GetCommandLineFlagInfoOrDie("speed").is_default) {
    throw InputError(fmt::format(
        "--speed: goes with --format=stonefish, expected none with --format={}.", FLAGS_format));
  }
  const std::vector<std::string> files = PathsInValues(FLAGS_model);
  std::vector<std::string> inputs = files;
  if (!FLAGS_vehicle.empty()) inputs.push_back(FLAGS_vehicle);
  RequireOutputs({{"out", FLAGS_out}}, inputs);

  const ExportModel model = ReadExportModel({files.begin(), files.end()});
  ExportTarget target = {IdentifierOf(FLAGS_out),
                         fmt::format("fathom_export {}, {}", VersionWithCommit(), Today()),
                         {},
                         FLAGS_speed,
                         FLAGS_vehicle};
  if (!FLAGS_vehicle.empty()) target.vehicle = ReadVehicleFile(FLAGS_vehicle);
  const ExportedFile exported = Export(model, target, format);
  for (const std::string& problem : exported.problems) {
    PrintText(stderr, fmt::format("fathom_export: not written: {}\n", problem));
  }
  if (!exported.problems.empty()) return kExitNoFit;
  for (const std::string& remark : exported.remarks) {
    PrintText(stderr, fmt::format("fathom_export: note: {}\n", remark));
  }
  WriteFile(FLAGS_out, exported.text);
  PrintText(stdout,
            fmt::format("{} written: {}. Checked: {}.\n",
                        FLAGS_out,
                        DescriptionOf(format),
                        fmt::join(NamesOfExportChecks(model.model), ", ")));
  return kExitUsable;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
