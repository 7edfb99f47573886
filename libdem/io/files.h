// Whole files: read at once; written aside, then renamed, so that they are either whole or not there.
#pragma once

#include <cstdint>
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

// Replaces `path` by the bytes, those of `head` first; RunError with the path and the system's reason when that fails.
void write_file(const std::string& path, std::span<const std::uint8_t> bytes, Durability durability,
                std::span<const std::uint8_t> head = {});
void write_file(const std::string& path, std::string_view text);

}  // namespace dem::io
