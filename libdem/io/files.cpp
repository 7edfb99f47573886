#include "libdem/io/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "libdem/world.h"

namespace dem::io {

namespace {

[[noreturn]] void fail(const std::string& action, const std::string& path) {
  throw RunError("cannot " + action + " " + path + ": " + std::strerror(errno));
}

class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : path_(path), fd_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {
    if (fd_ < 0) fail("open", path_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  void write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
      const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail("write", path_);
      bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
  }
  void sync() {
    if (::fsync(fd_) != 0) fail("sync", path_);
  }
  void close() {  // a full disk may show only here
    const int fd = fd_;
    fd_ = -1;
    if (::close(fd) != 0) fail("close", path_);
  }

 private:
  std::string path_;
  int fd_;
};

}  // namespace

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const std::string& path, std::span<const std::uint8_t> bytes, Durability durability,
                std::span<const std::uint8_t> head) {
  const std::string aside = path + ".part";
  {
    Descriptor file(aside, O_WRONLY | O_CREAT | O_TRUNC);
    file.write(head);
    file.write(bytes);
    if (durability == Durability::synced) file.sync();
    file.close();
  }
  if (std::rename(aside.c_str(), path.c_str()) != 0) fail("rename", aside);
  if (durability == Durability::synced) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    Descriptor(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY).sync();
  }
}

void write_file(const std::string& path, std::string_view text) {
  write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, Durability::renamed);
}

}  // namespace dem::io
