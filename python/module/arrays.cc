// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "module/arrays.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {

namespace py = pybind11;

py::array_t<double> ArrayOf(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::array_t<double> ArrayOf(const Eigen::MatrixXd& matrix) {
  py::array_t<double> array({matrix.rows(), matrix.cols()});
  auto cells = array.mutable_unchecked<2>();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) cells(i, j) = matrix(i, j);
  }
  return array;
}

py::array_t<bool> ArrayOf(const std::vector<bool>& values) {
  py::array_t<bool> array(static_cast<py::ssize_t>(values.size()));
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

py::dict DictOfStream(const Stream& stream) {
  py::dict columns;
  columns["t"] = ArrayOf(stream.time);
  for (std::size_t i = 0; i < stream.columns.size(); ++i) {
    columns[py::str(stream.columns[i])] = ArrayOf(stream.values[i]);
  }
  return columns;
}

std::vector<double> FiniteNumbers(const std::string& what, const py::handle& values) {
  using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
  const Array array = Array::ensure(py::reinterpret_borrow<py::object>(values));
  if (!array) throw InputError(what + ": is no array of numbers.");
  if (array.ndim() != 1) {
    throw InputError(fmt::format("{}: has {} dimensions, expected 1.", what, array.ndim()));
  }
  std::vector<double> numbers(array.data(), array.data() + array.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isfinite(numbers[i])) continue;
    throw InputError(
        fmt::format("{}[{}]: is {}, expected a finite number. Leave the sample out: this reader "
                    "does not guess.",
                    what,
                    i,
                    numbers[i]));
  }
  return numbers;
}

py::object DictOfJson(const std::string& text) {
  return py::module_::import("json").attr("loads")(text);
}

}  // namespace fathom
