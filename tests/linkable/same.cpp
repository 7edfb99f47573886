// What door.c prints, by way of C++.
#include <cstdio>
#include <cstring>

#include "libcontact/dispatch.h"
#include "libcontact/kernels/chunk.h"
#include "libcontact/laws/mix.h"
#include "shapes/polyhedron_build.h"

using contact::Vec3d;

static void put(const char* name, std::initializer_list<double> values) {
  std::printf("%s", name);
  for (const double v : values) std::printf(" %a", v);
  std::printf("\n");
}

int main() {
  std::vector<Vec3d> corners;
  for (const double z : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double x : {-1.0, 1.0}) corners.push_back({x, y, z});
  const shapes::Polyhedron cube = shapes::polyhedron_from_points(corners, shapes::Frame::as_given);
  contact::Body ball, box, egg, turned;
  ball.size = {1, 0, 0};
  box.kind = shapes::Kind::polyhedron;
  box.geometry = &cube;
  box.size = {1, 0, 0};
  egg.kind = shapes::Kind::ellipsoid;
  egg.size = {1.2, 0.7, 0.9};
  turned = egg;
  turned.rotation.row[0] = {0.96, -0.28, 0};
  turned.rotation.row[1] = {0.28, 0.96, 0};
  const contact::Body* a[] = {&ball, &box, &box, &box, &box};
  const contact::Body* b[] = {&ball, &egg, &turned, &box, &box};
  double along[] = {1.9, 1.95, 2, 1.95, 2.5};
  for (int round = 0; round < 2; ++round)
    for (int i = 0; i < 5; ++i) {
      const Vec3d offset{i == 3 || i == 4 ? along[i] : 1.9 + 0.05 * i, 0.1, 0.05 * i};
      const contact::Contact c = contact::query(*a[i], *b[i], offset, {.overlap_only = true});
      std::printf("%d %d\n", static_cast<int>(c.status), c.certified ? 1 : 0);
      if (round == 0 || c.status != contact::Status::separated) put("gap", {c.gap});
      put("normal", {c.normal.x, c.normal.y, c.normal.z});
      put("centre", {c.patch.centre.x, c.patch.centre.y, c.patch.centre.z});
      const double* s = c.patch.spread;
      put("spread", {s[0], s[1], s[2], s[3], s[4], s[5]});
    }
  put("sat", {contact::query(box, box, {1.95, 0.1, 0.05 * 3}, {.overlap_only = true}, "sat").gap});

  contact::Material soft{.young = 5e6, .poisson = 0.25, .restitution = 0.5, .friction = 0.4};
  const contact::PairParameters pair = contact::mix(soft, soft);
  contact::kernels::LawChunk lanes;
  for (std::size_t i = 0; i < 2; ++i) {
    lanes.normal.x[i] = 1;
    lanes.velocity.x[i] = 0.1;
    lanes.velocity.y[i] = 0.3;
    lanes.turn[i] = 0.5 * 5;
    lanes.relative_spin.x[i] = 5;
    lanes.radius_eff[i] = 0.005;
    lanes.mass_eff[i] = 0.001;
    lanes.spread_yy[i] = lanes.spread_zz[i] = static_cast<double>(i) * 1e-6;
    lanes.pair.young_eff[i] = pair.young_eff;
    lanes.pair.shear_eff[i] = pair.shear_eff;
    lanes.pair.friction[i] = pair.friction;
    lanes.pair.damping[i] = pair.damping;
  }
  for (int step = 1; step <= 5; ++step) {
    lanes.overlap[0] = 1e-6 * step;
    lanes.overlap[1] = 2e-6 * step;
    contact::kernels::kernels().hertz_mindlin_patch(lanes, 2, 1e-5, {});
    for (std::size_t i = 0; i < 2; ++i) {
      put("force", {lanes.force.x[i], lanes.force.y[i], lanes.force.z[i]});
      put("couple", {lanes.couple.x[i], lanes.couple.y[i], lanes.couple.z[i]});
    }
  }
}
