// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/parameters.h"

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// What one of several runs says alone.
struct RunEstimate {
  std::string log;         // its name
  bool is_usable = false;  // false: it determines no model alone, and the numbers mean nothing
  ParameterVector value = ParameterVector::Constant(std::numeric_limits<double>::quiet_NaN());
  ParameterVector std = ParameterVector::Constant(std::numeric_limits<double>::quiet_NaN());
};

// How far several runs say the same of one parameter.
struct Spread {
  double chi_squared = 0.0;  // of their values about their weighted mean
  int freedom = 0;           // runs less one
  double p_value = 1.0;      // of such a spread, if the runs differ by noise alone

  // The standard deviation of their weighted mean by what their own deviations say, and what that
  // is to be multiplied by, at least 1: the ratio of what they scatter by to it (Birge 1932).
  double mean_std = std::numeric_limits<double>::quiet_NaN();
  double widening = 1.0;

  // What the standard deviation `std` of a fit to all of them is to be multiplied by, so that it is
  // not below that of the mean, widened. From 1 to `widening`: where the runs differ, so does the
  // residual of the fit, which has widened `std` by a part of that already.
  double WideningOf(double std) const;
};

struct RunAgreement {
  std::vector<RunEstimate> runs;
  std::array<Spread, kNumParameters> spreads;  // in the order of kParameterInfo

  // The run without which the others agree far better, and the parameter in which it differs;
  // empty: none stands apart.
  std::string stands_apart;
  int parameter_apart = 0;
};

// Of at least two runs. Those that are not usable count in no spread.
RunAgreement AgreementOf(std::vector<RunEstimate> runs);

}  // namespace fathom
