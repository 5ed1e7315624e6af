// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <pybind11/pybind11.h>

namespace fathom {

// The parts of the module, each with its classes and functions. A part uses the classes of those
// before it.
void BindValues(pybind11::module_& module);
void BindLog(pybind11::module_& module);
void BindModels(pybind11::module_& module);
void BindCheck(pybind11::module_& module);
void BindIdentify(pybind11::module_& module);
void BindCoupled(pybind11::module_& module);
void BindCompare(pybind11::module_& module);
void BindSimulate(pybind11::module_& module);
void BindDiagnose(pybind11::module_& module);
void BindFreeDecay(pybind11::module_& module);
void BindTrajectory(pybind11::module_& module);
void BindTrack(pybind11::module_& module);
void BindRefine(pybind11::module_& module);

}  // namespace fathom
