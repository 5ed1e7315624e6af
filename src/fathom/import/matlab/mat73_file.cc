// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/matlab/mat73_file.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/import/recording/inflated.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <hdf5.h>

namespace fathom {
namespace {

constexpr std::string_view kHdf5Signature = "\x89HDF\r\n\x1a\n";
constexpr std::size_t kMatlabHeader = 512;  // [bytes]
constexpr std::size_t kMostLinks = 10'000;  // of one group
constexpr std::uint64_t kMostObjects = 20'000;

// Something of the HDF5 library that is to be closed.
class Hdf5Id {
 public:
  Hdf5Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Hdf5Id() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;

  hid_t get() const { return id_; }
  bool IsOpen() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// An attribute of text with a fixed length, such as MATLAB_class; empty if there is none.
std::string TextAttribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return "";
  const Hdf5Id attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (!attribute.IsOpen()) return "";
  const Hdf5Id type(H5Aget_type(attribute.get()), H5Tclose);
  const Hdf5Id space(H5Aget_space(attribute.get()), H5Sclose);
  constexpr std::size_t kLongest = 200;
  const std::size_t size = H5Tget_size(type.get());
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0 || size == 0 ||
      size > kLongest || H5Sget_simple_extent_npoints(space.get()) != 1) {
    return "";
  }
  std::string text(size, '\0');
  if (H5Aread(attribute.get(), type.get(), text.data()) < 0) return "";
  return text.substr(0, text.find('\0'));
}

// Names of the links of a group, at most kMostLinks.
std::vector<std::string> LinksOf(hid_t group) {
  std::vector<std::string> names;
  const auto take = [](hid_t, const char* name, const H5L_info_t*, void* all) -> herr_t {
    auto* list = static_cast<std::vector<std::string>*>(all);
    list->emplace_back(name);
    return list->size() < kMostLinks ? 0 : 1;
  };
  hsize_t from = 0;
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, &from, take, &names);
  return names;
}

// What a dataset is made of.
struct Hdf5Shape {
  std::vector<std::uint64_t> dimensions;  // in MATLAB's order
  std::uint64_t count = 1;
  H5T_class_t type_class = H5T_NO_CLASS;
  std::size_t number_size = 0;  // [bytes]
  bool is_readable = false;     // in memory that is bounded
};

Hdf5Shape ShapeOf(hid_t dataset) {
  Hdf5Shape shape;
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose);
  const Hdf5Id type(H5Dget_type(dataset), H5Tclose);
  std::array<hsize_t, H5S_MAX_RANK> dimensions = {};
  const int rank = space.IsOpen() ? H5Sget_simple_extent_ndims(space.get()) : -1;
  if (rank < 0 || !type.IsOpen() ||
      H5Sget_simple_extent_dims(space.get(), dimensions.data(), nullptr) < 0) {
    return shape;
  }
  shape.type_class = H5Tget_class(type.get());
  shape.number_size = H5Tget_size(type.get());
  shape.is_readable = true;
  for (int i = rank; i-- > 0;) {
    shape.dimensions.push_back(dimensions[i]);
    if (dimensions[i] != 0 && shape.count > kMostMatlabBytes / dimensions[i]) {
      shape.is_readable = false;
    } else {
      shape.count *= dimensions[i];
    }
  }
  while (shape.dimensions.size() < 2) shape.dimensions.push_back(1);
  const Hdf5Id plan(H5Dget_create_plist(dataset), H5Pclose);
  if (plan.IsOpen() && H5Pget_layout(plan.get()) == H5D_CHUNKED) {
    std::array<hsize_t, H5S_MAX_RANK> chunk = {};
    const int chunk_rank = H5Pget_chunk(plan.get(), H5S_MAX_RANK, chunk.data());
    std::uint64_t bytes = std::max<std::uint64_t>(shape.number_size, 1);
    for (int i = 0; i < chunk_rank; ++i) {
      if (chunk[i] == 0 || bytes > kMostMatlabBytes / 4 / chunk[i]) {
        shape.is_readable = false;
        return shape;
      }
      bytes *= chunk[i];
    }
  }
  return shape;
}

// The filters of a dataset are those of MATLAB, and its numbers are compressed at most once.
bool HasKnownFilters(hid_t plan, bool* is_deflated) {
  *is_deflated = false;
  const int num_filters = H5Pget_nfilters(plan);
  for (int i = 0; i < num_filters; ++i) {
    unsigned flags = 0;
    std::size_t num_values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(
        plan, static_cast<unsigned>(i), &flags, &num_values, nullptr, 0, nullptr, nullptr);
    if (filter == H5Z_FILTER_DEFLATE && !*is_deflated) {
      *is_deflated = true;
    } else if (filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_FLETCHER32) {
      return false;
    }
  }
  return true;
}

// Whether the chunks of a dataset are as long as they should be: the HDF5 library inflates each as
// far as it goes, and reads beyond the end of one that is too short.
bool HasSoundChunks(hid_t dataset, std::uint64_t file_size) {
  const Hdf5Id plan(H5Dget_create_plist(dataset), H5Pclose);
  if (!plan.IsOpen()) return false;
  if (H5Pget_layout(plan.get()) != H5D_CHUNKED) {
    const Hdf5Shape shape = ShapeOf(dataset);
    return shape.is_readable && H5Dget_storage_size(dataset) == shape.count * shape.number_size;
  }
  bool is_deflated = false;
  if (!HasKnownFilters(plan.get(), &is_deflated)) return false;
  const Hdf5Id type(H5Dget_type(dataset), H5Tclose);
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose);
  std::array<hsize_t, H5S_MAX_RANK> chunk = {};
  const int rank = H5Pget_chunk(plan.get(), H5S_MAX_RANK, chunk.data());
  std::size_t chunk_bytes = H5Tget_size(type.get());  // ShapeOf has looked at the product
  for (int i = 0; i < rank; ++i) chunk_bytes *= static_cast<std::size_t>(chunk[i]);
  hsize_t num_chunks = 0;
  if (H5Dget_num_chunks(dataset, space.get(), &num_chunks) < 0) return false;
  std::string stored;
  for (hsize_t i = 0; i < num_chunks; ++i) {
    std::array<hsize_t, H5S_MAX_RANK> corner = {};
    unsigned left_out = 0;  // filters
    haddr_t address = 0;
    hsize_t size = 0;
    if (H5Dget_chunk_info(dataset, space.get(), i, corner.data(), &left_out, &address, &size) < 0 ||
        size > file_size || left_out != 0) {
      return false;
    }
    stored.resize(static_cast<std::size_t>(size));
    std::uint32_t mask = 0;
    if (H5Dread_chunk(dataset, H5P_DEFAULT, corner.data(), &mask, stored.data()) < 0) return false;
    constexpr std::size_t kChecksum = 4;  // [bytes], where it was added before
    const std::size_t whole =
        is_deflated ? InflatedSize(stored, chunk_bytes + kChecksum).value_or(0) : stored.size();
    if (whole != chunk_bytes && whole != chunk_bytes + kChecksum) return false;
  }
  return true;
}

class Mat73File final : public MatlabFile {
 public:
  explicit Mat73File(const std::filesystem::path& path);

  std::string format() const override { return "mat7.3"; }

  const MatlabListing& listing() const override { return listing_; }

  MatlabNumbers Numbers(const MatlabArray& array, MatlabVariable* variable) const override;

 private:
  // What an object is called, and what it is a field of.
  struct Mat73Place {
    std::string name;
    std::string parent;
    std::string field;
    int depth = 0;
  };

  void ListObject(hid_t object, const Mat73Place& place);
  void ListGroup(hid_t group, const Mat73Place& place);
  void ListDataset(hid_t dataset, const Mat73Place& place);
  void ListReferences(hid_t dataset, const Mat73Place& place, bool is_cell);

  std::filesystem::path path_;
  Hdf5Id file_;
  std::uint64_t num_objects_ = 0;
  MatlabListing listing_;
};

hid_t OpenSilently(const std::filesystem::path& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // messages come from here
  return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
}

Mat73File::Mat73File(const std::filesystem::path& path)
    : path_(path), file_(OpenSilently(path), H5Fclose) {
  if (!file_.IsOpen()) {
    throw InputError(path.string() +
                     ": cannot be opened by the HDF5 library, expected a whole .mat "
                     "of version 7.3. Of one that is cut or damaged nothing can be read.");
  }
  const Hdf5Id root(H5Gopen2(file_.get(), "/", H5P_DEFAULT), H5Gclose);
  if (!root.IsOpen()) {
    throw InputError(path.string() + ": its HDF5 is damaged, expected a group of variables.");
  }
  for (const std::string& name : LinksOf(root.get())) {
    if (name.starts_with("#")) continue;  // what cells refer to
    const Hdf5Id object(H5Oopen(root.get(), name.c_str(), H5P_DEFAULT), H5Oclose);
    ListObject(object.get(), {name, "", ""});
  }
}

void Mat73File::ListObject(hid_t object, const Mat73Place& place) {
  if (object < 0) return listing_.PassOver(place.name, "is damaged");
  if (place.depth > kDeepestMatlabArray) return listing_.PassOver(place.name, "lies too deep");
  if (++num_objects_ > kMostObjects) return listing_.PassOver(place.name, "is one of too many");
  const std::string class_name = TextAttribute(object, "MATLAB_class");
  if (H5Aexists(object, "MATLAB_object_decode") > 0 && class_name != "struct" &&
      class_name != "cell") {
    return listing_.PassOver(
        place.name,
        fmt::format("is an object of class {}, which only MATLAB reads", Quoted(class_name)));
  }
  if (H5Aexists(object, "MATLAB_sparse") > 0) return listing_.PassOver(place.name, "is sparse");
  if (class_name == "function_handle") return listing_.PassOver(place.name, "is a function");
  switch (H5Iget_type(object)) {
    case H5I_GROUP:
      return ListGroup(object, place);
    case H5I_DATASET:
      return ListDataset(object, place);
    default:
      return listing_.PassOver(place.name, "is no array");
  }
}

void Mat73File::ListGroup(hid_t group, const Mat73Place& place) {
  const std::vector<std::string> fields = LinksOf(group);
  listing_.TakeFieldNames(place.name, fields);
  for (const std::string& field : fields) {
    const Hdf5Id object(H5Oopen(group, field.c_str(), H5P_DEFAULT), H5Oclose);
    // Of an array of structs each field is an array of references.
    ListObject(object.get(), {place.name + "." + field, place.name, field, place.depth + 1});
  }
}

void Mat73File::ListDataset(hid_t dataset, const Mat73Place& place) {
  const std::string class_name = TextAttribute(dataset, "MATLAB_class");
  const Hdf5Shape shape = ShapeOf(dataset);
  if (class_name == "char") return listing_.AddText();
  if (!shape.is_readable) {
    return listing_.PassOver(place.name, "is damaged, or takes more than 200 MB");
  }
  if (H5Aexists(dataset, "MATLAB_empty") > 0) {
    return listing_.Add({place.name, "", "", class_name});
  }
  switch (shape.type_class) {
    case H5T_REFERENCE:
      return ListReferences(dataset, place, class_name == "cell");
    case H5T_COMPOUND:
      return listing_.PassOver(place.name, "is complex");
    case H5T_STRING:
      return listing_.AddText();
    case H5T_INTEGER:
    case H5T_FLOAT:
      break;
    default:
      return listing_.PassOver(place.name, "is no array of numbers");
  }
  if (shape.dimensions.size() > 2) {
    return listing_.PassOver(place.name, fmt::format("has {} dimensions", shape.dimensions.size()));
  }
  H5O_info_t info;
  if (H5Oget_info2(dataset, &info, H5O_INFO_BASIC) < 0) {
    return listing_.PassOver(place.name, "is damaged");
  }
  MatlabArray array;
  array.name = place.name;
  array.parent = place.parent;
  array.field = place.field;
  array.class_name = class_name.empty() ? "array" : class_name;
  array.rows = shape.dimensions[0];
  array.columns = shape.dimensions[1];
  array.type = NumberType::kFloat64;  // as the library hands them on
  array.variable = info.addr;
  listing_.Add(std::move(array));
}

void Mat73File::ListReferences(hid_t dataset, const Mat73Place& place, bool is_cell) {
  const Hdf5Shape shape = ShapeOf(dataset);
  if (shape.count > kMostObjects || shape.number_size != sizeof(hobj_ref_t)) {
    return listing_.PassOver(place.name, "holds too many references");
  }
  if (shape.count > 0 && !HasSoundChunks(dataset, std::filesystem::file_size(path_))) {
    return listing_.PassOver(place.name, "is damaged");
  }
  std::vector<hobj_ref_t> references(static_cast<std::size_t>(shape.count));
  if (shape.count > 0 &&
      H5Dread(dataset, H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()) < 0) {
    return listing_.PassOver(place.name, "is damaged");
  }
  for (std::size_t i = 0; i < references.size(); ++i) {
    const Hdf5Id object(H5Rdereference2(dataset, H5P_DEFAULT, H5R_OBJECT, &references[i]),
                        H5Oclose);
    Mat73Place inner = {fmt::format("{}[{}]", place.name, i + 1), "", "", place.depth + 1};
    if (!is_cell && !place.parent.empty()) {
      inner.parent = MatlabElementName(place.parent, i, references.size());
      inner.field = place.field;
      inner.name = inner.parent + "." + inner.field;
    }
    ListObject(object.get(), inner);
  }
}

MatlabNumbers Mat73File::Numbers(const MatlabArray& array, MatlabVariable* variable) const {
  if (variable->place != array.variable) {
    variable->bytes.reset();
    auto bytes = std::make_shared<std::string>();
    const Hdf5Id dataset(H5Oopen_by_addr(file_.get(), array.variable), H5Oclose);
    if (dataset.IsOpen() && HasSoundChunks(dataset.get(), std::filesystem::file_size(path_))) {
      bytes->resize(static_cast<std::size_t>(array.num_bytes()));
    }
    if (bytes->empty() ||
        H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes->data()) <
            0) {
      throw InputError(fmt::format("{}: {} is damaged, expected {} x {} numbers.",
                                   path_.string(),
                                   Printable(array.name),
                                   array.rows,
                                   array.columns));
    }
    *variable = {array.variable, std::move(bytes)};
  }
  return {variable->bytes, 0, NumberType::kFloat64, {}};
}

}  // namespace

bool LooksLikeMat73(std::string_view first_bytes) {
  return first_bytes.starts_with(kHdf5Signature) ||
         (first_bytes.size() > kMatlabHeader &&
          first_bytes.substr(kMatlabHeader).starts_with(kHdf5Signature));
}

std::unique_ptr<MatlabFile> OpenMat73(const std::filesystem::path& path) {
  return std::make_unique<Mat73File>(path);
}

}  // namespace fathom
