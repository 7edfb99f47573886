// Whole files: read at once; written aside, then renamed, so that they are either whole or not there.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace dem::io {

// How far a file must have come when the call returns.
enum class Durability {
  renamed,  // whole for every reader, though a power cut may lose it
  synced,   // also on the disk, and so is its name
};

// All bytes of a file; empty when it cannot be read.
std::string read_file(const std::string& path);

// A file that is written piece by piece and takes the place of `path` when it is done; until then it is not there, and
// without done() it never is. RunError with the path and the system's reason where something fails.
class NewFile {
 public:
  explicit NewFile(std::string path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();
  void write(std::span<const std::uint8_t> bytes);
  void write(std::string_view text);
  void write_over(std::uint64_t place, std::span<const std::uint8_t> bytes);  // of bytes that were written
  void done(Durability durability);

 private:
  std::string path_;
  std::unique_ptr<class Descriptor> file_;
};

// Replaces `path` by the bytes.
void write_file(const std::string& path, std::span<const std::uint8_t> bytes, Durability durability);
void write_file(const std::string& path, std::string_view text);

}  // namespace dem::io
