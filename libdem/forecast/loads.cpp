#include "libdem/forecast/loads.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libdem/forecast/closed_forms.h"
#include "shapes/mesh_generate.h"

namespace dem::forecast {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Interval {
  double lower = infinity, upper = -infinity;
  void add(double low, double high) {
    lower = std::min(lower, low);
    upper = std::max(upper, high);
  }
  double length() const { return upper > lower ? upper - lower : 0; }
  bool holds(double x) const { return x >= lower && x <= upper; }
};

// A direction and two across it.
struct Frame {
  Vec3d axis[3];
  explicit Frame(const Vec3d& direction) {
    axis[0] = direction * (1 / norm(direction));
    const Vec3d& d = axis[0];
    const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    const Vec3d other = x <= y && x <= z ? Vec3d{1, 0, 0} : y <= z ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
    const Vec3d across = cross(d, other);
    axis[1] = across * (1 / norm(across));
    axis[2] = cross(d, axis[1]);
  }
};

// Extent of all bodies along a direction, m; the box's where the direction is a periodic axis.
Interval extent_along(const World& world, const Vec3d& direction) {
  Interval extent;
  for (int k = 0; k < 3; ++k)
    if (world.cell.lattice.length[k] > 0 && std::abs(direction[k]) > 1 - 1e-9) {
      const double low = direction[k] > 0 ? world.cell.lower[k] : -world.cell.lower[k] - world.cell.lattice.length[k];
      return {low, low + world.cell.lattice.length[k]};
    }
  for (const Motion& m : world.particles.motion) {
    const double at = dot(direction, m.position);
    extent.add(at - m.bounding_radius, at + m.bounding_radius);
  }
  return extent;
}

// How far body i can go along `down` until a wall stops it, at most; infinity when none is in the way.
class Ground {
 public:
  Ground(const World& world, const Frame& frame) : world_(world), frame_(frame) {
    for (const Wall& w : world.walls) {
      const shapes::Mat3d r = shapes::rotation_matrix(w.orientation);
      if (is_half_space(w.kind)) {
        const Vec3d normal = r.column(w.kind == shapes::Kind::plane ? 2 : 1);
        const double against = -dot(normal, frame.axis[0]);
        if (against > 1e-6) planes_.push_back({normal, dot(normal, w.position), against});
      } else if (w.mesh) {
        Mesh m;
        for (const Vec3d& v : w.mesh->vertices) {
          const Vec3d x = w.position + r * v;
          for (int k = 0; k < 3; ++k) m.extent[k].add(dot(frame.axis[k], x), dot(frame.axis[k], x));
        }
        meshes_.push_back(m);
      }
    }
  }

  double below(std::size_t i) const {
    const Motion& m = world_.particles.motion[i];
    double nearest = infinity, lowest = -infinity;
    for (const Plane& p : planes_) {
      const double height = dot(p.normal, m.position) - p.offset;
      if (height > 0) nearest = std::min(nearest, std::max(0.0, (height - m.bounding_radius) / p.against));
    }
    for (const Mesh& mesh : meshes_) {
      const bool over = mesh.extent[1].holds(dot(frame_.axis[1], m.position)) &&
                        mesh.extent[2].holds(dot(frame_.axis[2], m.position));
      const double way = mesh.extent[0].upper - dot(frame_.axis[0], m.position);
      if (over && way > 0) lowest = std::max(lowest, way);
    }
    return nearest < infinity ? nearest : lowest > 0 ? lowest : infinity;
  }

 private:
  struct Plane {
    Vec3d normal;
    double offset, against;
  };
  struct Mesh {
    Interval extent[3];
  };
  const World& world_;
  const Frame& frame_;
  std::vector<Plane> planes_;
  std::vector<Mesh> meshes_;
};

template <class Rows>
double steepest(const Rows& rows) {
  double most = 0;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    double square = 0;
    for (std::size_t k = 1; k < rows[r].size(); ++k) square += std::pow(rows[r][k] - rows[r - 1][k], 2);
    most = std::max(most, std::sqrt(square) / (rows[r][0] - rows[r - 1][0]));
  }
  return most;
}

// Fastest point of a wall during a run of `time` seconds, m/s. A plane turns about its motion's centre as far as the
// bodies reach.
double speed_of(const World& world, const Wall& w, double time) {
  const WallSpec& m = w.motion;
  if (m.motion == WallMotion::fixed || m.start >= time) return 0;
  double arm = norm(w.reference - m.centre) + w.extent;
  if (is_half_space(w.kind))
    for (const Motion& body : world.particles.motion) arm = std::max(arm, norm(body.position - m.centre));
  switch (m.motion) {
    case WallMotion::fixed:
      return 0;
    case WallMotion::translation:
      return norm(m.velocity);
    case WallMotion::rotation:
      return std::abs(m.rate) * arm;
    case WallMotion::oscillation:
      return norm(m.amplitude) * (2 * std::numbers::pi * m.frequency);
    case WallMotion::table:
      return steepest(m.displacements) + steepest(m.turns) * arm;
    case WallMotion::servo:
      return m.speed_limit;
  }
  return 0;
}

// Area of the bodies as seen along a direction, m²; in the plane width times thickness.
double ground_area(const World& world, const Frame& frame, double thickness) {
  const double first = extent_along(world, frame.axis[1]).length(),
               second = extent_along(world, frame.axis[2]).length();
  if (world.scene.dimension != 2) return first * second;
  return (std::abs(frame.axis[1].z) > 0.5 ? second : first) * thickness;
}

// Each body comes to lie on what is below it, packed: from its way to the ground goes the height of that.
void fall(const World& world, const Frame& frame, double gravity, double time, Loads& loads) {
  const Particles& p = world.particles;
  const Ground ground(world, frame);
  const double own = extent_along(world, frame.axis[0]).length();
  bool periodic = false;
  for (int k = 0; k < 3; ++k)
    periodic = periodic || (world.cell.lattice.length[k] > 0 && std::abs(frame.axis[0][k]) > 1e-6);
  std::vector<std::pair<double, double>> way;  // to the ground, m; height of the body's own layer, m
  for (std::size_t i = 0; i < p.count(); ++i) {
    const double to_ground = ground.below(i);
    const double layer =
        p.mass[i] / world.materials[p.material[i]].density / (loads.solid_fraction * loads.ground_area);
    if (to_ground < infinity)
      way.emplace_back(to_ground, layer);
    else
      ++loads.unsupported;
  }
  std::sort(way.begin(), way.end());
  double below = 0;
  for (const auto& [to_ground, layer] : way) {
    loads.fall = std::max(loads.fall, to_ground - below);
    below += layer;
  }
  const double v = loads.body_speed;
  if (loads.unsupported > 0) loads.fall = std::max(loads.fall, own);
  if (periodic) loads.fall = infinity;  // nothing ends the fall but the run
  loads.fall = std::min(loads.fall, 0.5 * gravity * time * time + v * time);
  if (loads.unsupported < p.count() && !periodic)
    loads.fall_time = (std::sqrt(v * v + 2 * gravity * loads.fall) - v) / gravity;
}

}  // namespace

Loads expected_loads(const World& world) {
  const Particles& p = world.particles;
  const Vec3d gravity = world.scene.gravity;
  const double g = norm(gravity), time = static_cast<double>(total_steps(world)) * world.time_step.dt;
  Loads loads;
  if (p.count() == 0) return loads;
  Interval velocity[3];
  double fastest = 0, mass = 0, volume = 0, largest = 0;
  for (std::size_t i = 0; i < p.count(); ++i) {
    const Motion& m = p.motion[i];
    for (int k = 0; k < 3; ++k) velocity[k].add(m.velocity[k], m.velocity[k]);
    fastest = std::max(fastest, norm(m.velocity));
    mass += p.mass[i];
    volume += p.mass[i] / world.materials[p.material[i]].density;
    largest = std::max(largest, m.equivalent_radius);
  }
  loads.body_speed = std::max(fastest, norm(Vec3d{velocity[0].length(), velocity[1].length(), velocity[2].length()}));
  for (const Wall& w : world.walls) loads.wall_speed = std::max(loads.wall_speed, speed_of(world, w, time));
  for (const DeformSpec& d : world.scene.periodic.deform)
    if (d.start < time) {
      const double rate = std::max(max_abs(d.strain_rates), d.rate_limit);
      loads.flow_speed = std::max(loads.flow_speed, 2 * largest * rate);
      if (const double target = max_abs(d.target_stress); target > 0)
        loads.pressures.push_back({"periodic box", target});
    }
  if (world.scene.dimension == 2) {
    loads.solid_fraction = 0.8;
    loads.contacts = 4;
    loads.thickness = world.scene.thickness > 0 ? world.scene.thickness : 2 * largest;
  }
  if (g > 0) {
    const Frame frame(gravity);
    const double area = loads.ground_area = ground_area(world, frame, loads.thickness);
    loads.bed_height = volume / (loads.solid_fraction * area);
    fall(world, frame, g, time, loads);
    if (loads.unsupported < p.count()) loads.pressures.push_back({"weight of the bed", mass * g / area});
  }
  for (const Wall& w : world.walls) {
    if (w.motion.motion != WallMotion::servo) continue;
    double area = w.motion.area;
    if (area == 0 && w.mesh) area = shapes::projected_area(*w.mesh, w.push);
    if (area == 0) area = ground_area(world, Frame(w.push), loads.thickness);
    loads.pressures.push_back({"wall \"" + w.name + "\"", w.target / area});
  }
  loads.impact =
      std::sqrt(loads.body_speed * loads.body_speed + 2 * g * loads.fall) + loads.wall_speed + loads.flow_speed;
  return loads;
}

std::vector<PairForecast> pair_forecasts(const World& world, const std::vector<BodyGroup>& groups, const Loads& loads) {
  const Particles& p = world.particles;
  const bool hertz = world.law.hertzian;
  double pressure = 0;
  for (const Pressure& q : loads.pressures) pressure = std::max(pressure, q.value);
  std::vector<PairForecast> list;
  for (const PairLimit& limit : pair_limits(world, groups)) {
    PairForecast f;
    f.limit = limit;
    const std::uint32_t own = groups[limit.group].material,
                        other = limit.wall ? world.walls[limit.partner].material : groups[limit.partner].material;
    const PairParameters& q = world.pairs[own * world.materials.size() + other];
    // Overlaps of the largest members, durations of the lightest.
    const auto meet = [&](std::size_t a, std::size_t b, const auto& use) {
      double m = p.mass[a], r = p.motion[a].equivalent_radius, least = r;
      if (!limit.wall) {
        const double s = p.motion[b].equivalent_radius;
        m = m * p.mass[b] / (m + p.mass[b]);
        least = std::min(r, s);
        r = r * s / (r + s);
      }
      use(m, r, least);
    };
    const auto collide = [&](double m, double r) {
      return hertz ? hertz_collision(m, r, q.young_eff, loads.impact)
                   : linear_collision(m, q.stiffness_n, loads.impact);
    };
    const bool moves = loads.impact > 0;
    meet(groups[limit.group].light, limit.wall ? 0 : groups[limit.partner].light,
         [&](double m, double r, double) { f.duration = moves ? collide(m, r).duration : infinity; });
    meet(groups[limit.group].large, limit.wall ? 0 : groups[limit.partner].large,
         [&](double m, double r, double least) {
           if (moves) f.impact_overlap = collide(m, r).overlap / least;
           const double force =
               loads.thickness > 0
                   ? contact_force_of_prisms(pressure, least, loads.thickness, loads.solid_fraction, loads.contacts)
                   : contact_force(pressure, least, loads.solid_fraction, loads.contacts);
           f.press_overlap = (hertz ? hertz_overlap(force, r, q.young_eff) : force / q.stiffness_n) / least;
         });
    list.push_back(f);
  }
  return list;
}

std::vector<RayleighTime> rayleigh_times(const World& world) {
  std::vector<double> smallest(world.materials.size(), infinity);
  for (std::size_t i = 0; i < world.particles.count(); ++i) {
    double& r = smallest[world.particles.material[i]];
    r = std::min(r, world.particles.motion[i].equivalent_radius);
  }
  std::vector<RayleighTime> list;
  for (std::size_t i = 0; i < smallest.size(); ++i) {
    const Material& m = world.materials[i];
    if (smallest[i] < infinity && m.young > 0 && m.density > 0 && !m.rigid)
      list.push_back(
          {static_cast<std::uint32_t>(i), smallest[i], rayleigh_time(smallest[i], m.density, m.young, m.poisson)});
  }
  return list;
}

}  // namespace dem::forecast
