#include "libdem/analysis/rose.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "libdem/analysis/fabric.h"
#include "libdem/analysis/table.h"

namespace dem::analysis {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double edge = 1e-9;  // of a bin: what lies so near its upper edge is on it

double pressing(const Pair& p) { return std::max(p.pressing, 0.0); }

struct Harmonics {
  std::complex<double> second, fourth;
  double weight = 0;
  void add(double angle, double w) {
    second += w * std::polar(1.0, 2 * angle);
    fourth += w * std::polar(1.0, 4 * angle);
    weight += w;
  }
  HarmonicFit fit() const {
    if (!(weight > 0)) return {};
    const auto angle = [](const std::complex<double>& c, double order) {
      const double a = std::arg(c);
      return (a < 0 ? a + 2 * pi : a) / order;
    };
    return {2 * std::abs(second) / weight, angle(second, 2), 2 * std::abs(fourth) / weight, angle(fourth, 4)};
  }
};

void scale(std::vector<double>& values, double total) {
  for (double& v : values) v = total > 0 ? v / total : 0;
}

}  // namespace

double HarmonicFit::density(double t) const {
  return (1 + a2 * std::cos(2 * (t - angle2)) + a4 * std::cos(4 * (t - angle4))) / (2 * pi);
}

double Rose::width() const { return 2 * pi / static_cast<double>(number.size()); }

Rose rose_of(const std::vector<Pair>& pairs, const Vec3d& u, const Vec3d& v, int bins) {
  const auto half = static_cast<std::size_t>(std::max(bins, 1) + 1) / 2;
  const double width = pi / static_cast<double>(half);
  Rose rose;
  std::vector<double> number(half, 0), force(half, 0), beside(half, 0);
  Harmonics by_number, by_force;
  double total = 0;
  for (const Pair& p : pairs) {
    const double x = dot(p.normal, u), y = dot(p.normal, v);
    if (x * x + y * y < 1e-12) {
      ++rose.across;
      continue;
    }
    double angle = std::atan2(y, x);
    if (angle < 0) angle += pi;
    const double place = angle / width;
    const double middle = std::floor(place + 0.5 - edge);
    const std::size_t bin = static_cast<std::size_t>(std::max(middle, 0.0)) % half;
    const double f = pressing(p);
    ++number[bin];
    force[bin] += f;
    beside[bin] += (place - middle) * width;
    by_number.add(angle, 1);
    by_force.add(angle, f);
    total += f;
    ++rose.used;
  }
  for (std::size_t k = 0; k < 2 * half; ++k) {
    const std::size_t bin = k % half;
    rose.mean_angle.push_back(static_cast<double>(k) * width + (number[bin] > 0 ? beside[bin] / number[bin] : 0));
    rose.number.push_back(number[bin]);
    rose.force.push_back(force[bin]);
  }
  scale(rose.number, 2 * static_cast<double>(rose.used));
  scale(rose.force, 2 * total);
  rose.number_fit = by_number.fit();
  rose.force_fit = by_force.fit();
  return rose;
}

HalfSphereBins::HalfSphereBins(std::size_t wanted) {
  const double n = static_cast<double>(std::max<std::size_t>(wanted, 1)), area = 2 * pi / n;
  collars_.push_back({0, 1});
  size_ = 1;
  if (wanted <= 1) return;
  const double cap = std::acos(1 - 1 / n), rest = pi / 2 - cap;
  const double rows = std::max(1.0, std::round(rest / std::sqrt(area)));
  double ideal = 1;
  for (int row = 1; row <= static_cast<int>(rows); ++row) {
    ideal = n * (1 - std::cos(cap + rest * row / rows));
    const double end = row == static_cast<int>(rows) ? n : std::round(ideal);
    const auto sectors = static_cast<std::size_t>(end) - size_;
    if (sectors == 0) continue;
    collars_.push_back({size_, sectors});
    size_ += sectors;
  }
}

double HalfSphereBins::solid_angle() const { return 2 * pi / static_cast<double>(size_); }

Vec3d HalfSphereBins::folded(const Vec3d& n) {
  const double leading = std::abs(n.z) > edge ? n.z : (std::abs(n.y) > edge ? n.y : n.x);
  return leading < 0 ? -n : n;
}

std::size_t HalfSphereBins::index(const Vec3d& direction) const {
  const Vec3d n = folded(direction);
  const double place = (1 - n.z) * static_cast<double>(size_) - edge;  // bins above
  std::size_t row = 0;
  while (row + 1 < collars_.size() && place > static_cast<double>(collars_[row + 1].first)) ++row;
  const Collar& c = collars_[row];
  const double width = 2 * pi / static_cast<double>(c.sectors);
  double angle = std::atan2(n.y, n.x);
  if (angle < -edge) angle += 2 * pi;
  const double sector = std::max(std::floor(angle / width + 0.5 - edge), 0.0);
  return c.first + static_cast<std::size_t>(sector) % c.sectors;
}

Vec3d HalfSphereBins::centre(std::size_t bin) const {
  if (bin == 0) return {0, 0, 1};
  std::size_t row = 0;
  while (row + 1 < collars_.size() && bin >= collars_[row + 1].first) ++row;
  const Collar& c = collars_[row];
  const double z = 1 - (static_cast<double>(c.first) + static_cast<double>(c.sectors) / 2) / static_cast<double>(size_);
  const double angle = 2 * pi * static_cast<double>(bin - c.first) / static_cast<double>(c.sectors);
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

SphereRose rose_of(const std::vector<Pair>& pairs, const HalfSphereBins& bins) {
  SphereRose rose;
  rose.number.assign(bins.size(), 0);
  rose.force.assign(bins.size(), 0);
  rose.mean.assign(bins.size(), Vec3d{});
  double total = 0;
  for (const Pair& p : pairs) {
    const std::size_t bin = bins.index(p.normal);
    ++rose.number[bin];
    rose.force[bin] += pressing(p);
    total += pressing(p);
    rose.mean[bin] += HalfSphereBins::folded(p.normal);
  }
  scale(rose.number, static_cast<double>(pairs.size()));
  scale(rose.force, total);
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const double length = norm(rose.mean[k]);
    rose.mean[k] = length > 0 ? rose.mean[k] * (1 / length) : bins.centre(k);
  }
  return rose;
}

namespace {

void add_fit(Result& r, const std::string& name, const HarmonicFit& fit) {
  r.add(name + "_a2", "1", fit.a2);
  r.add(name + "_angle2", "rad", fit.angle2);
  r.add(name + "_a4", "1", fit.a4);
  r.add(name + "_angle4", "rad", fit.angle4);
}

Table plane_table(const Rose& rose, const std::string& name) {
  Table t = table_of(name, "Contact normals in the plane " + name + ", by number and by force",
                     {{"angle", "rad"},
                      {"share", "1"},
                      {"force_share", "1"},
                      {"density", "1/rad"},
                      {"force_density", "1/rad"},
                      {"fit", "1/rad"},
                      {"force_fit", "1/rad"},
                      {"mean_angle", "rad"}});
  const double width = rose.width();
  for (std::size_t k = 0; k < rose.number.size(); ++k) {
    const double angle = width * static_cast<double>(k);
    add_row(t, angle, rose.number[k], rose.force[k], rose.number[k] / width, rose.force[k] / width,
            rose.number_fit.density(angle), rose.force_fit.density(angle), rose.mean_angle[k]);
  }
  return t;
}

Table sphere_table(const SphereRose& rose, const HalfSphereBins& bins, const Mat3d& fit) {
  Table t = table_of("sphere",
                     "Contact normals on bins of equal solid angle over the half sphere; n and -n are one direction",
                     {{"x", "1"},
                      {"y", "1"},
                      {"z", "1"},
                      {"share", "1"},
                      {"force_share", "1"},
                      {"density", "1/sr"},
                      {"force_density", "1/sr"},
                      {"fit", "1/sr"},
                      {"mean_x", "1"},
                      {"mean_y", "1"},
                      {"mean_z", "1"}});
  const double angle = 2 * bins.solid_angle();  // with the bin of −n
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const Vec3d n = bins.centre(k), mean = rose.mean[k];
    add_row(t, n.x, n.y, n.z, rose.number[k], rose.force[k], rose.number[k] / angle, rose.force[k] / angle,
            (1 + dot(n, fit * n)) / (4 * pi), mean.x, mean.y, mean.z);
  }
  return t;
}

}  // namespace

Result report_rose(const Snapshot& s, const Settings& settings) {
  Result r;
  if (lacks_contacts(s, r)) return r;
  const std::vector<Pair> pairs = within(pairs_of(s), s, settings.region).bodies;
  r.add("contacts", "1", static_cast<double>(pairs.size()));
  if (pairs.empty()) {
    r.notes.emplace_back("no contacts between bodies");
    return r;
  }
  if (settings.bins % 2 != 0) r.notes.emplace_back("an odd number of bins counts as the next even one");
  if (std::any_of(pairs.begin(), pairs.end(), [](const Pair& p) { return p.pressing < 0; }))
    r.notes.emplace_back("contacts that pull count as zero in shares of force");
  if (!s.has_forces) r.notes.emplace_back("forces are not known: shares of force are zero");
  const Vec3d axis[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int u = 0; u < s.dimension; ++u)
    for (int v = u + 1; v < s.dimension; ++v) {
      const std::string name{"xyz"[u], "xyz"[v]};
      const Rose rose = rose_of(pairs, axis[u], axis[v], settings.bins);
      add_fit(r, name, rose.number_fit);
      add_fit(r, name + "_force", rose.force_fit);
      if (rose.across > 0) r.add(name + "_left_out", "1", static_cast<double>(rose.across));
      r.tables.push_back(plane_table(rose, name));
    }
  if (s.dimension == 3) {
    DirectionMoments moments;
    for (const Pair& p : pairs) moments.add(p.normal);
    const double side = 2 * pi / std::max(settings.bins, 1);
    const HalfSphereBins bins(static_cast<std::size_t>(std::max(1.0, std::round(2 * pi / (side * side)))));
    r.tables.push_back(sphere_table(rose_of(pairs, bins), bins, second_order_fit(moments.second(), 3)));
  }
  return r;
}

}  // namespace dem::analysis
