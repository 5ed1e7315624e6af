// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What a colleague would say of a diagnosis, in a few sentences: what share of the error, because
// of what and how large; what cannot be told apart and which experiment would tell; how the error
// on unseen data changes, and which parameter of the model moves most.
std::string VerdictSentence(const Diagnosis& diagnosis);

// The same in paragraphs, one for each of these; only the first is there in any case.
std::vector<std::string> VerdictParagraphs(const Diagnosis& diagnosis);

// What MAE and NMAE are of: "velocity", or "position" where no velocity is measured.
std::string_view FittedQuantity(const Diagnosis& diagnosis);

// Where what no fit has seen comes from, in two or three words.
std::string_view WhereUnseen(const Diagnosis& diagnosis);

// What the error on unseen data is called: "velocity NMAE on held-out data", or "cross-validated
// velocity NMAE" where the logs held nothing out.
std::string NameOfNmae(const Diagnosis& diagnosis);

}  // namespace fathom
