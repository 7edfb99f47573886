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

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

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
  void go_to(std::uint64_t place) {
    if (::lseek(fd_, static_cast<off_t>(place), SEEK_SET) < 0) fail("write", path_);
  }
  void go_to_end() {
    if (::lseek(fd_, 0, SEEK_END) < 0) fail("write", path_);
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

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

NewFile::NewFile(std::string path)
    : path_(std::move(path)), file_(std::make_unique<Descriptor>(path_ + ".part", O_WRONLY | O_CREAT | O_TRUNC)) {}

NewFile::~NewFile() = default;

void NewFile::write(std::span<const std::uint8_t> bytes) { file_->write(bytes); }
void NewFile::write(std::string_view text) { file_->write(bytes_of(text)); }

void NewFile::write_over(std::uint64_t place, std::span<const std::uint8_t> bytes) {
  file_->go_to(place);
  file_->write(bytes);
  file_->go_to_end();
}

void NewFile::done(Durability durability) {
  if (durability == Durability::synced) file_->sync();
  file_->close();
  const std::string aside = path_ + ".part";
  if (std::rename(aside.c_str(), path_.c_str()) != 0) fail("rename", aside);
  if (durability == Durability::synced) {
    const std::string folder = std::filesystem::path(path_).parent_path().string();
    Descriptor(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY).sync();
  }
}

void write_file(const std::string& path, std::span<const std::uint8_t> bytes, Durability durability) {
  NewFile file(path);
  file.write(bytes);
  file.done(durability);
}

void write_file(const std::string& path, std::string_view text) {
  write_file(path, bytes_of(text), Durability::renamed);
}

}  // namespace dem::io
