#include "libdem/cli/cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "libdem/scene/nearest.h"
#include "libdem/scene/scene.h"
#include "shapes/math/trig.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"

namespace dem::cli {

namespace {

using Json = nlohmann::json;

const std::vector<std::string> bodies_3d{"sphere", "ellipsoid",          "box",  "polyhedron",
                                         "prism",  "rounded_polyhedron", "plane"};
const std::vector<std::string> bodies_2d{"disc", "ellipse", "polygon", "simple_polygon", "regular_polygon", "line"};

// A JSON object with the words that lead to it, for messages.
struct Place {
  const Json& json;
  std::string words;

  [[noreturn]] void refuse(const std::string& key, const std::string& problem) const {
    throw InputError(fmt::format("{}{}{}: {}", words, key.empty() ? "" : ".", key, problem));
  }
  Place inner(const std::string& key) const {
    if (!json.is_object() || !json.contains(key)) refuse(key, "is missing");
    return {json[key], words + "." + key};
  }
  std::string text(const std::string& key) const {
    const Place p = inner(key);
    if (!p.json.is_string()) refuse(key, "needs text");
    return p.json.get<std::string>();
  }
  double number() const {
    if (!json.is_number()) refuse("", "needs a number");
    const double v = json.get<double>();
    if (!std::isfinite(v)) refuse("", "must be finite");
    return v;
  }
  double positive(const std::string& key) const {
    const double v = inner(key).number();
    if (!(v > 0)) refuse(key, fmt::format("{}: allowed > 0", v));
    return v;
  }
  Vec3d vector() const {
    if (!json.is_array() || json.size() != 3) refuse("", "needs 3 numbers");
    Vec3d v;
    for (int i = 0; i < 3; ++i) v[i] = Place{json[static_cast<std::size_t>(i)], words}.number();
    return v;
  }
  // Two numbers; z is 0.
  Vec3d plane_vector() const {
    if (!json.is_array() || json.size() != 2) refuse("", "needs 2 numbers");
    return {Place{json[0], words}.number(), Place{json[1], words}.number(), 0};
  }
  int sides() const {
    const double n = positive("sides");
    if (n != std::floor(n) || n < 3 || n > 1000) refuse("sides", "allowed 3 <= sides <= 1000");
    return static_cast<int>(n);
  }
  Vec3d positive_vector(const std::string& key) const {
    const Vec3d v = inner(key).vector();
    if (!(v.x > 0 && v.y > 0 && v.z > 0)) refuse(key, "allowed > 0");
    return v;
  }
};

struct Body {  // a placed body with what it points to
  contact::Body body;
  std::shared_ptr<const void> geometry;
  Vec3d position{};
};

shapes::Polyhedron make_polyhedron(const Place& shape, const std::string& type) {
  if (type == "box") return shapes::make_box(shape.positive_vector("size"));
  if (type == "prism") {
    const int sides = shape.sides();
    return shapes::make_prism(sides, shape.positive("circumradius"), shape.positive("height"));
  }
  const Place vertices = shape.inner("vertices");
  std::vector<Vec3d> points;
  for (const Json& v : vertices.json) points.push_back(Place{v, vertices.words}.vector());
  return shapes::polyhedron_from_points(points, shapes::Frame::as_given);
}

shapes::Polygon make_polygon(const Place& shape, const std::string& type) {
  if (type == "regular_polygon") {
    const int sides = shape.sides();
    return shapes::make_regular_polygon(sides, shape.positive("circumradius"));
  }
  const Place vertices = shape.inner("vertices");
  std::vector<Vec3d> points;
  for (const Json& v : vertices.json) points.push_back(Place{v, vertices.words}.plane_vector());
  return type == "polygon" ? shapes::polygon_hull(points) : shapes::polygon_from_outline(points);
}

Body make_plane_body(const Place& shape, const Place& pose) {
  Body out;
  out.position = pose.inner("position").plane_vector();
  const double angle = pose.inner("angle").number();
  if (std::abs(angle) > 1e6) pose.refuse("angle", "allowed |angle| <= 1e6 rad");
  const shapes::SineCosine t = shapes::sine_cosine(angle);
  out.body.rotation = {{{t.cosine, -t.sine, 0}, {t.sine, t.cosine, 0}, {0, 0, 1}}};
  const std::string type = shape.text("type");
  if (type == "disc") {
    out.body.kind = shapes::Kind::disc;
    out.body.size = {shape.positive("radius"), 0, 0};
  } else if (type == "ellipse") {
    out.body.kind = shapes::Kind::ellipse;
    out.body.size = shape.inner("semi_axes").plane_vector();
    if (!(out.body.size.x > 0 && out.body.size.y > 0)) shape.refuse("semi_axes", "allowed > 0");
  } else if (type == "line") {  // solid below its y axis
    out.body.kind = shapes::Kind::line;
  } else {
    try {
      auto polygon = std::make_shared<const shapes::Polygon>(make_polygon(shape, type));
      out.body.geometry = polygon.get();
      out.geometry = std::move(polygon);
    } catch (const shapes::Error& error) {
      shape.refuse("", error.what());
    }
    out.body.kind = shapes::Kind::polygon;
    out.body.size = {1, 1, 1};
  }
  return out;
}

Body make_body(const Place& shape, const Place& pose) {
  Body out;
  out.position = pose.inner("position").vector();
  const Place q = pose.inner("quaternion");
  if (!q.json.is_array() || q.json.size() != 4) q.refuse("", "needs 4 numbers w, x, y, z");
  double c[4];
  for (std::size_t i = 0; i < 4; ++i) c[i] = Place{q.json[i], q.words}.number();
  const double square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3];
  if (std::abs(square - 1) > 1e-3)
    q.refuse("", fmt::format("allowed w² + x² + y² + z² = 1 within 0.001, found {}", square));
  Quatd orientation = shapes::normalized(Quatd{c[0], c[1], c[2], c[3]});

  const std::string type = shape.text("type");
  if (type == "sphere") {
    out.body.kind = shapes::Kind::sphere;
    out.body.size = {shape.positive("radius"), 0, 0};
  } else if (type == "ellipsoid") {
    out.body.kind = shapes::Kind::ellipsoid;
    out.body.size = shape.positive_vector("semi_axes");
  } else if (type == "plane") {  // solid below its z axis
    out.body.kind = shapes::Kind::plane;
  } else {
    const double rounding = type == "rounded_polyhedron" ? shape.positive("rounding") : 0;
    std::shared_ptr<const shapes::Polyhedron> solid;
    try {
      solid = std::make_shared<const shapes::Polyhedron>(make_polyhedron(shape, type));
    } catch (const shapes::Error& error) {
      shape.refuse("", error.what());
    }
    out.body.kind = rounding > 0 ? shapes::Kind::rounded_polyhedron : shapes::Kind::polyhedron;
    out.body.geometry = solid.get();
    out.geometry = solid;
    out.body.size = {1, rounding, 0};
    // A builder may turn and shift a body into its principal frame: the pose follows.
    out.position += shapes::rotate(orientation, solid->frame.position);
    orientation = orientation * solid->frame.orientation;
  }
  out.body.rotation = shapes::rotation_matrix(orientation);
  return out;
}

Expected read_expected(const Place& e, int dim) {
  Expected out{e.text("state"), e.inner("signed_gap").number(), e.inner("abs_tol").number(), {}, 0};
  const auto normals = e.json.find("normals");
  if (normals == e.json.end() || normals->is_null()) return out;
  for (const Json& n : *normals) {
    const Place normal{n, e.words + ".normals"};
    out.normals.push_back(dim == 2 ? normal.plane_vector() : normal.vector());
  }
  out.normal_tol = e.inner("normal_tol").number();
  return out;
}

Case read_case(const Json& json, const std::string& path, std::size_t index) {
  const std::string id = Place{json, fmt::format("{}: case {}", path, index)}.text("id");
  const Place place{json, fmt::format("{}: case {} \"{}\"", path, index, id)};
  Case out;
  out.id = id;
  const Place shape_a = place.inner("shape_a"), shape_b = place.inner("shape_b");
  for (const Place* shape : {&shape_a, &shape_b}) {
    const std::string type = shape->text("type");
    const auto is = [&](const auto& list) { return std::find(list.begin(), list.end(), type) != list.end(); };
    std::vector<std::string> all = bodies_3d;
    all.insert(all.end(), bodies_2d.begin(), bodies_2d.end());
    if (!is(all)) shape->refuse("type", fmt::format("\"{}\" is not a kind of body{}", type, suggestion(type, all)));
    const int dim = is(bodies_2d) ? 2 : 3;
    if (shape == &shape_b && dim != out.dim) shape->refuse("type", "a body of the plane against one of space");
    out.dim = dim;
  }
  const auto make = out.dim == 2 ? make_plane_body : make_body;
  Body a = make(shape_a, place.inner("pose_a")), b = make(shape_b, place.inner("pose_b"));
  out.a = a.body;
  out.b = b.body;
  out.geometry_a = a.geometry;
  out.geometry_b = b.geometry;
  out.origin = a.position;
  out.offset = b.position - a.position;
  out.size = std::hypot(out.offset.x, out.offset.y, out.offset.z) + circumradius(a.body) + circumradius(b.body);
  if (json.contains("expect")) out.expected = read_expected(place.inner("expect"), out.dim);
  return out;
}

Json parse(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  if (!file.is_open() || file.bad()) throw InputError(path + ": the case file cannot be read");
  try {
    return Json::parse(bytes);
  } catch (const Json::parse_error& error) {
    const std::size_t at = std::min(error.byte > 0 ? error.byte - 1 : 0, bytes.size());
    const auto begin = bytes.begin(), end = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto line = 1 + std::count(begin, end, '\n');
    const std::size_t newline = at > 0 ? bytes.rfind('\n', at - 1) : std::string::npos;
    const std::size_t column = newline == std::string::npos ? at + 1 : at - newline;
    throw InputError(fmt::format("{}:{}:{}: JSON syntax", path, line, column));
  } catch (const Json::exception& error) {  // a number that no double holds
    throw InputError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace

std::vector<Case> read_cases(const std::string& path) {
  const Json json = parse(path);
  const Place list = json.is_array() ? Place{json, path} : Place{json, path + ":"}.inner("cases");
  if (!list.json.is_array()) list.refuse("", "needs a list of cases");
  std::vector<Case> cases;
  for (const Json& c : list.json) cases.push_back(read_case(c, path, cases.size()));
  return cases;
}

}  // namespace dem::cli
