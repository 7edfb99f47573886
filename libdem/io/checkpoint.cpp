// Checkpoint file, little-endian words: magic, format version, step, length, checksum of step and payload, then the
// payload.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "libdem/io/files.h"
#include "libdem/io/io.h"

namespace dem::io {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t magic = 0x3130706b434d4544u;  // "DEMCkp01"
constexpr std::uint64_t format = 8;
constexpr std::size_t kept = 2;
constexpr std::string_view prefix = "checkpoint-", suffix = ".bin";

using Header = std::array<std::uint64_t, 5>;  // magic, format, step, length, checksum

// Multiply and fold over 8-byte words: every bit of the input reaches every bit of the result.
std::uint64_t checksum(std::uint64_t seed, std::span<const std::uint8_t> bytes) {
  std::uint64_t h = seed ^ 0x9e3779b97f4a7c15u;
  const auto mix = [&h](std::uint64_t word) {
    h = (h ^ word) * 0xff51afd7ed558ccdu;
    h ^= h >> 32;
  };
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + i, 8);
    mix(word);
  }
  std::uint64_t rest = 0;
  if (i < bytes.size()) std::memcpy(&rest, bytes.data() + i, bytes.size() - i);
  mix(rest);
  mix(bytes.size());
  return h;
}

struct Entry {
  std::uint64_t step;
  fs::path path;
};

// Checkpoints of a folder, newest first.
std::vector<Entry> list(const std::string& folder) {
  std::vector<Entry> entries;
  std::error_code error;
  for (const auto& item : fs::directory_iterator(folder, error)) {
    const std::string name = item.path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(suffix)) continue;
    const char* end = name.data() + name.size() - suffix.size();
    std::uint64_t step = 0;
    const auto [stop, code] = std::from_chars(name.data() + prefix.size(), end, step);
    if (code == std::errc() && stop == end) entries.push_back({step, item.path()});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.step > b.step; });
  return entries;
}

std::optional<Checkpoint> read(const Entry& entry) {
  std::ifstream in(entry.path, std::ios::binary);
  Header header{};
  if (!in.read(reinterpret_cast<char*>(header.data()), sizeof header)) return {};
  std::error_code error;
  const auto size = fs::file_size(entry.path, error);
  if (error || header[0] != magic || header[1] != format || header[2] != entry.step) return {};
  if (size != sizeof header + header[3]) return {};
  Checkpoint found{entry.step, std::vector<std::uint8_t>(header[3])};
  if (!in.read(reinterpret_cast<char*>(found.state.data()), static_cast<std::streamsize>(header[3]))) return {};
  if (checksum(entry.step, found.state) != header[4]) return {};
  return found;
}

}  // namespace

void write_checkpoint(const std::string& folder, std::uint64_t step, const std::vector<std::uint8_t>& state) {
  const Header header{magic, format, step, state.size(), checksum(step, state)};
  write_file(fmt::format("{}/{}{:012}{}", folder, prefix, step, suffix), state, Durability::synced,
             {reinterpret_cast<const std::uint8_t*>(header.data()), sizeof header});

  // Later ones belong to a history that a resume has left behind (it starts from the newest intact file, so they are
  // damaged); of the others the newest two stay.
  std::size_t seen = 0;
  for (const Entry& entry : list(folder))
    if (entry.step > step || ++seen > kept) fs::remove(entry.path);
}

std::optional<Checkpoint> read_last_checkpoint(const std::string& folder) {
  for (const Entry& entry : list(folder))
    if (auto found = read(entry)) return found;
  return {};
}

}  // namespace dem::io
