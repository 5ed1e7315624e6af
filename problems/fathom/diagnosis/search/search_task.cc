// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/search_task.h"

#include "fathom/diagnosis/search/suspects.h"

#include <glog/logging.h>

namespace fathom {

int EffectPlace(const SearchTask& task, const ExtendedModel& model, int suspect) {
  const int place = PlaceIn(model, task.suspects[suspect]);
  CHECK_GE(place, 0) << "A hypothesis has the effects of its suspects.";
  return place;
}

}  // namespace fathom
