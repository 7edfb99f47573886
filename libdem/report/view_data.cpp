#include "libdem/report/view_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "libdem/analysis/body_colours.h"
#include "libdem/report/base64.h"
#include "libdem/report/view_shapes.h"

namespace dem::report {

namespace {

using analysis::Snapshot;

constexpr std::size_t most_in_all = 500000;  // bodies of all frames together

enum Quantity : std::size_t { speed, force, displacement, strain, vorticity, quantity_count };
struct Known {
  const char *name, *label;
};
constexpr std::array<Known, quantity_count> known{{{"speed", "speed (m/s)"},
                                                   {"force", "contact forces (N)"},
                                                   {"displacement", "displacement (m)"},
                                                   {"strain", "shear strain"},
                                                   {"vorticity", "vorticity (1/s)"}}};

// Sum of the magnitudes of the contact forces on each body, N.
std::vector<double> contact_load(const Snapshot& s) {
  std::vector<double> load(s.count(), 0.0);
  for (const analysis::SnapshotContact& c : s.contacts) {
    load[c.a] += norm(c.force);
    if (!c.wall) load[c.b] += norm(c.force);
  }
  return load;
}

// How far each body has come since its first frame here; along periodic axes by steps to the nearest image.
class Displacements {
 public:
  double of(std::size_t i, const Snapshot& s) {
    const auto [at, fresh] = bodies_.try_emplace(s.id[i], Body{s.position[i], {}});
    if (!fresh) {
      at->second.sum = at->second.sum + s.between(at->second.last, s.position[i]);
      at->second.last = s.position[i];
    }
    return norm(at->second.sum);
  }

 private:
  struct Body {
    Vec3d last, sum;
  };
  std::map<std::uint64_t, Body> bodies_;
};

// Bands of bodies, fixed at a reference frame.
class Bands {
 public:
  explicit Bands(const Snapshot& reference) : ids_(reference.id) {
    for (const char* word : {"layers", "layers_x", "layers_y"})
      if (reference.count() > 0 && (reference.dimension == 3 || std::string(word) != "layers_y"))
        list_.emplace_back(word, analysis::body_colours(reference, word, &reference));
    values_.resize(list_.size());
  }
  void add(std::uint64_t id) {  // the next body of the view
    const auto at = std::lower_bound(ids_.begin(), ids_.end(), id);
    const auto place = static_cast<std::size_t>(at - ids_.begin());
    for (std::size_t k = 0; k < list_.size(); ++k)  // 0: none
      values_[k].push_back(at == ids_.end() || *at != id
                               ? std::uint32_t{0}
                               : static_cast<std::uint32_t>(list_[k].second.values[place]) + 1);
  }
  Json json() const {
    Json out = Json::array();
    for (std::size_t k = 0; k < list_.size(); ++k)
      out.push_back({{"name", list_[k].first},
                     {"label", list_[k].second.label},
                     {"names", list_[k].second.names},
                     {"of", base64_of(values_[k])}});
    return out;
  }

 private:
  std::vector<std::uint64_t> ids_;
  std::vector<std::pair<std::string, analysis::BodyColours>> list_;
  std::vector<std::vector<std::uint32_t>> values_;
};

// One in `each`, spread evenly over ids: the fractional parts of multiples of the golden ratio.
bool in_sample(std::uint64_t id, std::uint64_t each) {
  return each <= 1 || id * 0x9E3779B97F4A7C15u < std::numeric_limits<std::uint64_t>::max() / each;
}

struct FrameValues {
  std::size_t frame = 0;
  std::vector<std::uint32_t> shown;  // places in the snapshot
  std::array<std::vector<double>, quantity_count> values;
};

// Upper end of the colours: without the highest 4 %, as pictures have it.
double top_of(std::vector<double> values) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !(v > 0); }), values.end());
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.96 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<std::uint16_t> packed(const std::vector<double>& values, double largest) {
  std::vector<std::uint16_t> out;
  out.reserve(values.size());
  for (const double v : values)
    out.push_back(static_cast<std::uint16_t>(largest > 0 ? std::lround(65535 * std::clamp(v / largest, 0.0, 1.0)) : 0));
  return out;
}

bool turns(const Snapshot& s, std::size_t i) {
  const Vec3d& r = s.size[i];
  return s.shape_of(i).drawn() != nullptr || s.shape_of(i).compound != nullptr || r.x != r.y || r.x != r.z;
}

class Packer {
 public:
  Packer(const io::Box& box, bool turned, Bands& bands) : box_(box), turned_(turned), bands_(bands) {}

  Json frame(const Snapshot& s, const FrameValues& f, const std::array<double, quantity_count>& largest,
             const std::array<bool, quantity_count>& has) {
    std::vector<std::uint32_t> bodies;
    std::vector<std::uint16_t> places;
    std::vector<std::int16_t> turns;
    for (const std::uint32_t i : f.shown) {
      bodies.push_back(body(s, i));
      for (int k = 0; k < 3; ++k) places.push_back(place(s.position[i][k], k));
      if (!turned_) continue;
      const Quatd& q = s.orientation[i];
      for (const double c : {q.w, q.x, q.y, q.z})
        turns.push_back(static_cast<std::int16_t>(std::lround(32767 * std::clamp(c, -1.0, 1.0))));
    }
    Json out{{"time", s.time},
             {"step", s.step},
             {"bodies", s.count()},
             {"shown", base64_of(bodies)},
             {"places", base64_of(places)},
             {"walls", ViewWalls::poses(s)}};
    if (turned_) out["turns"] = base64_of(turns);
    for (std::size_t q = 0; q < quantity_count; ++q)
      if (has[q]) out[known[q].name] = base64_of(packed(f.values[q], largest[q]));
    if (s.periodic[0] || s.periodic[1] || s.periodic[2]) {
      io::Box cell = box_;
      for (int k = 0; k < 3; ++k)
        if (s.periodic[static_cast<std::size_t>(k)]) {
          cell.lower[k] = s.lower[k];
          cell.upper[k] = s.lower[k] + s.length[k];
        }
      out["cell"] = {list_of(cell.lower), list_of(cell.upper)};
    }
    return out;
  }

  Json bodies() const {
    return {{"id", ids_},
            {"shape", base64_of(shapes_)},
            {"species", base64_of(species_)},
            {"size", base64_of(sizes_)},
            {"diameter", base64_of(diameters_)}};
  }

 private:
  // Place of a body in the list of all that are shown in any frame.
  std::uint32_t body(const Snapshot& s, std::size_t i) {
    const auto [at, fresh] = index_.try_emplace(s.id[i], static_cast<std::uint32_t>(ids_.size()));
    if (fresh) {
      ids_.push_back(s.id[i]);
      bands_.add(s.id[i]);
      shapes_.push_back(s.shape[i]);
      species_.push_back(s.species[i]);
      for (int k = 0; k < 3; ++k) sizes_.push_back(static_cast<float>(s.size[i][k]));
      diameters_.push_back(static_cast<float>(2 * s.radius[i]));
    }
    return at->second;
  }
  std::uint16_t place(double x, int k) const {
    const double width = box_.upper[k] - box_.lower[k];
    return static_cast<std::uint16_t>(width > 0 ? std::lround(65535 * std::clamp((x - box_.lower[k]) / width, 0.0, 1.0))
                                                : 0);
  }

  io::Box box_;
  bool turned_;
  Bands& bands_;
  std::map<std::uint64_t, std::uint32_t> index_;
  std::vector<std::uint64_t> ids_;
  std::vector<std::uint32_t> shapes_, species_;
  std::vector<float> sizes_, diameters_;
};

// Every k-th, and the last.
std::vector<std::size_t> thinned(const std::vector<Frame>& frames, std::size_t most_bodies,
                                 std::vector<std::string>& notes) {
  std::size_t sum = 0;
  for (const Frame& f : frames) sum += std::min(f.bodies, most_bodies);
  const std::size_t each = (sum + most_in_all - 1) / most_in_all;
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (each <= 1 || i % each == 0 || i + 1 == frames.size()) list.push_back(frames[i].frame);
  if (list.size() < frames.size())
    notes.push_back(fmt::format("the view has every {}th of the {} frames, and the last", each, frames.size()));
  return list;
}

Vec3d up_of(const Snapshot& s) {
  const double g = norm(s.gravity);
  if (g > 0) return s.gravity * (-1 / g);
  return s.dimension == 2 ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
}

}  // namespace

ViewData view_data(const analysis::Frames& frames, const Listing& listing, std::size_t most_bodies,
                   std::size_t reference_frame) {
  ViewData out;
  const Snapshot reference = frames.read(reference_frame);
  const std::vector<std::size_t> list = thinned(listing.frames, most_bodies, out.notes);
  // First pass: the box, and what colours show.
  std::vector<FrameValues> all;
  std::array<std::vector<double>, quantity_count> together;
  std::array<bool, quantity_count> has{true, true, list.size() > 1, list.size() > 1, true};
  Displacements displacements;
  io::Box box;
  bool turned = false;
  std::uint64_t each = 1;
  for (const std::size_t frame : list)
    for (const Frame& f : listing.frames)
      if (f.frame == frame) each = std::max<std::uint64_t>(each, (f.bodies + most_bodies - 1) / most_bodies);
  for (const std::size_t frame : list) {
    const Snapshot s = frames.read(frame);
    add_to_box(s, box);
    has[speed] = has[vorticity] = has[speed] && s.has_velocity;
    has[force] = has[force] && s.has_contacts && s.has_forces;
    const std::vector<double> load = contact_load(s);
    const auto local = [&](const char* word, bool wanted) {
      return wanted ? analysis::body_colours(s, word, &reference).values : std::vector<double>(s.count(), 0.0);
    };
    const std::vector<double> strains = local("strain", has[strain]), curls = local("vorticity", has[vorticity]);
    const auto or_zero = [](double v) { return std::isfinite(v) ? v : 0.0; };  // its neighbours do not span the space
    FrameValues f{frame, {}, {}};
    for (std::uint32_t i = 0; i < s.count(); ++i) {
      const double moved = displacements.of(i, s);
      if (!in_sample(s.id[i], each)) continue;
      f.shown.push_back(i);
      turned = turned || turns(s, i);
      f.values[speed].push_back(norm(s.velocity[i]));
      f.values[force].push_back(load[i]);
      f.values[displacement].push_back(moved);
      f.values[strain].push_back(or_zero(strains[i]));
      f.values[vorticity].push_back(or_zero(curls[i]));
    }
    for (std::size_t q = 0; q < quantity_count; ++q)
      together[q].insert(together[q].end(), f.values[q].begin(), f.values[q].end());
    all.push_back(std::move(f));
  }
  if (each > 1) out.notes.push_back(fmt::format("the view has one in {} of the bodies, spread over their ids", each));
  // Second pass: packed.
  std::array<double, quantity_count> largest{};
  Json scales = Json::object();
  for (std::size_t q = 0; q < quantity_count; ++q) {
    for (const double v : together[q]) largest[q] = std::max(largest[q], v);
    if (has[q])
      scales[known[q].name] = {
          {"label", known[q].label}, {"largest", largest[q]}, {"top", top_of(std::move(together[q]))}};
  }
  Bands bands(reference);
  Packer packer(box, turned, bands);
  ViewWalls walls(box);
  Json data, frame_list = Json::array();
  for (const FrameValues& f : all) {
    const Snapshot s = frames.read(f.frame);
    walls.add(s);
    frame_list.push_back(packer.frame(s, f, largest, has));
    out.bodies = s.count();
    if (&f != &all.back()) continue;
    Json shapes = Json::array(), meshes = Json::array();
    for (const ShapeEntry& shape : s.shapes) shapes.push_back(shape_json(shape, meshes));
    data = {{"dimension", s.dimension},    {"up", list_of(up_of(s))}, {"lower", list_of(box.lower)},
            {"upper", list_of(box.upper)}, {"shapes", shapes},        {"meshes", meshes},
            {"species", s.species_names}};
  }
  out.frames = all.size();
  data["bodies"] = packer.bodies();
  data["bands"] = bands.json();
  data["scales"] = scales;
  data["walls"] = walls.walls();
  data["frames"] = frame_list;
  out.json = data.dump();
  for (std::size_t at = 0; (at = out.json.find("</", at)) != std::string::npos; at += 3)
    out.json.replace(at, 2, "<\\/");
  return out;
}

}  // namespace dem::report
