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

// Multiply and fold over 8-byte words: every bit of the input reaches every bit of the result. The bytes may come in
// pieces of any size.
class Checksum {
 public:
  explicit Checksum(std::uint64_t seed) : h_(seed ^ 0x9e3779b97f4a7c15u) {}
  void add(std::span<const std::uint8_t> bytes) {
    size_ += bytes.size();
    for (; held_ > 0 && !bytes.empty(); bytes = bytes.subspan(1)) hold(bytes.front());
    for (; bytes.size() >= 8; bytes = bytes.subspan(8)) mix_word(bytes.data());
    for (const std::uint8_t byte : bytes) hold(byte);
  }
  std::uint64_t value() {
    std::uint64_t rest = 0;
    std::memcpy(&rest, word_.data(), held_);
    mix(rest);
    mix(size_);
    return h_;
  }
  std::uint64_t size() const { return size_; }

 private:
  void hold(std::uint8_t byte) {
    word_[held_++] = byte;
    if (held_ < word_.size()) return;
    mix_word(word_.data());
    held_ = 0;
  }
  void mix_word(const std::uint8_t* from) {
    std::uint64_t word;
    std::memcpy(&word, from, 8);
    mix(word);
  }
  void mix(std::uint64_t word) {
    h_ = (h_ ^ word) * 0xff51afd7ed558ccdu;
    h_ ^= h_ >> 32;
  }
  std::uint64_t h_, size_ = 0;
  std::array<std::uint8_t, 8> word_{};  // that is not whole yet
  std::size_t held_ = 0;
};

std::span<const std::uint8_t> bytes_of(const Header& header) {
  return {reinterpret_cast<const std::uint8_t*>(header.data()), sizeof header};
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
  Checksum sum(entry.step);
  sum.add(found.state);
  if (sum.value() != header[4]) return {};
  return found;
}

}  // namespace

void write_checkpoint(const std::string& folder, std::uint64_t step, const Pieces& state) {
  NewFile file(fmt::format("{}/{}{:012}{}", folder, prefix, step, suffix));
  file.write(bytes_of(Header{}));
  Checksum sum(step);
  state([&](std::span<const std::uint8_t> piece) {
    sum.add(piece);
    file.write(piece);
  });
  file.write_over(0, bytes_of(Header{magic, format, step, sum.size(), sum.value()}));
  file.done(Durability::synced);

  // Later ones belong to a history that a resume has left behind (it starts from the newest intact file, so they are
  // damaged); of the others the newest two stay.
  std::size_t seen = 0;
  for (const Entry& entry : list(folder))
    if (entry.step > step || ++seen > kept) fs::remove(entry.path);
}

void write_checkpoint(const std::string& folder, const World& world) {
  write_checkpoint(folder, world.step, [&](const Sink& sink) { save_state(world, sink); });
}

std::optional<Checkpoint> read_last_checkpoint(const std::string& folder) {
  for (const Entry& entry : list(folder))
    if (auto found = read(entry)) return found;
  return {};
}

}  // namespace dem::io
