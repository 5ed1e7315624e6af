// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/matlab/matlab_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/import/recording/channel_stamps.h"
#include "fathom/import/recording/find_channel.h"
#include "fathom/import/recording/missing_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// A column of an array, which is a field of a channel.
struct MatlabColumn {
  const MatlabArray* array = nullptr;
  std::size_t index = 0;
};

// The arrays of a channel.
struct MatlabSource {
  std::vector<const MatlabArray*> arrays;
  const MatlabArray* time = nullptr;  // null: there are no stamps
  std::vector<MatlabColumn> columns;  // in the order of the channel's fields
};

bool IsTimeName(std::string_view field) {
  return field == "time" || field == "Time" || field == "t";
}

// The field of stamps among the arrays of a struct: a vector of which another array has as many
// samples. Null if there is none.
const MatlabArray* FindTime(const std::vector<const MatlabArray*>& fields) {
  for (const MatlabArray* time : fields) {
    if (!IsTimeName(time->field) || time->num_fields() != 1) continue;
    for (const MatlabArray* other : fields) {
      if (other != time && other->num_samples() == time->num_samples()) return time;
    }
  }
  return nullptr;
}

class MatlabRecording final : public Recording {
 public:
  MatlabRecording(const std::filesystem::path& path, std::unique_ptr<MatlabFile> file);

  const Contents& contents() const override { return contents_; }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override;

 private:
  void AddArray(const MatlabArray& array);
  void AddStruct(const std::string& name, const std::vector<const MatlabArray*>& fields);
  void Add(Channel channel, MatlabSource source);

  // `variable` keeps the bytes that the next array may need too.
  void LookForMissing(const Channel& channel, MatlabVariable* variable, MissingNumbers* missing);

  std::filesystem::path path_;
  std::unique_ptr<MatlabFile> file_;
  std::map<std::string, MatlabSource> sources_;  // by channel
  Contents contents_;
};

MatlabRecording::MatlabRecording(const std::filesystem::path& path,
                                 std::unique_ptr<MatlabFile> file)
    : path_(path), file_(std::move(file)) {
  contents_.format = file_->format();
  contents_.size_bytes = std::filesystem::file_size(path);
  contents_.read_bytes = contents_.size_bytes - file_->listing().damaged_bytes;
  contents_.remarks = file_->listing().Remarks();
  std::map<std::string, std::vector<const MatlabArray*>> structs;
  for (const MatlabArray& array : file_->listing().arrays()) {
    if (array.parent.empty()) {
      AddArray(array);
    } else {
      structs[array.parent].push_back(&array);
    }
  }
  for (const auto& [name, fields] : structs) AddStruct(name, fields);
  std::ranges::sort(contents_.channels, {}, &Channel::name);
  MissingNumbers missing;
  MatlabVariable variable;
  for (const Channel& channel : contents_.channels) LookForMissing(channel, &variable, &missing);
  missing.WriteTo(&contents_.remarks);
}

void MatlabRecording::LookForMissing(const Channel& channel,
                                     MatlabVariable* variable,
                                     MissingNumbers* missing) {
  const MatlabSource& source = sources_.at(channel.name);
  std::map<const MatlabArray*, MatlabNumbers> numbers;
  try {
    for (const MatlabArray* array : source.arrays) {
      numbers[array] = file_->Numbers(*array, variable);
    }
  } catch (const InputError&) {
    contents_.remarks.push_back(fmt::format("{} is damaged.", Quoted(channel.name)));
    return;
  }
  std::vector<const MatlabNumbers*> numbers_of_field;
  for (const MatlabColumn& column : source.columns) {
    numbers_of_field.push_back(&numbers.at(column.array));
  }
  missing->Look(channel, [&](std::size_t sample, std::size_t field) {
    const MatlabColumn& column = source.columns[field];
    return numbers_of_field[field]->At(column.array->IndexOf(sample, column.index));
  });
}

void MatlabRecording::AddArray(const MatlabArray& array) {
  Channel channel;
  channel.name = array.name;
  channel.type = fmt::format("{} {}x{}", array.class_name, array.rows, array.columns);
  channel.count = array.num_samples();
  MatlabSource source;
  source.arrays = {&array};
  for (std::size_t i = 0; i < array.num_fields(); ++i) {
    channel.fields.push_back(
        {array.num_fields() == 1 ? "value" : std::to_string(i + 1), "", static_cast<int>(i + 1)});
    source.columns.push_back({&array, i});
  }
  Add(std::move(channel), std::move(source));
}

void MatlabRecording::AddStruct(const std::string& name,
                                const std::vector<const MatlabArray*>& fields) {
  const MatlabArray* time = FindTime(fields);
  std::uint64_t num_bytes = 0;
  for (const MatlabArray* array : fields) num_bytes += array->num_bytes();
  if (time == nullptr || num_bytes > kMostMatlabBytes || sources_.contains(name)) {
    for (const MatlabArray* array : fields) AddArray(*array);
    return;
  }
  Channel channel;
  channel.name = name;
  channel.type = "struct";
  MatlabSource source;
  source.time = time;
  for (const MatlabArray* array : fields) {
    if (array->num_samples() != time->num_samples()) {
      AddArray(*array);
      continue;
    }
    source.arrays.push_back(array);
    for (std::size_t i = 0; i < array->num_fields(); ++i) {
      channel.fields.push_back(
          {array->num_fields() == 1 ? array->field : fmt::format("{}.{}", array->field, i + 1),
           "",
           static_cast<int>(source.columns.size() + 1)});
      source.columns.push_back({array, i});
    }
  }
  ChannelStamps stamps;
  MatlabVariable variable;
  const MatlabNumbers times = file_->Numbers(*time, &variable);
  for (std::size_t i = 0; i < time->num_samples(); ++i) stamps.Add(times.At(i));
  stamps.WriteTo(&channel);
  contents_.remarks.push_back(fmt::format(
      "{}: the stamps are its field {}, in seconds.", Printable(name), Quoted(time->field)));
  Add(std::move(channel), std::move(source));
}

void MatlabRecording::Add(Channel channel, MatlabSource source) {
  sources_.emplace(channel.name, std::move(source));
  contents_.channels.push_back(std::move(channel));
}

std::vector<std::string> MatlabRecording::Read(std::span<const Selection> selections,
                                               const SampleSink& sink) const {
  std::map<std::string, std::vector<std::size_t>> wanted;  // selections by channel
  for (std::size_t i = 0; i < selections.size(); ++i) {
    wanted[FindChannel(contents_, path_, selections[i]).name].push_back(i);
  }
  MatlabVariable variable;
  for (const auto& [name, of_channel] : wanted) {
    const MatlabSource& source = sources_.at(name);
    const Channel& channel = FindChannel(contents_, path_, {name, {}});
    std::map<const MatlabArray*, MatlabNumbers> numbers;
    for (const MatlabArray* array : source.arrays) {
      numbers[array] = file_->Numbers(*array, &variable);
    }
    std::vector<std::vector<MatlabColumn>> columns;
    for (const std::size_t i : of_channel) {
      std::vector<MatlabColumn>& of_selection = columns.emplace_back();
      for (const std::string& field : selections[i].fields) {
        const auto at = std::find_if(channel.fields.begin(),
                                     channel.fields.end(),
                                     [&](const Field& f) { return f.name == field; });
        of_selection.push_back(source.columns[at - channel.fields.begin()]);
      }
    }
    std::vector<double> values;
    for (std::size_t sample = 0; sample < channel.count; ++sample) {
      const double time = source.time == nullptr ? NAN : numbers.at(source.time).At(sample);
      for (std::size_t k = 0; k < of_channel.size(); ++k) {
        values.clear();
        for (const MatlabColumn& column : columns[k]) {
          values.push_back(
              numbers.at(column.array).At(column.array->IndexOf(sample, column.index)));
        }
        sink(of_channel[k], time, values);
      }
    }
  }
  return {};
}

}  // namespace

std::unique_ptr<Recording> OpenMatlab(const std::filesystem::path& path,
                                      std::unique_ptr<MatlabFile> file) {
  return std::make_unique<MatlabRecording>(path, std::move(file));
}

}  // namespace fathom
