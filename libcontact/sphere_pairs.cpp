#include "libcontact/sphere_pairs.h"

#include "libcontact/kernels/pair_chunks.h"
#include "libcontact/methods/analytic.h"

namespace contact {

namespace {

using Ball = Placed<shapes::Sphere>;

void write(const Contact& c, std::size_t i, const SphereAnswers& out) {
  out.gap[i] = c.gap;
  for (int k = 0; k < 3; ++k) {
    out.normal[k][i] = c.normal[k];
    out.point[k][i] = c.patch.centre[k];
  }
}

}  // namespace

void sphere_pairs(const SphereRow* spheres, const std::uint32_t* a, const std::uint32_t* b, std::size_t count,
                  const SphereAnswers& out) {
  if (kernels::pair_kernels().sphere_pairs(spheres, a, b, count, out)) return;
  for (std::size_t i = 0; i < count; ++i) {
    if (out.gap[i] == out.gap[i]) continue;
    const SphereRow &p = spheres[a[i]], &q = spheres[b[i]];
    write(Analytic::query(Ball{p.radius}, Ball{q.radius}, q.centre - p.centre, {}, nullptr), i, out);
  }
}

}  // namespace contact
