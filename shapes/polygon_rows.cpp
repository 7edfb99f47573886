#include "shapes/polygon_rows.h"

#include <algorithm>
#include <cmath>

#include "shapes/polygon.h"

namespace shapes {

namespace {

using Part = Polygon::Part;

// Lies a seam on side k of a part, to rounding?
bool lies_on(const Polygon::Seam& seam, const Part& part, std::size_t k, double size) {
  return std::all_of(seam.end, seam.end + 2,
                     [&](const Vec3d& x) { return std::abs(dot(part.normals[k], x) - part.offsets[k]) < 1e-9 * size; });
}

struct Marks {
  std::vector<CutMark> start, end;  // of each side, as seen from its first corner, from its second
};

Marks marks_of(const Polygon& p, std::uint32_t i) {
  const Part& part = p.parts[i];
  const std::size_t count = part.vertices.size();
  Marks marks;
  for (const std::uint32_t e : part.edge)
    marks.start.push_back(e == Polygon::none ? CutMark::from_reflex : CutMark::outline);
  std::vector<char> seen(count);
  bool clear = true;  // each seam lies on one side
  marks.end = marks.start;
  for (const Polygon::Seam& seam : p.seams) {
    if (seam.part[0] != i && seam.part[1] != i) continue;
    std::size_t sides = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (part.edge[k] != Polygon::none || !lies_on(seam, part, k, p.circumradius)) continue;
      ++sides;
      seen[k] = 1;
      const auto begins_at = [&](const Vec3d& v) {
        return std::any_of(seam.corner, seam.corner + 2,
                           [&](std::uint32_t c) { return c != Polygon::none && p.vertices[c] == v; });
      };
      if (!begins_at(part.vertices[k])) marks.start[k] = CutMark::other;
      if (!begins_at(part.vertices[(k + 1) % count])) marks.end[k] = CutMark::other;
    }
    clear = clear && sides == 1;
  }
  for (std::size_t k = 0; k < count; ++k)
    if (part.edge[k] == Polygon::none && !(clear && seen[k] != 0)) marks.start[k] = marks.end[k] = CutMark::other;
  return marks;
}

void set(double (&to)[2], const Vec3d& x) {
  to[0] = x.x;
  to[1] = x.y;
}

}  // namespace

void make_rows(Polygon& p) {
  for (std::uint32_t i = 0; i < p.parts.size(); ++i) {
    Part& part = p.parts[i];
    const Marks marks = marks_of(p, i);
    const std::size_t n = part.vertices.size();
    part.corner_rows.resize(n);
    part.side_rows.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t one = (k + 1) % n, two = (k + 2) % n, back = (k + n - 1) % n, far_back = (k + n - 2) % n;
      const auto from_start = [&](std::size_t side) { return static_cast<double>(marks.start[side]); };
      const auto from_end = [&](std::size_t side) { return static_cast<double>(marks.end[side]); };
      CornerRow& c = part.corner_rows[k];
      set(c.corner, part.vertices[k]);
      set(c.left[0], part.vertices[one]);
      set(c.left[1], part.vertices[two]);
      set(c.right[0], part.vertices[back]);
      set(c.right[1], part.vertices[far_back]);
      set(c.far, part.vertices[(k + n / 2) % n]);
      c.cut_left[0] = from_start(k);
      c.cut_left[1] = from_start(one);
      c.cut_right[0] = from_end(back);
      c.cut_right[1] = from_end(far_back);
      SideRow& s = part.side_rows[k];
      set(s.before, part.vertices[back]);
      set(s.start, part.vertices[k]);
      set(s.end, part.vertices[one]);
      set(s.after, part.vertices[two]);
      set(s.normal, part.normals[k]);
      s.offset = part.offsets[k];
      s.cut = from_start(k);
      s.cut_before = from_end(back);
      s.cut_after = from_start(one);
      s.unused[0] = s.unused[1] = 0;
    }
  }
}

}  // namespace shapes
