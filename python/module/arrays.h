// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <string>
#include <vector>

#include <Eigen/Core>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace fathom {

// Copies: what Python does with them changes no result.
pybind11::array_t<double> ArrayOf(const std::vector<double>& values);
pybind11::array_t<double> ArrayOf(const Eigen::MatrixXd& matrix);
pybind11::array_t<bool> ArrayOf(const std::vector<bool>& values);

// {"t": array, column: array}.
pybind11::dict DictOfStream(const Stream& stream);

// One dimension of finite numbers. Throws InputError, naming `what`, for anything else.
std::vector<double> FiniteNumbers(const std::string& what, const pybind11::handle& values);

// A JSON text as Python's dict, in the order of the text.
pybind11::object DictOfJson(const std::string& text);

}  // namespace fathom
