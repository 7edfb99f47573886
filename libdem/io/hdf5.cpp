#include "libdem/io/hdf5.h"

#include "libdem/world.h"

namespace dem::io::hdf5 {

namespace {

hid_t open(const std::string& path, Access access) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported by exception, not printed
  switch (access) {
    case Access::read:
      return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    case Access::write:
      return H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    case Access::create:
      return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  }
  return -1;
}

}  // namespace

File::File(const std::string& path, Access access) : path_(path), file_(open(path, access), H5Fclose) {
  if (file_ < 0) throw RunError("cannot open the record " + path + ": not an HDF5 file, damaged, or no permission");
}

void File::fail(const std::string& action, const std::string& name) const {
  throw RunError("cannot " + action + " '" + name + "' in the record " + path_);
}

Handle File::checked(hid_t id, Handle::Close close, const std::string& action, const std::string& name) const {
  if (id < 0) fail(action, name);
  return {id, close};
}

void File::flush() {
  if (H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0) fail("flush", "/");
}

void File::make_group(const std::string& name) {
  checked(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "create", name);
}

bool File::has(const std::string& name) const { return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0; }

void File::remove(const std::string& name) {
  if (H5Ldelete(file_, name.c_str(), H5P_DEFAULT) < 0) fail("delete", name);
}

void File::rename(const std::string& from, const std::string& to) {
  if (H5Lmove(file_, from.c_str(), H5L_SAME_LOC, to.c_str(), H5P_DEFAULT, H5P_DEFAULT) < 0) fail("rename", from);
}

std::vector<std::string> File::children(const std::string& group) const {
  const Handle handle = checked(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose, "open", group);
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  if (H5Literate(handle, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names) < 0) fail("list", group);
  return names;
}

void File::put_scalar(const std::string& object, const std::string& name, hid_t type, const void* value) {
  const Handle space = checked(H5Screate(H5S_SCALAR), H5Sclose, "describe", name);
  const Handle attribute = checked(
      H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, "create", name);
  if (H5Awrite(attribute, type, value) < 0) fail("write", name);
}

void File::put_attribute(const std::string& object, const std::string& name, const std::string& value) {
  // Of variable length: a fixed one would have to fit into the 64 kB of an object's header.
  const Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose, "describe", name);
  if (H5Tset_size(type, H5T_VARIABLE) < 0 || H5Tset_cset(type, H5T_CSET_UTF8) < 0) fail("describe", name);
  const char* text = value.c_str();
  put_scalar(object, name, type, &text);
}
void File::put_attribute(const std::string& object, const std::string& name, double value) {
  put_scalar(object, name, H5T_NATIVE_DOUBLE, &value);
}
void File::put_attribute(const std::string& object, const std::string& name, std::uint64_t value) {
  put_scalar(object, name, H5T_NATIVE_UINT64, &value);
}

std::uint64_t File::attribute(const std::string& object, const std::string& name) const {
  const Handle attribute =
      checked(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "open", name);
  std::uint64_t value = 0;
  if (H5Aread(attribute, H5T_NATIVE_UINT64, &value) < 0) fail("read", name);
  return value;
}

void File::put_raw(const std::string& name, hid_t type, const void* values, std::size_t count, std::size_t columns) {
  const hsize_t extent[2] = {count / columns, columns};
  const Handle space = checked(H5Screate_simple(columns == 1 ? 1 : 2, extent, nullptr), H5Sclose, "describe", name);
  const Handle data = checked(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                              H5Dclose, "create", name);
  if (count > 0 && H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) fail("write", name);
}

std::size_t File::size(const std::string& name) const {
  const Handle data = checked(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, "open", name);
  const Handle space = checked(H5Dget_space(data), H5Sclose, "describe", name);
  return static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
}

void File::get_raw(const std::string& name, hid_t type, void* values) const {
  const Handle data = checked(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, "open", name);
  if (H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) fail("read", name);
}

}  // namespace dem::io::hdf5
