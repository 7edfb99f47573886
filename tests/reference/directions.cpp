#include "tests/reference/directions.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace reference {
namespace {

using shapes::Vec3d;

struct Corner {
  Vec3d n, w;
  double f() const { return dot(n, w); }
};

struct Split {
  Corner corner[3];
  int corners;
  Cell cell;
  double bound;
  bool operator<(const Split& other) const { return bound < other.bound; }
};

}  // namespace

Directions search(bool planar, double tolerance, const std::function<Vec3d(const Vec3d&)>& w) {
  constexpr int most_evaluations = 12000;
  std::vector<Corner> known;
  double best = -HUGE_VAL;
  const auto evaluate = [&](const Vec3d& direction) {
    const Vec3d n = normalized(direction);
    known.push_back({n, w(n)});
    best = std::max(best, known.back().f());
    return known.back();
  };
  std::priority_queue<Split> queue;
  const auto add = [&](const Corner& a, const Corner& b, const Corner& c) {
    Split s{{a, b, c}, planar ? 2 : 3, {}, HUGE_VAL};
    s.cell.centre = normalized(planar ? a.n + b.n : a.n + b.n + c.n);
    double cosine = 1;
    for (int i = 0; i < s.corners; ++i) {
      cosine = std::min(cosine, dot(s.cell.centre, s.corner[i].n));
      s.cell.radius = std::max(s.cell.radius, norm(s.corner[i].n - s.cell.centre));
    }
    const Corner middle = evaluate(s.cell.centre);
    for (int k = 0; k <= s.corners; ++k) {
      const Vec3d& slope = k == s.corners ? middle.w : s.corner[k].w;
      double most = -HUGE_VAL;
      for (int i = 0; i < s.corners; ++i) most = std::max(most, dot(slope, s.corner[i].n));
      s.bound = std::min(s.bound, most > 0 ? most / cosine : most);
    }
    queue.push(s);
  };
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (const double i : {1.0, -1.0})
    for (const double j : {1.0, -1.0}) {
      const Corner a = evaluate(i * x), b = evaluate(j * y);
      if (planar) {
        add(a, b, b);
      } else {
        for (const double k : {1.0, -1.0}) add(a, b, evaluate(k * z));
      }
    }
  while (queue.top().bound > best + tolerance && known.size() < most_evaluations) {
    const Split s = queue.top();
    queue.pop();
    const Corner &a = s.corner[0], &b = s.corner[1], &c = s.corner[2];
    const Corner ab = evaluate(a.n + b.n);
    if (planar) {
      add(a, ab, ab), add(ab, b, b);
      continue;
    }
    const Corner bc = evaluate(b.n + c.n), ca = evaluate(c.n + a.n);
    add(a, ab, ca), add(b, bc, ab), add(c, ca, bc), add(ab, bc, ca);
  }
  Directions found{{}, {}, best, std::max(best, queue.top().bound)};
  const double rounding = 1e-14;  // of values and bounds, in units of the extent
  for (; !queue.empty() && queue.top().bound >= best - rounding; queue.pop()) found.cells.push_back(queue.top().cell);
  std::sort(known.begin(), known.end(), [](const Corner& a, const Corner& b) { return a.f() > b.f(); });
  for (const Corner& k : known) {
    if (found.starts.size() >= 8 || k.f() < best - 1e3 * std::max(tolerance, found.bound - best)) break;
    if (std::none_of(found.starts.begin(), found.starts.end(), [&](const Vec3d& n) { return norm(n - k.n) < 0.02; }))
      found.starts.push_back(k.n);
  }
  return found;
}

}  // namespace reference
