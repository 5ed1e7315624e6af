// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/input_error.h"
#include "fathom/log/write_log.h"
#include "fathom/report/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "module/arrays.h"
#include "module/bindings.h"
#include "module/logs_argument.h"
#include "module/pose_path.h"
#include "module/tell.h"
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

py::array_t<double> PositionsOf(const PosePath& path) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(path.poses.size()), 3);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    rows.row(k) = path.poses[static_cast<std::size_t>(k)].pose.translation.transpose();
  }
  return ArrayOf(rows);
}

// x, y, z, w.
py::array_t<double> QuaternionsOf(const PosePath& path) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(path.poses.size()), 4);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    rows.row(k) = path.poses[static_cast<std::size_t>(k)].pose.rotation.coeffs().transpose();
  }
  return ArrayOf(rows);
}

py::array_t<double> CovariancesOf(const PosePath& path) {
  const auto num_poses = static_cast<py::ssize_t>(path.poses.size());
  py::array_t<double> array(std::vector<py::ssize_t>{num_poses, 6, 6});
  auto cells = array.mutable_unchecked<3>();
  for (py::ssize_t k = 0; k < num_poses; ++k) {
    const auto& covariance = path.poses[static_cast<std::size_t>(k)].covariance;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) cells(k, i, j) = covariance(i, j);
    }
  }
  return array;
}

std::vector<double> StampsOf(const PosePath& path) {
  std::vector<double> stamps;
  for (const StampedPose& pose : path.poses) stamps.push_back(pose.time);
  return stamps;
}

// Root mean square of the standard deviations of one number of a pose.
double TypicalStd(const PosePath& path, int index) {
  double sum = 0.0;
  for (const StampedPose& pose : path.poses) sum += pose.covariance(index, index);
  return std::sqrt(sum / static_cast<double>(path.poses.size()));
}

Table ExtentTable(const PosePath& path) {
  Table table;
  table.columns = {{"axis"}, {"least [m]", true}, {"greatest [m]", true}, {"std [m]", true}};
  constexpr std::array kAxes = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const auto [least, greatest] = std::ranges::minmax_element(
        path.poses, {}, [axis](const StampedPose& pose) { return pose.pose.translation[axis]; });
    table.rows.push_back({{kAxes[static_cast<std::size_t>(axis)],
                           fmt::format("{:.3f}", least->pose.translation[axis]),
                           fmt::format("{:.3f}", greatest->pose.translation[axis]),
                           fmt::format("{:.2g}", TypicalStd(path, axis))}});
  }
  return table;
}

std::string PathTitle(const PosePath& path) {
  if (path.poses.empty()) return "Trajectory of no poses\n";
  return fmt::format("Trajectory of {} poses, {:.1f} to {:.1f} s\n",
                     path.poses.size(),
                     path.poses.front().time,
                     path.poses.back().time);
}

std::string PathText(const PosePath& path) {
  return path.poses.empty() ? PathTitle(path) : PathTitle(path) + FormatTable(ExtentTable(path));
}

py::dict ListsOfPath(const PosePath& path) {
  py::dict lists;
  for (const auto& [column, values] : DictOfStream(PoseStreamOf(path.poses))) {
    lists[column] = values.attr("tolist")();
  }
  return lists;
}

// Throws InputError where there is nothing to write.
void SavePath(const PosePath& path, const py::object& file) {
  if (path.poses.empty()) throw InputError("The trajectory holds no pose, expected one at least.");
  WriteStream(PathOf(file), PoseStreamOf(path.poses));
}

}  // namespace

void BindTrajectory(py::module_& module) {
  py::class_<PosePath>(module, "Trajectory", "Poses with their stamps and covariances, n of them.")
      .def_property_readonly(
          "time", [](const PosePath& path) { return ArrayOf(StampsOf(path)); }, "(n,) [s]")
      .def_property_readonly(
          "position", &PositionsOf, "(n, 3): in the world, north, east, down [m].")
      .def_property_readonly("quaternion",
                             &QuaternionsOf,
                             "(n, 4): x, y, z, w; turns vectors of the moving frame into the "
                             "world's.")
      .def_property_readonly("covariance",
                             &CovariancesOf,
                             "(n, 6, 6): of the position along the world's axes [m], then of the "
                             "turn about the moving frame's axes [rad]. NaN: not known.")
      .def_property_readonly(
          "pose",
          [](const PosePath& path) { return DictOfStream(PoseStreamOf(path.poses)); },
          "The columns of pose.csv, as Log.from_arrays() takes them.")
      .def("save", &SavePath, py::arg("path"), "Writes a CSV file as pose.csv.")
      .def("to_dict", &ListsOfPath, "The columns of pose.csv as lists.")
      .def("__len__", [](const PosePath& path) { return path.poses.size(); })
      .def("__repr__", &PathText)
      .def("_repr_html_", [](const PosePath& path) {
        const std::string title = NotebookText(PathTitle(path));
        return path.poses.empty() ? title : title + NotebookTable(ExtentTable(path));
      });
}

}  // namespace fathom
