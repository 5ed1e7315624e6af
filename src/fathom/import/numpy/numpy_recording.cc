// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/numpy/numpy_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/import/numpy/npy_header.h"
#include "fathom/import/numpy/zip_file.h"
#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/channel_stamps.h"
#include "fathom/import/recording/find_channel.h"
#include "fathom/import/recording/missing_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kMostNumpyBytes = 200'000'000;  // of an array, as of a .mat
constexpr std::size_t kMostArraysOfNumpy = 10'000;
constexpr std::size_t kMostFieldsOfNumpy = 100'000;  // of all arrays
constexpr std::size_t kMostRemarksOfNumpy = 50;
constexpr std::string_view kNpyEnding = ".npy";

// A field of a channel: where the number of a sample stands.
struct NumpyColumn {
  NumpyNumber number;
  std::size_t offset = 0;  // of sample 0, from the first element on
};

struct NumpyArray {
  std::optional<ZipEntry> entry;  // nothing: the file is the array
  std::size_t begin = 0;          // of the elements, from the begin of the array's bytes
  std::size_t num_bytes = 0;      // of the elements
  std::size_t step = 0;           // from one sample to the next [bytes]
  std::vector<NumpyColumn> columns;
  std::map<std::string, std::size_t> column_of;  // by field
  std::optional<NumpyColumn> time;
};

// The dimensions that say something: one of 1 says nothing where there are more than two.
std::vector<std::uint64_t> ShapeOf(const NpyHeader& header) {
  std::vector<std::uint64_t> shape = header.shape;
  if (shape.size() > 2) std::erase(shape, 1U);
  return shape;
}

// How many elements; the largest number for more than that.
std::uint64_t Product(const std::vector<std::uint64_t>& shape) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  if (std::find(shape.begin(), shape.end(), 0U) != shape.end()) return 0;
  std::uint64_t product = 1;
  for (const std::uint64_t length : shape)
    product = product > kMost / length ? kMost : product * length;
  return product;
}

// Where the samples of an array of one or two dimensions stand.
struct SampleLayout {
  std::uint64_t num_samples = 0;
  std::uint64_t num_columns = 0;
  std::size_t step = 0;       // from one sample to the next [bytes]
  std::size_t apart = 0;      // from one column to the next
  bool is_by_sample = false;  // all of a sample stands together
};

SampleLayout LayoutOf(std::vector<std::uint64_t> shape, const NpyHeader& header) {
  shape.resize(2, 1);
  const bool is_wide = shape[0] < shape[1];
  SampleLayout layout;
  layout.num_samples = is_wide ? shape[1] : shape[0];
  layout.num_columns = is_wide ? shape[0] : shape[1];
  const std::size_t element = header.element_size;
  // A product beyond 64 bits would wrap; so many columns are not there anyway.
  const std::uint64_t columns = std::min(layout.num_columns, std::uint64_t{1} << 32);
  layout.is_by_sample = layout.num_columns == 1 || header.is_fortran == is_wide;
  layout.step = layout.is_by_sample ? element * columns : element;
  layout.apart = layout.is_by_sample ? element : element * layout.num_samples;
  return layout;
}

// The field that holds the stamps; null if there is none.
const NpyField* FindStamps(const std::vector<NpyField>& fields) {
  const NpyField* date = nullptr;
  int num_dates = 0;
  for (const NpyField& field : fields) {
    if (field.name == "time" || field.name == "Time" || field.name == "t") return &field;
    if (field.number.kind != 'M') continue;
    date = &field;
    ++num_dates;
  }
  return num_dates == 1 ? date : nullptr;
}

class NumpyRecording final : public Recording {
 public:
  NumpyRecording(const std::filesystem::path& path, bool is_zip);

  const Contents& contents() const override { return contents_; }

  std::vector<std::string> Read(std::span<const Selection> selections,
                                const SampleSink& sink) const override;

 private:
  void List(ByteFile* file);
  void ListZip(ByteFile* file);

  // `bytes`: of the elements, as many as there are.
  void Add(const std::string& name,
           const std::string& bytes,
           const NpyHeader& header,
           NumpyArray array);

  // Leaves the samples that are there; false if the array is of no use.
  bool CutToWhole(const std::string& name,
                  const std::string& bytes,
                  std::uint64_t count,
                  std::size_t element_size,
                  SampleLayout* layout);

  void AddColumns(const NpyHeader& header,
                  const SampleLayout& layout,
                  Channel* channel,
                  NumpyArray* array);
  void AddStamps(const std::string& bytes, const NumpyArray& array, Channel* channel);

  void PassOver(const std::string& name, const std::string& why) {
    Remark(fmt::format("{} {}: passed over.", Quoted(name), why));
  }
  void Remark(std::string remark) {
    if (contents_.remarks.size() < kMostRemarksOfNumpy) {
      contents_.remarks.push_back(std::move(remark));
    }
  }

  std::string Load(ByteFile* file, const NumpyArray& array) const;

  std::filesystem::path path_;
  std::map<std::string, NumpyArray> arrays_;  // by channel
  std::size_t num_fields_ = 0;
  std::size_t num_scalars_ = 0;
  std::size_t num_empty_ = 0;
  bool has_numbered_columns_ = false;
  MissingNumbers missing_;
  Contents contents_;
};

NumpyRecording::NumpyRecording(const std::filesystem::path& path, bool is_zip) : path_(path) {
  ByteFile file(path);
  contents_.format = is_zip ? "npz" : "npy";
  contents_.size_bytes = file.size();
  contents_.read_bytes = file.size();
  if (is_zip) {
    ListZip(&file);
  } else {
    List(&file);
  }
  std::ranges::sort(contents_.channels, {}, &Channel::name);
  if (num_scalars_ + num_empty_ > 0) {
    Remark(fmt::format(
        "no channels: {}, {}.", Plural(num_scalars_, "scalar"), Plural(num_empty_, "empty array")));
  }
  missing_.WriteTo(&contents_.remarks);
  if (has_numbered_columns_) {
    Remark("columns of an array are counted from 1: 1 is what numpy calls [:, 0].");
  }
}

void NumpyRecording::List(ByteFile* file) {
  const NpyHeader header = ParseNpyHeader(path_.string(), file->Copy(0, kMostNpyHeader));
  const std::string name = path_.stem().string();
  if (file->size() - header.size > kMostNumpyBytes) {
    return PassOver(name, "takes more than 200 MB");
  }
  Add(name, file->Copy(header.size, file->size() - header.size), header, {});
}

void NumpyRecording::ListZip(ByteFile* file) {
  for (ZipEntry& entry : ReadZipDirectory(file)) {
    if (!entry.name.ends_with(kNpyEnding)) {
      PassOver(entry.name, "is no array");
      continue;
    }
    const std::string name = entry.name.substr(0, entry.name.size() - kNpyEnding.size());
    if (entry.whole_bytes > kMostNumpyBytes) {
      PassOver(name, "takes more than 200 MB");
      continue;
    }
    const auto bytes = Unzipped(file, entry, kMostNumpyBytes);
    if (!bytes) {
      contents_.read_bytes -= entry.packed_bytes;
      PassOver(name, entry.is_encrypted ? "is encrypted" : "is damaged");
      continue;
    }
    try {
      const NpyHeader header = ParseNpyHeader(Printable(name), *bytes);
      NumpyArray array;
      array.entry = std::move(entry);
      Add(name, bytes->substr(header.size), header, std::move(array));
    } catch (const InputError& error) {
      Remark(fmt::format("{} It is passed over.", error.what()));
    }
  }
}

void NumpyRecording::Add(const std::string& name,
                         const std::string& bytes,
                         const NpyHeader& header,
                         NumpyArray array) {
  const auto shape = ShapeOf(header);
  const std::uint64_t count = Product(shape);
  if (count == 0) {
    ++num_empty_;
    return;
  }
  if (shape.size() > 2) return PassOver(name, fmt::format("has {} dimensions", shape.size()));
  if (header.fields.empty())
    return PassOver(name, "holds texts, objects, complex numbers or long doubles");
  if (count == 1) {
    ++num_scalars_;
    return;
  }
  SampleLayout layout = LayoutOf(shape, header);
  if (layout.num_columns > 1 && header.is_structured) {
    return PassOver(name, "has two dimensions of elements with fields");
  }
  if (!CutToWhole(name, bytes, count, header.element_size, &layout)) return;
  const std::uint64_t num_new = header.fields.size() * layout.num_columns;
  if (arrays_.size() == kMostArraysOfNumpy || num_fields_ + num_new > kMostFieldsOfNumpy) {
    return PassOver(name, "comes behind 10000 arrays or 100000 columns");
  }
  if (arrays_.contains(name)) {
    return PassOver(name, "stands in the file again; the first one is read");
  }
  num_fields_ += num_new;
  array.begin = header.size;
  array.num_bytes = bytes.size();
  array.step = layout.step;
  Channel channel;
  channel.name = name;
  channel.type = header.is_structured ? "structured" : "array";
  for (std::size_t i = 0; i < header.shape.size(); ++i) {
    channel.type += fmt::format("{}{}", i == 0 ? " " : "x", header.shape[i]);
  }
  channel.count = layout.num_samples;
  AddColumns(header, layout, &channel, &array);
  if (header.num_others > 0) {
    Remark(fmt::format("{}: {} without numbers, as texts, left out.",
                       Quoted(name),
                       Plural(header.num_others, "field")));
  }
  const NpyField* time = header.is_structured ? FindStamps(header.fields) : nullptr;
  if (time != nullptr) {
    array.time = NumpyColumn{time->number, time->offset};
    AddStamps(bytes, array, &channel);
    Remark(fmt::format(
        "{}: the stamps are its field {}, in seconds.", Printable(name), Quoted(time->name)));
  }
  missing_.Look(channel, [&](std::size_t sample, std::size_t field) {
    const NumpyColumn& column = array.columns[field];
    return ValueOf(column.number, bytes, sample * array.step + column.offset);
  });
  contents_.channels.push_back(std::move(channel));
  arrays_.emplace(name, std::move(array));
}

bool NumpyRecording::CutToWhole(const std::string& name,
                                const std::string& bytes,
                                std::uint64_t count,
                                std::size_t element_size,
                                SampleLayout* layout) {
  const std::uint64_t available = bytes.size() / element_size;  // elements
  if (count <= available) {
    const std::uint64_t num_behind = bytes.size() - count * element_size;
    if (num_behind > 0) {
      Remark(fmt::format("{} is followed by {} that belong to no array: not read.",
                         Quoted(name),
                         Plural(num_behind, "byte")));
    }
    return true;
  }
  const std::uint64_t num_there = bytes.size() / layout->step;
  if (!layout->is_by_sample || num_there < 2) {
    contents_.read_bytes -= std::min<std::uint64_t>(bytes.size(), contents_.read_bytes);
    Remark(fmt::format("{} ends before its last element: passed over.", Quoted(name)));
    return false;
  }
  // A file that is cut between two samples is not complete either.
  const std::uint64_t left = std::max<std::uint64_t>(1, bytes.size() % layout->step);
  contents_.read_bytes -= std::min(left, contents_.read_bytes);
  Remark(fmt::format("{} ends before its last sample: {} of {} are there.",
                     Quoted(name),
                     num_there,
                     Plural(layout->num_samples, "sample")));
  layout->num_samples = num_there;
  return true;
}

void NumpyRecording::AddColumns(const NpyHeader& header,
                                const SampleLayout& layout,
                                Channel* channel,
                                NumpyArray* array) {
  for (std::uint64_t i = 0; i < layout.num_columns; ++i) {
    for (const NpyField& field : header.fields) {
      const bool is_date = field.number.kind == 'M' || field.number.kind == 'm';
      const std::string called = header.is_structured      ? field.name
                                 : layout.num_columns == 1 ? "value"
                                                           : std::to_string(i + 1);
      // The first field of a name is the one that a map can mean.
      array->column_of.emplace(called, array->columns.size());
      channel->fields.push_back(
          {called, is_date ? "s" : "", static_cast<int>(channel->fields.size() + 1)});
      array->columns.push_back(
          {field.number, static_cast<std::size_t>(i) * layout.apart + field.offset});
    }
  }
  if (layout.num_columns > 1) has_numbered_columns_ = true;
}

void NumpyRecording::AddStamps(const std::string& bytes,
                               const NumpyArray& array,
                               Channel* channel) {
  ChannelStamps stamps;
  for (std::size_t i = 0; i < channel->count; ++i) {
    stamps.Add(ValueOf(array.time->number, bytes, i * array.step + array.time->offset));
  }
  stamps.WriteTo(channel);
  if (array.time->number.kind == 'M') contents_.utc_of_zero = 0.0;
}

std::string NumpyRecording::Load(ByteFile* file, const NumpyArray& array) const {
  std::string bytes;
  if (array.entry) {
    if (auto all = Unzipped(file, *array.entry, kMostNumpyBytes)) {
      bytes = *std::move(all);
      bytes.erase(0, array.begin);
    }
  } else {
    bytes = file->Copy(array.begin, array.num_bytes);
  }
  if (bytes.size() < array.num_bytes) {
    throw InputError(path_.string() + ": has changed since it was opened.");
  }
  return bytes;
}

std::vector<std::string> NumpyRecording::Read(std::span<const Selection> selections,
                                              const SampleSink& sink) const {
  std::map<std::string, std::vector<std::size_t>> wanted;  // selections by channel
  for (std::size_t i = 0; i < selections.size(); ++i) {
    wanted[FindChannel(contents_, path_, selections[i]).name].push_back(i);
  }
  ByteFile file(path_);
  for (const auto& [name, of_channel] : wanted) {
    const NumpyArray& array = arrays_.at(name);
    const Channel& channel = FindChannel(contents_, path_, {name, {}});
    const std::string bytes = Load(&file, array);
    std::vector<std::vector<NumpyColumn>> columns;
    for (const std::size_t i : of_channel) {
      auto& of_selection = columns.emplace_back();
      for (const std::string& field : selections[i].fields) {
        of_selection.push_back(array.columns[array.column_of.at(field)]);
      }
    }
    std::vector<double> values;
    for (std::size_t sample = 0; sample < channel.count; ++sample) {
      const std::size_t at = sample * array.step;
      const double time =
          array.time ? ValueOf(array.time->number, bytes, at + array.time->offset) : NAN;
      for (std::size_t k = 0; k < of_channel.size(); ++k) {
        values.clear();
        for (const NumpyColumn& column : columns[k]) {
          values.push_back(ValueOf(column.number, bytes, at + column.offset));
        }
        sink(of_channel[k], time, values);
      }
    }
  }
  return {};
}

}  // namespace

bool LooksLikeNpz(std::string_view first_bytes) {
  constexpr std::size_t kName = 30;  // behind the header of the first entry
  if (!LooksLikeZip(first_bytes) || first_bytes.size() < kName) return false;
  const std::size_t size = NumberAt<std::uint16_t>(first_bytes, 26);
  return first_bytes.substr(kName, size).ends_with(kNpyEnding);
}

std::unique_ptr<Recording> OpenNpy(const std::filesystem::path& path) {
  return std::make_unique<NumpyRecording>(path, /*is_zip=*/false);
}

std::unique_ptr<Recording> OpenNpz(const std::filesystem::path& path) {
  return std::make_unique<NumpyRecording>(path, /*is_zip=*/true);
}

}  // namespace fathom
