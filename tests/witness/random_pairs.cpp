#include "tests/witness/random_pairs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "shapes/polyhedron_build.h"

namespace witness {

namespace {

using nlohmann::json;
using shapes::Polyhedron;

// Draws that do not depend on the library's distributions.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double unit() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  double decades(double low, double high) { return low * std::pow(high / low, unit()); }
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(unit() * static_cast<double>(count)); }
  Vec3d direction() {
    for (;;) {
      const Vec3d v{between(-1, 1), between(-1, 1), between(-1, 1)};
      if (const double square = dot(v, v); square > 1e-4 && square < 1) return v * (1 / std::sqrt(square));
    }
  }
  Quatd orientation() {
    const Vec3d axis = direction();
    const double half = between(0, M_PI);
    return {std::cos(half), std::sin(half) * axis.x, std::sin(half) * axis.y, std::sin(half) * axis.z};
  }

 private:
  std::mt19937_64 engine_;
};

// Every shipped solid and 24 of the shipped grains, of circumradius 1.
const std::vector<Polyhedron>& grains() {
  static const std::vector<Polyhedron> all = [] {
    std::vector<std::filesystem::path> files;
    const std::string data = PROJECT_ROOT "/shapes/data/";
    for (const char* folder : {"solids", "ct_hull_coarse"}) {
      std::vector<std::filesystem::path> found;
      for (const auto& entry : std::filesystem::directory_iterator(data + folder))
        if (entry.path().extension() == ".off") found.push_back(entry.path());
      std::sort(found.begin(), found.end());
      const std::size_t every = std::max<std::size_t>(1, found.size() / 24);
      for (std::size_t i = 0; i < found.size(); i += every) files.push_back(found[i]);
    }
    std::vector<Polyhedron> out;
    for (const auto& file : files) {
      const Polyhedron p = shapes::polyhedron_from_file(file.string(), shapes::Frame::principal);
      out.push_back(shapes::scaled(p, 1 / p.circumradius));
    }
    return out;
  }();
  return all;
}

Body body(Family family, Draw& draw) {
  const double size = draw.decades(0.5, 2);
  const Vec3d axes{size * draw.between(0.25, 1), size * draw.between(0.25, 1), size};
  Body b;
  b.orientation = draw.orientation();
  switch (family) {
    case Family::sphere:
      b.size = {size, size, size};
      break;
    case Family::ellipsoid:
      b.type = Type::ellipsoid;
      b.size = axes;
      break;
    case Family::box:
      b.type = Type::box;
      b.size = axes;
      b.shape = std::make_shared<Polyhedron>(shapes::make_box(axes));
      break;
    case Family::grain:
      b.type = Type::polyhedron;
      b.shape = std::make_shared<Polyhedron>(shapes::scaled(grains()[draw.index(grains().size())], size));
      break;
  }
  return b;
}

Vec3d vector(const json& j) { return {j[0], j[1], j[2]}; }

Body body(const json& shape, const json& pose, Vec3d& position) {
  Body b;
  const json& q = pose["quaternion"];
  b.orientation = {q[0], q[1], q[2], q[3]};
  position = vector(pose["position"]);
  const std::string type = shape["type"];
  if (type == "sphere") {
    const double radius = shape["radius"];
    b.size = {radius, radius, radius};
    return b;
  }
  if (type == "ellipsoid") {
    b.type = Type::ellipsoid;
    b.size = vector(shape["semi_axes"]);
    return b;
  }
  if (type == "box") {
    b.type = Type::box;
    b.size = vector(shape["size"]);
    b.shape = std::make_shared<Polyhedron>(shapes::make_box(b.size));
    return b;
  }
  b.type = Type::polyhedron;
  if (type == "prism") {
    b.shape = std::make_shared<Polyhedron>(shapes::make_prism(shape["sides"], shape["circumradius"], shape["height"]));
  } else {
    std::vector<Vec3d> points;
    for (const json& v : shape["vertices"]) points.push_back(vector(v));
    b.shape = std::make_shared<Polyhedron>(shapes::polyhedron_from_points(points, shapes::Frame::as_given));
  }
  return b;
}

}  // namespace

std::vector<Pair> random_pairs(Family a, Family b, int count, unsigned seed) {
  Draw draw(seed);
  std::vector<Pair> pairs;
  for (int i = 0; i < count; ++i) {
    Pair pair;
    pair.name = "pair " + std::to_string(i);
    pair.a = body(a, draw);
    pair.b = body(b, draw);
    const double smaller = std::min(pair.a.inscribed_radius(), pair.b.inscribed_radius());
    const double wanted = smaller * (i % 2 == 0 ? draw.decades(1e-3, 5e-2) : -draw.decades(1e-3, 0.2));
    const Vec3d direction = draw.direction();
    const contact::Body placed_a = pair.a.placed(), placed_b = pair.b.placed();
    double near = 0, far = 2 * (pair.a.circumradius() + pair.b.circumradius());
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (near + far);
      (contact::query(placed_a, placed_b, middle * direction).gap < wanted ? near : far) = middle;
    }
    pair.offset = near * direction;
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::vector<Pair> case_file_pairs() {
  std::ifstream file(TEST_DATA_DIR "/cases.json");
  std::vector<Pair> pairs;
  const json all = json::parse(file);
  for (const json& c : all["cases"]) {
    if (c["dim"] != 3) continue;
    Pair pair;
    pair.name = c["id"];
    Vec3d at_a, at_b;
    pair.a = body(c["shape_a"], c["pose_a"], at_a);
    pair.b = body(c["shape_b"], c["pose_b"], at_b);
    pair.offset = at_b - at_a;
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace witness
