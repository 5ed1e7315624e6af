// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

#include <string>

namespace fathom {

// "the inertia moves from 1086 to 852 kg": the parameter of the baseline whose share of the force
// changes most once the causes are in, among those that move by more than their interval; empty if
// none does.
std::string WhatMoves(const Diagnosis& diagnosis);

}  // namespace fathom
