#include "shapes/mesh_generate.h"

#include <cmath>
#include <numbers>
#include <string>

#include "shapes/convex.h"
#include "shapes/math/trig.h"
#include "shapes/mesh_build.h"

namespace shapes {
namespace {

// Triangles as they are collected: vertices may repeat, mesh_from_triangles welds them.
struct Soup {
  std::vector<Vec3d> vertices;
  std::vector<std::uint32_t> triangles;

  std::uint32_t add(const Vec3d& v) {
    vertices.push_back(v);
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles.insert(triangles.end(), {a, b, c}); }
  void quad(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    const std::uint32_t i = add(a), j = add(b), k = add(c), l = add(d);
    triangle(i, j, k);
    triangle(i, k, l);
  }
  // A disc: fan from the first vertex of a convex ring.
  void fan(const std::vector<Vec3d>& ring) {
    const std::uint32_t first = add(ring[0]);
    std::uint32_t previous = add(ring[1]);
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const std::uint32_t next = add(ring[i]);
      triangle(first, previous, next);
      previous = next;
    }
  }
  Mesh mesh() const { return mesh_from_triangles(vertices, triangles); }
};

void need(bool fine, const std::string& problem) {
  if (!fine) throw Error("mesh: " + problem);
}
void need_segments(std::uint32_t segments) {
  need(segments >= 3 && segments <= 10000, std::to_string(segments) + " segments; allowed: 3 <= segments <= 10000");
}

// Cosine and sine of the directions of a ring's vertices.
std::vector<SineCosine> ring_directions(std::uint32_t segments) {
  std::vector<SineCosine> out;
  for (std::uint32_t i = 0; i < segments; ++i) out.push_back(sine_cosine(2 * std::numbers::pi * i / segments));
  return out;
}

// Quads between two rings of the same number of vertices; a ring shrunk to a point gives triangles.
void add_side(Soup& soup, const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t j = (i + 1) % a.size();
    if (a[i] == a[j])
      soup.triangle(soup.add(a[i]), soup.add(b[j]), soup.add(b[i]));
    else if (b[i] == b[j])
      soup.triangle(soup.add(a[i]), soup.add(a[j]), soup.add(b[i]));
    else
      soup.quad(a[i], a[j], b[j], b[i]);
  }
}

}  // namespace

Mesh make_panel(const Vec3d& corner, const Vec3d& side_1, const Vec3d& side_2) {
  Soup soup;
  soup.quad(corner, corner + side_1, corner + side_1 + side_2, corner + side_2);
  return soup.mesh();
}

Mesh make_box_shell(const Vec3d& lower, const Vec3d& upper, const BoxFaces& faces) {
  Soup soup;
  const auto corner = [&](int axis, double level, int u, int v) {
    Vec3d x;
    x[axis] = level;
    x[(axis + 1) % 3] = u ? upper[(axis + 1) % 3] : lower[(axis + 1) % 3];
    x[(axis + 2) % 3] = v ? upper[(axis + 2) % 3] : lower[(axis + 2) % 3];
    return x;
  };
  for (int axis = 0; axis < 3; ++axis) {
    need(lower[axis] < upper[axis], "box with lower >= upper; allowed: lower < upper in x, y and z");
    if (faces.low[axis]) {
      const double at = lower[axis];
      soup.quad(corner(axis, at, 0, 0), corner(axis, at, 1, 0), corner(axis, at, 1, 1), corner(axis, at, 0, 1));
    }
    if (faces.high[axis]) {
      const double at = upper[axis];
      soup.quad(corner(axis, at, 0, 0), corner(axis, at, 1, 0), corner(axis, at, 1, 1), corner(axis, at, 0, 1));
    }
  }
  need(!soup.triangles.empty(), "box without faces; allowed: at least one");
  return soup.mesh();
}

Mesh make_frustum(const Vec3d& base, const Vec3d& top, double base_radius, double top_radius, std::uint32_t segments,
                  bool base_closed, bool top_closed) {
  need_segments(segments);
  const Vec3d along = top - base;
  need(max_abs(along) > 0, "base and top coincide; allowed: an axis with a length");
  need(base_radius >= 0 && top_radius >= 0 && base_radius + top_radius > 0,
       "radii " + std::to_string(base_radius) + ", " + std::to_string(top_radius) +
           "; allowed: >= 0, at least one of them > 0");
  Vec3d u, v;
  tangent_frame(normalized(along * (1 / max_abs(along))), u, v);
  const auto ring = [&](const Vec3d& centre, double radius) {
    std::vector<Vec3d> out;
    for (const SineCosine& d : ring_directions(segments))
      out.push_back(radius > 0 ? centre + (u * d.cosine + v * d.sine) * radius : centre);
    return out;
  };
  Soup soup;
  const std::vector<Vec3d> low = ring(base, base_radius), high = ring(top, top_radius);
  add_side(soup, low, high);
  if (base_closed && base_radius > 0) soup.fan(low);
  if (top_closed && top_radius > 0) soup.fan(high);
  return soup.mesh();
}

Mesh make_die(const Vec3d& lower, const Vec3d& upper, double flange, bool bottom_closed) {
  need(flange > 0, "flange " + std::to_string(flange) + "; allowed: > 0");
  BoxFaces faces;
  faces.high[2] = false;
  faces.low[2] = bottom_closed;
  const Mesh cavity = make_box_shell(lower, upper, faces);
  Soup soup{cavity.vertices, cavity.triangles};
  const double z = upper.z;
  const Vec3d inner[4] = {{lower.x, lower.y, z}, {upper.x, lower.y, z}, {upper.x, upper.y, z}, {lower.x, upper.y, z}};
  const Vec3d outer[4] = {{lower.x - flange, lower.y - flange, z},
                          {upper.x + flange, lower.y - flange, z},
                          {upper.x + flange, upper.y + flange, z},
                          {lower.x - flange, upper.y + flange, z}};
  for (int i = 0; i < 4; ++i) soup.quad(outer[i], outer[(i + 1) % 4], inner[(i + 1) % 4], inner[i]);
  return soup.mesh();
}

Mesh make_v_shell(const Vec3d& centre, double angle, double radius, double length, std::uint32_t segments,
                  bool ends_closed) {
  need_segments(segments);
  need(angle > 0 && angle < std::numbers::pi,
       "V with an angle of " + std::to_string(angle) + " rad; allowed: 0 < angle < pi");
  need(radius > 0, "radius " + std::to_string(radius) + "; allowed: > 0");
  const SineCosine half = sine_cosine(0.5 * angle);
  const double least = radius * half.cosine / half.sine;
  need(length > least, "arms of length " + std::to_string(length) +
                           "; allowed: length > radius / tan(angle / 2) = " + std::to_string(least));
  // The arm on the side of +x; the other is its mirror image, with the joint in common.
  const Vec3d axis{half.sine, 0, half.cosine}, across{half.cosine, 0, -half.sine};
  std::vector<Vec3d> joint, end;
  for (const SineCosine& d : ring_directions(segments)) {
    const Vec3d rim = Vec3d{0, radius * d.cosine, 0} + across * (radius * d.sine);
    Vec3d meeting = rim - axis * (rim.x / axis.x);
    meeting.x = 0;
    joint.push_back(meeting);
    end.push_back(rim + axis * length);
  }
  Soup soup;
  for (const double side : {1.0, -1.0}) {
    const auto placed = [&](std::vector<Vec3d> ring) {
      for (Vec3d& v : ring) v = centre + Vec3d{side * v.x, v.y, v.z};
      return ring;
    };
    const std::vector<Vec3d> rim = placed(end);
    add_side(soup, placed(joint), rim);
    if (ends_closed) soup.fan(rim);
  }
  return soup.mesh();
}

double facet_area(const Mesh& mesh, std::uint32_t facet) {
  const Mesh::Facet& f = mesh.facets[facet];
  double twice = 0;
  for (std::uint32_t i = f.first_triangle; i < f.first_triangle + f.triangle_count; ++i) {
    const std::uint32_t* corner = &mesh.triangles[3 * std::size_t(mesh.facet_triangles[i])];
    const Vec3d &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
    twice += norm(cross(b - a, c - a));
  }
  return 0.5 * twice;
}

double projected_area(const Mesh& mesh, const Vec3d& axis) {
  double sum = 0;
  for (std::uint32_t f = 0; f < mesh.facets.size(); ++f)
    sum += facet_area(mesh, f) * std::fabs(dot(mesh.facets[f].normal, axis));
  return is_closed(mesh) ? 0.5 * sum : sum;
}

bool is_closed(const Mesh& mesh) {
  for (const Mesh::Edge& e : mesh.edges)
    if (e.facet[1] == Mesh::none) return false;
  return true;
}

}  // namespace shapes
