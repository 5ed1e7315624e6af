// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/change_search.h"
#include "fathom/trends/event_fit.h"
#include "fathom/trends/judged_event.h"
#include "fathom/trends/pattern.h"
#include "fathom/trends/series.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fathom {

// Something that happened, as far as it is known.
struct ArchiveEvent {
  EventColumn column;
  std::vector<char> found;  // by series: its change was found by itself
  JudgedEvent judged;
};

// The series of an archive, and the events that explain them.
struct ArchiveEvents {
  std::vector<DiveSeries> series;  // without outliers
  std::vector<DiveBlock> blocks;
  std::vector<double> tau_squared;  // by series
  std::vector<Pattern> patterns;
  std::vector<ArchiveEvent> events;
  int num_dives = 0;
};

// An archive without events yet.
ArchiveEvents MakeArchiveEvents(std::span<const ParameterOutlier> outliers,
                                std::span<const DiveEstimate> estimates,
                                int num_dives,
                                const std::optional<Vehicle>& vehicle);

// Makes events of changes, the most certain first: those of one dive, give or take one, are one,
// and so are all trends. False if nothing is new.
bool AddEvents(std::span<const Change> changes, ArchiveEvents* archive);

// Names the cause of each event beside the others, drops events that the others explain, places
// each where the series that it moves say so together, and takes a trend for a stack of steps.
void Settle(ArchiveEvents* archive);

// One event, the others as they are.
EventFit FitOf(const ArchiveEvents& archive, std::size_t index);

// What the events move, for a search for what is left.
std::vector<KnownChange> KnownOf(const ArchiveEvents& archive);

}  // namespace fathom
