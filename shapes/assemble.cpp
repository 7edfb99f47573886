// From faces to the finished polyhedron: planes, mass, frame, canonical order, padded arrays.
#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <numeric>

#include "shapes/convex.h"
#include "shapes/polyhedron_build.h"

namespace shapes::convex {
namespace {

// An inertia whose off-diagonal terms are round-off is diagonal already; the sums behind them leave a few eps.
constexpr double diagonal_tolerance = 1e-14;

struct Planes {
  std::vector<Vec3d> normal;
  std::vector<double> offset;
};

Planes planes_of(const std::vector<Vec3d>& vertices, const std::vector<Loop>& loops) {
  Planes planes;
  for (const Loop& loop : loops) {
    const Vec3d area = area_vector(vertices, loop);
    if (!(max_abs(area) > 0))
      throw Error("polyhedron: a face has no area; allowed: faces above rounding of the points");
    const Vec3d n = unit(area);
    double offset = dot(n, vertices[0]);
    for (const Vec3d& v : vertices) offset = std::fmax(offset, dot(n, v));  // the half-space contains the whole body
    planes.normal.push_back(n);
    planes.offset.push_back(offset);
  }
  return planes;
}

bool is_diagonal(const Mat3d& m) {
  const double largest = std::fmax(m.row[0].x, std::fmax(m.row[1].y, m.row[2].z));
  return std::fmax(std::fabs(m.row[0].y), std::fmax(std::fabs(m.row[0].z), std::fabs(m.row[1].z))) <=
         diagonal_tolerance * largest;
}

// Orientation of the principal axes: moments ascend, the largest component of the first two axes is positive,
// right-handed.
Quatd principal_axes(const Mat3d& inertia) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = inertia.row[i][j];
  m = std::ldexp(1.0, -exponent_above(m.cwiseAbs().maxCoeff())) * m;
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvectors();
  for (int j = 0; j < 2; ++j) {
    Eigen::Index largest = 0;
    axes.col(j).cwiseAbs().maxCoeff(&largest);
    if (axes(largest, j) < 0) axes.col(j) = -axes.col(j);
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  const Eigen::Quaterniond q(axes);
  const double sign = q.w() < 0 ? -1 : 1;
  return normalized(Quatd{sign * q.w(), sign * q.x(), sign * q.y(), sign * q.z()});
}

// Moves the vertices to the principal frame and returns that frame; vertices stay as they are when they are in it
// already.
Pose to_principal(std::vector<Vec3d>& vertices, const std::vector<Loop>& loops, MassProperties& mass) {
  const Pose frame = principal_frame(mass, largest_coordinate(vertices));
  const bool centred = max_abs(frame.position) == 0, aligned = is_diagonal(mass.inertia);
  if (!centred || !aligned) {
    const Mat3d rotation = rotation_matrix(frame.orientation);
    for (Vec3d& v : vertices) v = aligned ? v - frame.position : transposed_times(rotation, v - frame.position);
    mass = mass_of(vertices, loops);
  }
  mass.centre = {};  // what is left of them is round-off
  mass.inertia = Mat3d::diagonal({mass.inertia.row[0].x, mass.inertia.row[1].y, mass.inertia.row[2].z});
  return frame;
}

void add_edges(Polyhedron& p) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> face_of;
  const auto next_in_loop = [&](const Polyhedron::Face& f, std::uint32_t i) {
    return p.face_vertices[f.first + (i + 1) % f.count];
  };
  for (std::uint32_t f = 0; f < p.faces.size(); ++f)
    for (std::uint32_t i = 0; i < p.faces[f].count; ++i)
      face_of[{p.face_vertices[p.faces[f].first + i], next_in_loop(p.faces[f], i)}] = f;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edge_of;
  for (const auto& [e, f] : face_of) {
    if (e.first > e.second) continue;
    edge_of[e] = edge_of[{e.second, e.first}] = static_cast<std::uint32_t>(p.edges.size());
    p.edges.push_back({{e.first, e.second}, {f, face_of.at({e.second, e.first})}});
  }
  for (const Polyhedron::Face& f : p.faces)
    for (std::uint32_t i = 0; i < f.count; ++i)
      p.face_edges.push_back(edge_of.at({p.face_vertices[f.first + i], next_in_loop(f, i)}));
}

// Numbers vertices by rank, starts every loop at its lowest vertex and sorts the faces by their loops.
void add_canonical(Polyhedron& p, const Faces& faces, const Planes& planes) {
  std::vector<std::uint32_t> order(faces.vertices.size()), number(faces.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return faces.rank[a] < faces.rank[b]; });
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    number[order[i]] = i;
    p.vertices.push_back(faces.vertices[order[i]]);
  }
  std::vector<std::pair<Loop, std::size_t>> loops;
  for (std::size_t f = 0; f < faces.loops.size(); ++f) {
    Loop loop;
    for (const std::uint32_t v : faces.loops[f]) loop.push_back(number[v]);
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    loops.emplace_back(std::move(loop), f);
  }
  std::sort(loops.begin(), loops.end());
  for (const auto& [loop, f] : loops) {
    p.faces.push_back({planes.normal[f], planes.offset[f], static_cast<std::uint32_t>(p.face_vertices.size()),
                       static_cast<std::uint32_t>(loop.size())});
    p.face_vertices.insert(p.face_vertices.end(), loop.begin(), loop.end());
  }
}

// Padded arrays and radii, from vertices and faces.
void complete(Polyhedron& p) {
  const auto padded = [](std::size_t n) {
    return (n + polyhedron_padding - 1) / polyhedron_padding * polyhedron_padding;
  };
  for (auto* array : {&p.vx, &p.vy, &p.vz, &p.nx, &p.ny, &p.nz, &p.nd}) array->clear();
  p.circumradius = 0;
  for (std::size_t i = 0; i < padded(p.vertices.size()); ++i) {
    const Vec3d& v = p.vertices[i < p.vertices.size() ? i : 0];
    p.vx.push_back(v.x);
    p.vy.push_back(v.y);
    p.vz.push_back(v.z);
    p.circumradius = std::fmax(p.circumradius, safe_norm(v));
  }
  p.inscribed_radius = p.faces[0].offset;
  p.core_radius = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < padded(p.faces.size()); ++i) {
    const Polyhedron::Face& f = p.faces[i < p.faces.size() ? i : 0];
    p.nx.push_back(f.normal.x);
    p.ny.push_back(f.normal.y);
    p.nz.push_back(f.normal.z);
    p.nd.push_back(f.offset);
    p.inscribed_radius = std::fmin(p.inscribed_radius, f.offset);
    p.core_radius = std::fmin(p.core_radius, f.offset - dot(f.normal, p.mass.centre));
  }
  add_neighbours(p);
}

}  // namespace

Pose principal_frame(const MassProperties& mass, double size) {
  Pose frame;
  if (max_abs(mass.centre) > 8 * std::numeric_limits<double>::epsilon() * size) frame.position = mass.centre;
  if (!is_diagonal(mass.inertia)) frame.orientation = principal_axes(mass.inertia);
  return frame;
}

Polyhedron assemble(Faces faces, Frame frame, int exponent) {
  Polyhedron p;
  p.mass = mass_of(faces.vertices, faces.loops);
  if (!(p.mass.volume > 0)) throw Error("polyhedron: no volume; allowed: points that span a volume");
  if (frame == Frame::principal) p.frame = to_principal(faces.vertices, faces.loops, p.mass);
  add_canonical(p, faces, planes_of(faces.vertices, faces.loops));
  add_edges(p);

  const auto length = [&](double x) { return std::ldexp(x, exponent); };
  for (Vec3d& v : p.vertices) v = times_two_to(v, exponent);
  for (Polyhedron::Face& f : p.faces) f.offset = length(f.offset);
  p.frame.position = times_two_to(p.frame.position, exponent);
  p.mass.volume = std::ldexp(p.mass.volume, 3 * exponent);
  p.mass.centre = times_two_to(p.mass.centre, exponent);
  for (Vec3d& row : p.mass.inertia.row) row = times_two_to(row, 5 * exponent);
  complete(p);
  return p;
}

}  // namespace shapes::convex

namespace shapes {

Polyhedron scaled(const Polyhedron& p, double s) {
  if (!(s > 0) || !std::isfinite(s)) throw Error("scale: " + std::to_string(s) + "; allowed: finite and > 0");
  Polyhedron r = p;
  for (Vec3d& v : r.vertices) v *= s;
  for (Polyhedron::Face& f : r.faces) {
    f.offset = dot(f.normal, r.vertices[0]);
    for (const Vec3d& v : r.vertices) f.offset = std::fmax(f.offset, dot(f.normal, v));
  }
  r.frame.position *= s;
  const double s2 = s * s, s3 = s2 * s;
  r.mass.volume *= s3;
  r.mass.centre *= s;
  for (Vec3d& row : r.mass.inertia.row) row *= s3 * s2;
  convex::complete(r);
  return r;
}

}  // namespace shapes
