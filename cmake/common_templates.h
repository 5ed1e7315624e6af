// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

// Templates of Eigen that many sources need, compiled once, in common_templates.cc: each
// takes up to a second in every source that instantiates it. Among the precompiled headers only:
// without them a source instantiates what it needs.
//
// Their names are internal to Eigen 3.4: with another version, common_templates.inc may
// have to change.

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace Eigen::internal {

using FathomColumns = const_blas_data_mapper<double, Index, ColMajor>;
using FathomRows = const_blas_data_mapper<double, Index, RowMajor>;
using FathomResult = blas_data_mapper<double, Index, ColMajor, Unaligned, 1>;
using FathomTraits = gebp_traits<double, double>;

}  // namespace Eigen::internal

#define FATHOM_TEMPLATE extern template
#include "common_templates.inc"
#undef FATHOM_TEMPLATE
