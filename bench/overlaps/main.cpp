// What the classical measures of overlap are worth: each against the true overlap, as that vanishes, over aspect
// ratios.
//
// Pairs of equal ellipses or ellipsoids of random orientation (spheroids turn by turn flat and long) that touch along a
// prescribed normal n, then pushed together by `overlap`; with the offset that follows, the least translation is the
// overlap itself, along n, while it is below m, the sum of the least radii of curvature. So the truth is known without
// any method. Overlaps are fractions of m.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"

namespace {

using namespace contact;
using shapes::Kind;

struct Pair {
  Body a, b;
  Vec3d offset, normal;
};

class Draw {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  Vec3d direction(bool flat) {
    for (;;) {
      const Vec3d v{uniform(-1, 1), uniform(-1, 1), flat ? 0 : uniform(-1, 1)};
      if (const double s = dot(v, v); s > 0.01 && s < 1) return normalized(v);
    }
  }
  Mat3d rotation(bool flat) {
    const double w = uniform(-3.2, 3.2);
    const Vec3d axis = flat ? Vec3d{0, 0, 1} : direction(false);
    return rotation_matrix(
        shapes::Quatd{std::cos(w), std::sin(w) * axis.x, std::sin(w) * axis.y, std::sin(w) * axis.z});
  }

 private:
  std::mt19937_64 engine_{2026};
};

Vec3d support(const Body& e, const Vec3d& n) {
  const Vec3d u = scaled(e.size, transposed_times(e.rotation, n));
  return e.rotation * scaled(e.size, u * (1 / norm(u)));
}

Pair draw_pair(Kind kind, double aspect, bool parallel, double fraction, Draw& draw, double& overlap) {
  const bool flat = kind == Kind::ellipse;
  const double thin = 1 / aspect;
  Pair p;
  p.a.kind = p.b.kind = kind;
  p.a.size = p.b.size = flat ? Vec3d{1, thin, 0} : draw.uniform(0, 1) < 0.5 ? Vec3d{1, 1, thin} : Vec3d{1, thin, thin};
  p.a.rotation = draw.rotation(flat);
  p.b.rotation = parallel ? p.a.rotation : draw.rotation(flat);
  p.normal = draw.direction(flat);
  overlap = fraction * 2 * thin * thin;
  p.offset = support(p.a, p.normal) - support(p.b, -p.normal) - overlap * p.normal;
  return p;
}

double thread_time() {  // s, of the processor
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// p50, p99 and the largest.
std::string spread(std::vector<double>& v, const char* format) {
  if (v.empty()) return fmt::format("{:>27}", "-");
  std::sort(v.begin(), v.end());
  std::string out;
  for (const std::size_t i : {v.size() / 2, v.size() * 99 / 100, v.size() - 1})
    out += fmt::format(fmt::runtime(format), v[i]);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  int count = 4000;
  if (argc == 3 && std::string(argv[1]) == "--count") count = std::atoi(argv[2]);
  if ((argc != 1 && argc != 3) || count < 1) {
    fmt::print(stderr, "usage: bench_overlaps [--count N]\n");
    return 2;
  }
  fmt::print(
      "measure: method_overlap / true overlap at 1e-4 m; angle: of method_normal to the true one, degrees; error: of "
      "the gap "
      "over the\noverlap, at 1e-2 and 1e-4 m; each p50, p99, largest of {} pairs; handed: share handed over; ns: a "
      "query, "
      "cold\n",
      count);
  fmt::print("{:<10}{:>7} {:<9}{:<23}{:>27}{:>21}{:>30}{:>30}{:>8}{:>6}\n", "kind", "aspect", "placed", "method",
             "measure", "angle", "error at 1e-2", "error at 1e-4", "handed", "ns");
  for (const Kind kind : {Kind::ellipse, Kind::ellipsoid})
    for (const double aspect : {1.0, 2.0, 3.0, 10.0, 30.0, 100.0})
      for (const bool parallel : {false, true})
        for (const MethodInfo* m = methods_begin(); m != methods_end(); ++m) {
          if (m->a != kind || m->b != kind) continue;
          const ChunkQuery run = find(kind, kind, m->name);
          std::vector<double> measure, angle, error[2];
          int handed = 0;
          double ns = 0;
          for (const int fine : {0, 1}) {
            Draw draw;
            std::vector<Pair> pairs;
            double overlap = 0;
            for (int i = 0; i < count; ++i)
              pairs.push_back(draw_pair(kind, aspect, parallel, fine == 1 ? 1e-4 : 1e-2, draw, overlap));
            std::vector<Contact> out(pairs.size());
            const double begin = thread_time();
            for (std::size_t i = 0; i < pairs.size(); ++i)
              run(1, &pairs[i].a, &pairs[i].b, &pairs[i].offset, {}, nullptr, &out[i]);
            ns = 1e9 * (thread_time() - begin) / count;
            for (std::size_t i = 0; i < pairs.size(); ++i) {
              const Contact& c = out[i];
              error[fine].push_back(std::abs(c.gap + overlap) / overlap);
              if (fine == 0) continue;
              handed += c.handed_over;
              if (c.handed_over) continue;
              const Vec3d &n = pairs[i].normal, off = cross(n, c.method_normal);
              measure.push_back(c.method_overlap / overlap);
              angle.push_back(std::atan2(norm(off), dot(n, c.method_normal)) * 180 / M_PI);
            }
          }
          fmt::print("{:<10}{:>7g} {:<9}{:<23}{}{}{}{}{:>7.1f}%{:>6.0f}\n", name_of(kind), aspect,
                     parallel ? "parallel" : "any", m->name, spread(measure, "{:9.3f}"), spread(angle, "{:7.1f}"),
                     spread(error[0], "{:10.1e}"), spread(error[1], "{:10.1e}"), 100.0 * handed / count, ns);
        }
  return 0;
}
