#include "libdem/analysis/read_lammps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>

#include "libdem/scene/where.h"

namespace dem::analysis {
namespace {

constexpr std::string_view first_item = "ITEM: TIMESTEP", count_item = "ITEM: NUMBER OF ATOMS",
                           box_item = "ITEM: BOX BOUNDS", atoms_item = "ITEM: ATOMS", time_item = "ITEM: TIME";

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr const char* blank = " \t\r";
  for (std::size_t at = line.find_first_not_of(blank); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blank, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blank, end);
  }
  return words;
}

// Lines of the file with their numbers; every fault names file and line.
class Lines {
 public:
  Lines(const std::string& path, std::ifstream& file, std::size_t line) : path_(path), file_(file), number_(line - 1) {}

  bool next() {
    ++number_;
    return static_cast<bool>(std::getline(file_, text_));
  }
  std::string_view must(const char* what) {
    if (!next()) fault(fmt::format("the file is cut short: {} is missing", what));
    return text_;
  }
  std::string_view text() const { return text_; }
  [[noreturn]] void fault(const std::string& problem) const {
    input_error({path_, static_cast<int>(number_), 1}, problem);
  }
  std::string_view must_word(const char* what) {
    const auto words = words_of(must(what));
    if (words.empty()) fault(fmt::format("{} is missing", what));
    return words[0];
  }
  template <class T>
  T number(std::string_view word) const {
    T value{};
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !(value - value == 0))
      fault(fmt::format("'{}' is not a number", word));
    return value;
  }

 private:
  const std::string& path_;
  std::ifstream& file_;
  std::size_t number_;
  std::string text_;
};

class Columns {
 public:
  explicit Columns(const std::vector<std::string_view>& names) : names_(names.begin(), names.end()) {}
  std::optional<std::size_t> find(std::string_view name) const {
    const auto at = std::find(names_.begin(), names_.end(), name);
    if (at == names_.end()) return {};
    return static_cast<std::size_t>(at - names_.begin());
  }
  using Three = std::optional<std::array<std::size_t, 3>>;
  using Four = std::optional<std::array<std::size_t, 4>>;
  template <std::size_t N>
  std::optional<std::array<std::size_t, N>> all(const std::array<const char*, N>& names) const {
    std::array<std::size_t, N> places{};
    for (std::size_t k = 0; k < N; ++k) {
      const auto at = find(names[k]);
      if (!at) return {};
      places[k] = *at;
    }
    return places;
  }
  std::size_t count() const { return names_.size(); }

 private:
  std::vector<std::string> names_;
};

// What the columns of a frame mean.
struct Meaning {
  std::array<std::size_t, 3> place{};
  Columns::Three velocity, spin, shape;
  Columns::Four turn;
  std::optional<std::size_t> id, type, radius, diameter, mass;
  std::vector<std::size_t> blockiness;
  bool scaled = false;
  double shape_factor = 0.5;  // from shape columns to semi-axes
};

Meaning meaning_of(const Columns& c, const Lines& at) {
  Meaning m;
  const std::array<std::array<const char*, 3>, 4> places{
      {{"x", "y", "z"}, {"xu", "yu", "zu"}, {"xs", "ys", "zs"}, {"xsu", "ysu", "zsu"}}};
  bool found = false;
  for (std::size_t k = 0; k < places.size() && !found; ++k) {
    const Columns::Three columns = c.all<3>(places[k]);
    found = columns.has_value();
    m.place = columns.value_or(m.place);
    m.scaled = k >= 2;
  }
  if (!found) at.fault("no places of bodies: allowed x y z, xu yu zu, xs ys zs, or xsu ysu zsu");
  m.velocity = c.all<3>({"vx", "vy", "vz"});
  m.spin = c.all<3>({"omegax", "omegay", "omegaz"});
  m.shape = c.all<3>({"shapex", "shapey", "shapez"});
  if (!m.shape) m.shape = c.all<3>({"c_shape[1]", "c_shape[2]", "c_shape[3]"});
  m.turn = c.all<4>({"quatw", "quati", "quatj", "quatk"});
  if (!m.turn) m.turn = c.all<4>({"c_q[1]", "c_q[2]", "c_q[3]", "c_q[4]"});
  if (!m.turn) {
    m.turn = c.all<4>({"quat1", "quat2", "quat3", "quat4"});
    if (m.turn) m.shape_factor = 1;
  }
  m.id = c.find("id");
  m.type = c.find("type");
  m.radius = c.find("radius");
  m.diameter = c.find("diameter");
  m.mass = c.find("mass");
  for (const char* name : {"blockiness1", "blockiness2", "block1", "block2"})
    if (const auto k = c.find(name)) m.blockiness.push_back(*k);
  if (!m.radius && !m.diameter && !m.shape)
    at.fault("no sizes of bodies: allowed radius, diameter, or shapex shapey shapez with a quaternion");
  if (m.shape && !m.turn && !m.radius && !m.diameter)
    at.fault("ellipsoids without orientation: allowed quatw quati quatj quatk, or quat1 … quat4");
  return m;
}

struct Box {
  Vec3d lower{}, upper{};
  std::array<bool, 3> periodic{};
  bool flags = false;  // whether the file says what the boundaries are
};

Box read_box(Lines& lines, std::string_view item) {
  Box box;
  const auto words = words_of(item.substr(box_item.size()));
  for (const std::string_view w : words) {
    if (w == "abc" || w == "origin") lines.fault("a general tilted box: allowed are boxes along the axes");
  }
  if (words.size() >= 3) {
    box.flags = true;
    for (std::size_t k = 0; k < 3; ++k) box.periodic[k] = words[words.size() - 3 + k].starts_with('p');
  }
  for (int k = 0; k < 3; ++k) {
    const auto bounds = words_of(lines.must("a line of the box"));
    if (bounds.size() < 2) lines.fault("a line of the box has two numbers");
    box.lower[k] = lines.number<double>(bounds[0]);
    box.upper[k] = lines.number<double>(bounds[1]);
    if (bounds.size() > 2 && lines.number<double>(bounds[2]) != 0)
      lines.fault("a tilted box: allowed are boxes along the axes");
    if (!(box.upper[k] > box.lower[k])) lines.fault("the box is empty");
  }
  return box;
}

ForeignBody read_body(const Meaning& m, const Box& box, const std::vector<std::string_view>& words, const Lines& lines,
                      std::size_t row) {
  const auto value = [&](std::size_t column) { return lines.number<double>(words[column]); };
  const auto vector = [&](const std::array<std::size_t, 3>& c) { return Vec3d{value(c[0]), value(c[1]), value(c[2])}; };
  ForeignBody b;
  b.id = m.id ? lines.number<std::uint64_t>(words[*m.id]) : row;
  b.species = m.type ? "type " + std::string(words[*m.type]) : "bodies";
  b.position = vector(m.place);
  if (m.scaled) b.position = box.lower + scaled(b.position, box.upper - box.lower);
  if (m.velocity) b.velocity = vector(*m.velocity);
  if (m.spin) b.spin = vector(*m.spin);
  if (m.mass) b.mass = value(*m.mass);
  if (m.radius) {
    const double r = value(*m.radius);
    b.semi_axes = {r, r, r};
  } else if (m.diameter) {
    const double r = 0.5 * value(*m.diameter);
    b.semi_axes = {r, r, r};
  }
  if (m.shape && m.turn) {
    const Vec3d a = vector(*m.shape) * m.shape_factor;
    const Quatd q{value((*m.turn)[0]), value((*m.turn)[1]), value((*m.turn)[2]), value((*m.turn)[3])};
    const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (!(a == Vec3d{})) {  // zero: no ellipsoid, where both kinds are in a file
      b.semi_axes = a;
      if (!(square > 0)) lines.fault("the quaternion is zero");
      b.orientation = shapes::normalized(q);
    }
    for (const std::size_t k : m.blockiness)
      if (!(a == Vec3d{}) && value(k) != 2)
        lines.fault("a superquadric of blockiness other than 2: allowed ellipsoids");
  }
  for (int k = 0; k < 3; ++k)
    if (!(b.semi_axes[k] > 0)) lines.fault(fmt::format("a size of {}: allowed > 0", b.semi_axes[k]));
  return b;
}

}  // namespace

bool is_lammps_dump(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line))
    if (!words_of(line).empty()) return line.starts_with("ITEM: ");
  return false;
}

LammpsDump::LammpsDump(std::string path, const ForeignOptions& options) : path_(std::move(path)), options_(options) {
  std::ifstream file(path_);
  if (!file) input_error({path_, 0, 0}, "cannot open the file");
  std::string line;
  long long offset = 0;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    if (line.starts_with(first_item)) frames_.push_back({offset, number});
    offset += static_cast<long long>(line.size()) + 1;
  }
  if (frames_.empty()) input_error({path_, 1, 1}, "no frame: a dump has lines ITEM: TIMESTEP");
}

Snapshot LammpsDump::read(std::size_t frame) const {
  const Frame& start = frames_.at(frame);
  std::ifstream file(path_);
  file.seekg(start.offset);
  Lines lines(path_, file, start.line);
  Snapshot s;
  Box box;
  std::optional<std::size_t> count;
  bool timed = options_.time_step > 0;
  lines.must("ITEM: TIMESTEP");
  s.step = lines.number<std::uint64_t>(lines.must_word("the step"));
  s.time = static_cast<double>(s.step) * (timed ? options_.time_step : 1);
  while (true) {
    const std::string item(lines.must("ITEM: ATOMS"));
    if (item.starts_with(count_item)) {
      count = lines.number<std::size_t>(lines.must_word("the number of bodies"));
    } else if (item.starts_with(box_item)) {
      box = read_box(lines, item);
    } else if (item.starts_with(time_item)) {
      s.time = lines.number<double>(lines.must_word("the time"));
      timed = true;
    } else if (item.starts_with(atoms_item)) {
      if (!count) lines.fault("ITEM: NUMBER OF ATOMS is missing before the bodies");
      const Columns columns(words_of(std::string_view(item).substr(atoms_item.size())));
      const Meaning meaning = meaning_of(columns, lines);
      ForeignBodies bodies;
      for (std::size_t i = 0; i < *count; ++i) {
        const auto words = words_of(lines.must("a body"));
        if (words.size() != columns.count())
          lines.fault(words.empty() || words[0] == "ITEM:"
                          ? fmt::format("the frame is cut short: {} bodies of {}", i, *count)
                          : fmt::format("{} values, but {} columns", words.size(), columns.count()));
        bodies.add(read_body(meaning, box, words, lines, i + 1));
      }
      s.periodic = box.periodic;
      for (int k = 0; k < 3; ++k)
        if (s.periodic[static_cast<std::size_t>(k)]) {
          s.lower[k] = box.lower[k];
          s.length[k] = box.upper[k] - box.lower[k];
        }
      s.has_velocity = meaning.velocity.has_value();
      if (!s.has_velocity) s.notes.emplace_back("no velocities in the source (vx vy vz)");
      if (!meaning.spin) s.notes.emplace_back("no spins in the source (omegax omegay omegaz): taken as zero");
      if (!meaning.id) s.notes.emplace_back("no ids in the source: bodies are numbered as they stand");
      if (!box.flags) s.notes.emplace_back("the source does not say which boundaries are periodic: taken as none");
      if (!timed) s.notes.emplace_back("times are the numbers of steps: no time step was given");
      bodies.finish(path_, options_, s);
      return s;
    } else if (item.starts_with("ITEM: ")) {
      lines.must("what follows an item");  // UNITS and others
    } else {
      lines.fault(fmt::format("allowed a line ITEM: …, found '{}'", item.substr(0, 40)));
    }
  }
}

}  // namespace dem::analysis
