// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/changes_of_dives.h"

#include "fathom/archive/store/compared_dofs.h"
#include "fathom/base/dof.h"
#include "fathom/base/input_error.h"
#include "fathom/trends/name_causes.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/model_file.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>
#include <set>

#include <fmt/format.h>

namespace fathom {
namespace {

// One vehicle's dives, counted among themselves.
struct Course {
  std::string vehicle;
  std::string coupled;  // the DOFs of the coupled model that stands for them; empty: there is none
  std::vector<std::string> dives;
  std::vector<DiveEstimate> estimates;
};

DiveEstimate EstimateOf(const FittedDive& fit, int place) {
  if (IsOfSeveralDofs(fit.dofs)) {
    const FittedCoupledModel fitted = ParseCoupledModel(fit.vehicle, fit.model);
    DiveEstimate estimate;
    estimate.dive = place;
    std::vector<Eigen::Index> of_vehicle;  // what is of a run says nothing of it
    for (std::size_t k = 0; k < fitted.entries.size(); ++k) {
      if (IsOfRun(fitted.entries[k])) continue;
      of_vehicle.push_back(static_cast<Eigen::Index>(k));
      estimate.entries.push_back(fitted.entries[k]);
    }
    estimate.value.resize(std::ssize(of_vehicle));
    for (Eigen::Index i = 0; i < estimate.value.size(); ++i) {
      estimate.value(i) = ValueIn(fitted.model, estimate.entries[static_cast<std::size_t>(i)]);
    }
    estimate.covariance = fitted.covariance(of_vehicle, of_vehicle);
    return estimate;
  }
  const FittedModel model = ParseModel(fit.vehicle, fit.model);
  return {place,
          ParseDof(fit.dofs),
          ToVector(model.model),
          model.covariance.topLeftCorner<kNumParameters, kNumParameters>(),
          model.thruster_shares};
}

Course CourseOf(const std::string& vehicle,
                const std::vector<FittedDive>& fits,
                const std::vector<std::string>& dives,
                const Tables& tables) {
  std::set<int> places;
  for (const FittedDive& fit : fits) {
    if (fit.vehicle == vehicle) places.insert(fit.place);
  }
  Course course;
  course.vehicle = vehicle;
  course.coupled = CoupledDofsCompared(tables.dive_fits, vehicle);
  std::map<int, int> own_place;
  for (const int place : places) {
    own_place.emplace(place, static_cast<int>(own_place.size()));
    course.dives.push_back(dives.at(static_cast<std::size_t>(place)));
  }
  for (const FittedDive& fit : fits) {
    if (fit.vehicle != vehicle || !AreCompared(fit.dofs, course.coupled)) continue;
    course.estimates.push_back(EstimateOf(fit, own_place.at(fit.place)));
  }
  return course;
}

// As dive_fits has it. `found`: a change or an outlier.
template <typename Found>
std::string DofsOf(const Found& found, const Course& course) {
  return found.entry ? course.coupled : std::string(Name(found.dof));
}

template <typename Found>
std::string NumberName(const Found& found) {
  return found.entry ? NameOf(*found.entry) : std::string(kParameterInfo[found.parameter].name);
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
              const Course& course,
              const std::string& before_text,
              Tables* tables) {
  for (const Change& change : event.changes) {
    tables->changes.push_back({.dof = DofsOf(change, course),
                               .parameter = NumberName(change),
                               .kind = std::string(Name(change.kind)),
                               .at = course.dives.at(static_cast<std::size_t>(change.at)),
                               .before = change.before,
                               .after = change.after,
                               .before_std = change.before_std,
                               .after_std = change.after_std,
                               .p_value = change.p_value,
                               .cause = CauseText(event),
                               .text = before_text + event.text,
                               .vehicle = course.vehicle});
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
    const Course course = CourseOf(vehicle, fits, dives, *tables);
    const ChangeOptions options;
    const ChangeSearch search =
        FindChanges(course.estimates, static_cast<int>(course.dives.size()), options);
    for (const ParameterOutlier& outlier : search.outliers) {
      tables->outliers.push_back({course.dives.at(static_cast<std::size_t>(outlier.dive)),
                                  DofsOf(outlier, course),
                                  NumberName(outlier),
                                  vehicle});
    }
    const auto file = vehicle_files.find(vehicle);
    const auto known =
        VehicleOf(file == vehicle_files.end() ? std::filesystem::path() : file->second);
    const std::string before_text = vehicles.size() > 1 ? vehicle + ": " : "";
    for (const ChangeEvent& event :
         NameCauses(search, course.estimates, course.dives, known, options)) {
      AddEvent(event, course, before_text, tables);
    }
  }
}

}  // namespace fathom
