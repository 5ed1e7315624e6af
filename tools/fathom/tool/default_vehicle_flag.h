// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

namespace fathom {

// What --default_vehicle says: the vehicle file of logs whose log.yaml names none. Empty where it
// is not given. Throws InputError if the file cannot be read as one.
std::filesystem::path DefaultVehicleFromFlag();

}  // namespace fathom
