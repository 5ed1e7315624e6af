// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/changes_of_dives.h"

#include "fathom/base/input_error.h"
#include "fathom/trends/name_causes.h"
#include "fathom/vehicle/files/model_file.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>
#include <set>

#include <fmt/format.h>

namespace fathom {
namespace {

// One vehicle's dives, counted among themselves.
struct Course {
  std::vector<std::string> dives;
  std::vector<DiveEstimate> estimates;
};

Course CourseOf(const std::string& vehicle,
                const std::vector<FittedDive>& fits,
                const std::vector<std::string>& dives) {
  std::set<int> places;
  for (const FittedDive& fit : fits) {
    if (fit.vehicle == vehicle) places.insert(fit.place);
  }
  Course course;
  std::map<int, int> own_place;
  for (const int place : places) {
    own_place.emplace(place, static_cast<int>(own_place.size()));
    course.dives.push_back(dives.at(static_cast<std::size_t>(place)));
  }
  for (const FittedDive& fit : fits) {
    if (fit.vehicle != vehicle) continue;
    const FittedModel model = ParseModel(fit.vehicle, fit.model);
    course.estimates.push_back({own_place.at(fit.place),
                                fit.dof,
                                ToVector(model.model),
                                model.covariance.topLeftCorner<kNumParameters, kNumParameters>(),
                                model.thruster_shares});
  }
  return course;
}

// Nothing where there is no vehicle file, or none that can be read: its logs were refused then.
std::optional<Vehicle> VehicleOf(const std::filesystem::path& file) {
  if (file.empty()) return std::nullopt;
  try {
    return ReadVehicleFile(file);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// Names of causes that the dives cannot tell apart stand beside each other.
std::string CauseText(const ChangeEvent& event) {
  std::string text = event.cause;
  for (const std::string& alternative : event.alternatives) text += " or " + alternative;
  return text;
}

void AddEvent(const ChangeEvent& event,
              const std::string& vehicle,
              const std::vector<std::string>& dives,
              const std::string& before_text,
              Tables* tables) {
  for (const Change& change : event.changes) {
    tables->changes.push_back({.dof = std::string(Name(change.dof)),
                               .parameter = kParameterInfo[change.parameter].name,
                               .kind = std::string(Name(change.kind)),
                               .at = dives.at(static_cast<std::size_t>(change.at)),
                               .before = change.before,
                               .after = change.after,
                               .before_std = change.before_std,
                               .after_std = change.after_std,
                               .p_value = change.p_value,
                               .cause = CauseText(event),
                               .text = before_text + event.text,
                               .vehicle = vehicle});
  }
}

}  // namespace

void AddChangesOfDives(const std::vector<FittedDive>& fits,
                       const std::vector<std::string>& dives,
                       const std::map<std::string, std::filesystem::path>& vehicle_files,
                       Tables* tables) {
  std::set<std::string> vehicles;
  for (const FittedDive& fit : fits) vehicles.insert(fit.vehicle);
  for (const std::string& vehicle : vehicles) {
    const Course course = CourseOf(vehicle, fits, dives);
    const ChangeOptions options;
    const ChangeSearch search =
        FindChanges(course.estimates, static_cast<int>(course.dives.size()), options);
    for (const ParameterOutlier& outlier : search.outliers) {
      tables->outliers.push_back({course.dives.at(static_cast<std::size_t>(outlier.dive)),
                                  std::string(Name(outlier.dof)),
                                  kParameterInfo[outlier.parameter].name,
                                  vehicle});
    }
    const auto file = vehicle_files.find(vehicle);
    const auto known =
        VehicleOf(file == vehicle_files.end() ? std::filesystem::path() : file->second);
    const std::string before_text = vehicles.size() > 1 ? vehicle + ": " : "";
    for (const ChangeEvent& event :
         NameCauses(search, course.estimates, course.dives, known, options)) {
      AddEvent(event, vehicle, course.dives, before_text, tables);
    }
  }
}

}  // namespace fathom
