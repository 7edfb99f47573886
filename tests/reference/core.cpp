#include "tests/reference/core.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "shapes/polygon.h"

namespace reference {
namespace {

template <class T>
shapes::Vec3<T> widened(const Vec3d& v) {
  return {T(v.x), T(v.y), T(v.z)};
}

template <class T>
shapes::Mat3<T> outer(const shapes::Vec3<T>& a, const T& s) {
  return {{s * a.x * a, s * a.y * a, s * a.z * a}};
}

template <class T>
void add_polyhedron(Core<T>& core, const shapes::Polyhedron& p) {
  for (const auto& v : p.vertices) core.corners.push_back(core.turn * (core.scale * widened<T>(v)));
  for (const auto& f : p.faces) {
    core.loops.emplace_back(p.face_vertices.begin() + f.first, p.face_vertices.begin() + f.first + f.count);
    core.normals.push_back(core.turn * normalized(widened<T>(f.normal)));
  }
  for (const auto& e : p.edges) core.edges.emplace_back(e.vertex[0], e.vertex[1]);
}

template <class T>
void add_polygon(Core<T>& core, const shapes::Polygon& p) {
  const auto n = static_cast<std::uint32_t>(p.vertices.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    core.corners.push_back(core.turn * (core.scale * widened<T>(p.vertices[i])));
    core.loops.push_back({i, (i + 1) % n});
    core.normals.push_back(core.turn * normalized(widened<T>(p.normals[i])));
    core.edges.emplace_back(i, (i + 1) % n);
  }
}

}  // namespace

template <class T>
Core<T>::Core(const Body& body, double unit) {
  const auto& q = body.orientation;
  turn = rotation_matrix(normalized(shapes::Quat<T>{T(q.w), T(q.x), T(q.y), T(q.z)}));
  planar = shapes::dimension_of(body.kind) == 2;
  const shapes::Vec3<T> size = T(unit) * widened<T>(body.size);
  scale = size.x;
  switch (body.kind) {
    case Kind::ellipsoid:
    case Kind::ellipse: {
      form = Form::round;
      axes = {size.x, size.y, planar ? T(0) : size.z};
      T least = std::min(size.x, size.y), most = std::max(size.x, size.y);
      if (!planar) least = std::min(least, size.z), most = std::max(most, size.z);
      least_radius = least * least / most;
      break;
    }
    case Kind::polyhedron:
      add_polyhedron(*this, *static_cast<const shapes::Polyhedron*>(body.geometry));
      break;
    case Kind::rounded_polyhedron:
      add_polyhedron(*this, *static_cast<const shapes::Polyhedron*>(body.geometry));
      ball = size.y;
      break;
    case Kind::polygon:
      add_polygon(*this, *static_cast<const shapes::Polygon*>(body.geometry));
      break;
    case Kind::potential_particle:
      form = Form::potential;
      potential = static_cast<const shapes::PotentialParticle*>(body.geometry);
      least_radius = scale * T(potential->least_curvature_radius);
      break;
    default:
      ball = size.x;
      corners.push_back({});
  }
  for (const auto& c : corners) rounded_corners.push_back(rounded(c));
}

template <class T>
shapes::Vec3<T> Core<T>::support(const shapes::Vec3<T>& n) const {
  if (form == Form::round) {
    const shapes::Vec3<T> m = scaled(axes, transposed_times(turn, n));
    return turn * scaled(axes, m * (T(1) / norm(m)));
  }
  if (form == Form::potential) {
    const shapes::Vec3<T> m = normalized(transposed_times(turn, n));
    const auto s = shapes::support_from_centre<T>(*potential, m);
    return scale * (turn * (s.from_centre + widened<T>(potential->centre)));
  }
  std::size_t best = corners.size();
  T height{};
  const auto higher = [&](std::size_t i) {
    const T h = dot(n, corners[i]);
    if (best == corners.size() || h > height) height = h, best = i;
  };
  if constexpr (std::is_same_v<T, double>) {
    for (std::size_t i = 0; i < corners.size(); ++i) higher(i);
  } else {
    const Vec3d m = rounded(n);
    double most = -HUGE_VAL, size = 0;
    for (const Vec3d& c : rounded_corners) most = std::max(most, dot(m, c)), size = std::max(size, max_abs(c));
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (dot(m, rounded_corners[i]) >= most - 1e-12 * size * max_abs(m)) higher(i);
  }
  return corners[best];
}

template <class T>
void Core<T>::at(const shapes::Vec3<T>& n, shapes::Vec3<T>& point, shapes::Mat3<T>& hessian) const {
  if (form == Form::round) {
    const shapes::Mat3<T> s = turn * shapes::Mat3<T>::diagonal(scaled(axes, axes)) * transposed(turn);
    const shapes::Vec3<T> sn = s * n;
    const T h = norm(scaled(axes, transposed_times(turn, n)));
    point = sn * (T(1) / h);
    hessian = outer(point, T(T(-1) / h));
    for (int i = 0; i < 3; ++i) hessian.row[i] += s.row[i] * (T(1) / h);
    return;
  }
  const shapes::Vec3<T> m = transposed_times(turn, n);
  const auto s = shapes::support_from_centre<T>(*potential, m);
  point = scale * (turn * (s.from_centre + widened<T>(potential->centre)));
  const shapes::Vec3<T> along = s.inverse_hessian * m;
  shapes::Mat3<T> k = outer(along, T(T(-1) / dot(m, along)));
  for (int i = 0; i < 3; ++i) k.row[i] = (s.half_slope * scale) * (k.row[i] + s.inverse_hessian.row[i]);
  hessian = turn * k * transposed(turn);
}

template struct Core<double>;
template struct Core<Real>;

}  // namespace reference
