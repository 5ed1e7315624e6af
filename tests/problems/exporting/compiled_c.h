// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Values as C initialises an array with them: "{1.0, 2.5}".
std::string Row(const Eigen::VectorXd& values);

// Compiles a header and a main() that uses it as strictly as C compilers can, runs it, and gives
// the numbers that it prints.
std::vector<double> NumbersPrinted(const std::string& name,
                                   const std::string& header,
                                   const std::string& body);

}  // namespace fathom
