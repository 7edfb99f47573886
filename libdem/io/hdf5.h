// The few HDF5 calls that the record needs: handles that close themselves, and errors as RunError with file and object.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace dem::io::hdf5 {

template <class T>
struct Native;
template <>
struct Native<double> {
  static hid_t type() { return H5T_NATIVE_DOUBLE; }
};
template <>
struct Native<std::uint64_t> {
  static hid_t type() { return H5T_NATIVE_UINT64; }
};
template <>
struct Native<std::uint32_t> {
  static hid_t type() { return H5T_NATIVE_UINT32; }
};

class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

enum class Access { read, write, create };

class File {
 public:
  File(const std::string& path, Access access);
  void flush();

  void make_group(const std::string& name);
  bool has(const std::string& name) const;
  void remove(const std::string& name);
  void rename(const std::string& from, const std::string& to);
  std::vector<std::string> children(const std::string& group) const;  // in order of names

  void put_attribute(const std::string& object, const std::string& name, const std::string& value);
  void put_attribute(const std::string& object, const std::string& name, double value);
  void put_attribute(const std::string& object, const std::string& name, std::uint64_t value);
  std::uint64_t attribute(const std::string& object, const std::string& name) const;

  // Rows of `columns` numbers; columns = 1 gives a one-dimensional dataset.
  template <class T>
  void put(const std::string& name, const std::vector<T>& values, std::size_t columns) {
    put_raw(name, Native<T>::type(), values.data(), values.size(), columns);
  }
  template <class T>
  std::vector<T> get(const std::string& name) const {
    std::vector<T> values(size(name));
    get_raw(name, Native<T>::type(), values.data());
    return values;
  }

 private:
  [[noreturn]] void fail(const std::string& action, const std::string& name) const;
  Handle checked(hid_t id, Handle::Close close, const std::string& action, const std::string& name) const;
  void put_scalar(const std::string& object, const std::string& name, hid_t type, const void* value);
  void put_raw(const std::string& name, hid_t type, const void* values, std::size_t count, std::size_t columns);
  std::size_t size(const std::string& name) const;
  void get_raw(const std::string& name, hid_t type, void* values) const;

  std::string path_;
  Handle file_;
};

}  // namespace dem::io::hdf5
