// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a verdict file whose open causes a plan tells apart; each of them must stand in a
// model file.

#include "fathom/base/input_error.h"
#include "fathom/planning/open_causes.h"
#include "fathom/vehicle/files/model_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <string_view>

namespace {

std::optional<fathom::FittedModel> ModelIn(std::string_view text) {
  try {
    return fathom::ParseModel("v.json", text);
  } catch (const fathom::InputError&) {
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto fitted = ModelIn(text);
  if (!fitted) return 0;
  fathom::OpenCauses open;
  try {
    open = fathom::ReadOpenCauses("v.json", text, *fitted);
  } catch (const fathom::InputError&) {
  }
  for (const fathom::RivalModel& rival : open.rivals) {
    fathom::FittedModel of_rival = *fitted;
    of_rival.effects = rival.model.effects;
    Eigen::Index num_parameters = fathom::kNumParameters;
    for (const auto& active : rival.model.effects) num_parameters += std::ssize(active.values);
    of_rival.covariance = Eigen::MatrixXd::Zero(num_parameters, num_parameters);
    if (!ModelIn(fathom::FormatModel(of_rival))) std::abort();
  }
  return 0;
}
