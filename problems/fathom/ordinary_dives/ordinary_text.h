// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/ordinary_dives/ordinary_dives.h"
#include "fathom/report/table.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fathom {

// Which stretches do, and what stays open, in two sentences or three.
std::string OrdinarySentence(const OrdinaryRequest& request, const OrdinaryDives& dives);

// What would make the weakest parameter better known: a sentence each, best first. None where it is
// well known.
std::vector<std::string> OrdinaryRemedySentences(const OrdinaryDives& dives);

// The command that fits the chosen stretches alone. Of several logs, before it what each log.yaml
// has to hold out. Empty where one log is chosen as a whole.
std::vector<std::string> HowToFitChosen(const OrdinaryRequest& request, const OrdinaryDives& dives);

// What was assumed: a sentence each.
std::vector<std::string> OrdinaryComments(const OrdinaryRequest& request,
                                          const OrdinaryDives& dives);

// The chosen stretches, one row after the other with what they tell so far, and all logs.
Table ChosenStretchTable(const OrdinaryRequest& request, const OrdinaryDives& dives);

// What each stretch tells alone, best first, at most so many.
Table LoneStretchTable(const OrdinaryRequest& request,
                       const OrdinaryDives& dives,
                       std::size_t most_rows);

// The last part of each log's path, where these differ; else the paths.
std::vector<std::string> ShownLogNames(const OrdinaryRequest& request);

// The first stamp of a log's samples [s].
double FirstStamp(const OrdinaryRequest& request, std::size_t log_index);

// "1st", "2nd" ...
std::string PlaceName(int place);

// Seconds into its log: "1433350690.2" is 51.0 where the log's first sample is at 1433350639.2.
double TimeInLog(const OrdinaryRequest& request, const OrdinaryStretch& stretch, double time);

// Whether some stretch of a log is chosen.
bool IsChosenFrom(const OrdinaryDives& dives, std::size_t log_index);

}  // namespace fathom
