#include "libdem/forces_polygons.h"

#include <algorithm>
#include <bit>

#include "libcontact/methods/planar_apart.h"
#include "libdem/law_map.h"
#include "libdem/regions.h"
#include "libdem/sleep.h"

namespace dem {

using contact::PartSide;
using contact::SideContact;
using contact::kernels::PolygonChunk;
using shapes::Polygon;

namespace {

// What the kernel leaves of a contact for the law, to another lane.
void move_lane(std::size_t from, std::size_t to, LawChunk& l) {
  for (contact::kernels::Lane* lane :
       {&l.overlap, &l.normal.x, &l.normal.y, &l.normal.z, &l.velocity.x, &l.velocity.y, &l.velocity.z, &l.turn,
        &l.radius_eff, &l.mass_eff, &l.spread_xx, &l.spread_yy, &l.spread_zz, &l.spread_xy, &l.spread_xz, &l.spread_yz,
        &l.relative_spin.x, &l.relative_spin.y, &l.relative_spin.z})
    (*lane)[to] = (*lane)[from];
}

}  // namespace

// The contacts of some pairs, side by side.
struct PolygonPass::Lanes {
  PolygonChunk chunk;
  std::uint32_t record[chunk_size], place[chunk_size];
  struct Pair {
    std::uint32_t place, first, last;  // in the bin; its lanes
  } pair[chunk_size];
  std::size_t count = 0, pairs = 0;
};

PolygonPass::PolygonPass(World& world, double dt)
    : ForcePass(world, dt), query_(contact::find(shapes::Kind::polygon, shapes::Kind::polygon, "planar")) {
  const LawMap map = world.scene.law.map;
  depths_ = by_depth_ && !lingers_ && (map == LawMap::automatic || map == LawMap::equivalent_radius);
}

bool PolygonPass::takes(const Bin& bin) const {
  if (!depths_ || bin.wall || !bin.exact || bin.a != shapes::Kind::polygon || bin.b != shapes::Kind::polygon)
    return false;
  return bin.regions ? !c_.travel.empty() : bin.query == query_;
}

// Lane i, of record k.
void PolygonPass::fill(std::size_t i, std::size_t k, const PartSide& side, Lanes& lanes) const {
  PolygonChunk& c = lanes.chunk;
  const std::uint32_t bodies[2] = {c_.index_a[k], c_.index_b[k]};
  const bool of_b = side.at.kind == SideContact::side_of_b;
  for (int b = 0; b < 2; ++b) {
    const std::uint32_t body = bodies[b];
    const Polygon& shape = *world_.shapes[p_.shape[body]].polygon;
    const shapes::Quatd& q = p_.orientation[body];
    const Polygon::Part& part = shape.parts[b == 0 ? side.part_a : side.part_b];
    c.body[b][i] = body;
    c.quat_w[b][i] = q.w;
    c.quat_z[b][i] = q.z;
    c.scale[b][i] = p_.size[body].x;
    c.inertia[b][i] = p_.inertia[body].z;
    c.core[b][i] = shape.inscribed_radius;
    if (of_b == (b == 1))
      c.side[i] = part.side_rows[side.at.side].before;
    else
      c.corner[i] = part.corner_rows[side.at.corner].corner;
  }
  c.self_is_b[i] = of_b ? 1 : 0;
  lanes.record[i] = static_cast<std::uint32_t>(k);
}

// The contacts of the pair in place r. False: a search must find them.
bool PolygonPass::add(const Bin& bin, std::size_t r, Lanes& lanes) const {
  const std::size_t k = bin.records[r], first = lanes.count;
  if (!bin.regions) {
    const SideContact at = contact::side_in(&c_.cache[k], false);
    if (at.kind == SideContact::none) return false;
    lanes.place[first] = static_cast<std::uint32_t>(r);
    fill(lanes.count++, k, {at, 0, 0}, lanes);
  } else {
    if (!(travels(world_, bin, r) < c_.apart_until[k + 1])) return false;
    for (std::size_t slot = 0; slot < contact::max_regions; ++slot) {
      if (c_.touching[k + slot] == 0) continue;
      const PartSide side = side_of(c_.cache[k + slot]);
      if (side.at.kind == SideContact::none) {
        lanes.count = first;
        return false;
      }
      lanes.place[lanes.count] = static_cast<std::uint32_t>(r + slot);
      fill(lanes.count++, k + slot, side, lanes);
    }
    if (lanes.count == first) return false;
  }
  lanes.pair[lanes.pairs++] = {static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(first),
                               static_cast<std::uint32_t>(lanes.count)};
  return true;
}

// What is read and written of the pair in place r, fetched before it is needed.
void PolygonPass::fetch(const Bin& bin, std::size_t r) const {
  for (const std::uint32_t body : {bin.a_index[r], bin.b_index[r]}) {
    __builtin_prefetch(&p_.orientation[body]);
    __builtin_prefetch(&p_.inertia[body]);
    __builtin_prefetch(&p_.motion[body].velocity);
    __builtin_prefetch(&p_.motion[body].spin);
  }
  const std::size_t k = bin.records[r];
  for (std::size_t slot = 0; slot < (bin.regions ? contact::max_regions : 1); ++slot) {
    if (c_.touching[k + slot] == 0) continue;
    __builtin_prefetch(&c_.cache[k + slot]);
    __builtin_prefetch(&c_.centre[k + slot], 1);
    __builtin_prefetch(&c_.history_of(k + slot), 1);
    __builtin_prefetch(&c_.memory[(k + slot) * c_.words], 1);
    __builtin_prefetch(&c_.slot[c_.slot_of(k + slot)], 1);
    __builtin_prefetch(&c_.slot[c_.slot_of_b(k + slot)], 1);
  }
}

// Whether all lanes of a pair were found, each nearer to its own place of the step before than to that of another: then
// regions.h gives each the record that it has.
bool PolygonPass::continues(const Lanes& lanes, std::size_t first, std::size_t last, std::uint32_t found) const {
  const PolygonChunk& c = lanes.chunk;
  for (std::size_t i = first; i < last; ++i) {
    if ((found >> i & 1) == 0) return false;
    if (last - first == 1) return true;
    const auto square = [&](std::size_t j) {
      const Vec3d& before = c_.centre[lanes.record[j]];
      const double x = c.centre[0][i] - before.x, y = c.centre[1][i] - before.y;
      return x * x + y * y;
    };
    const double own = square(i);
    for (std::size_t j = first; j < last; ++j)
      if (j != i && !(own < square(j))) return false;
  }
  return true;
}

// Answers the contacts gathered so far; `left` pairs are left over by now, returns how many are then.
std::size_t PolygonPass::flush(const Bin& bin, Lanes& lanes, std::uint32_t* rest, std::size_t left, Scratch& s,
                               Tally& t) const {
  PolygonChunk& c = lanes.chunk;
  LawChunk& l = s.law;
  if (lanes.count == 0) return left;
  for (std::size_t i = lanes.count; i % PolygonChunk::widest != 0; ++i) {
    const std::size_t last = lanes.count - 1, k = lanes.record[last];
    fill(i, k, bin.regions ? side_of(c_.cache[k]) : PartSide{contact::side_in(&c_.cache[k], false), 0, 0}, lanes);
  }
  const std::uint32_t found = set_.polygon_sides(p_.motion.data(), lattice_, c, lanes.count, bin.regions, l);
  std::size_t n = 0;
  for (std::size_t p = 0; p < lanes.pairs; ++p) {
    const Lanes::Pair& pair = lanes.pair[p];
    if (!continues(lanes, pair.first, pair.last, found)) {
      rest[left++] = pair.place;
      continue;
    }
    for (std::size_t i = pair.first; i < pair.last; ++i, ++n) {
      const std::size_t k = lanes.record[i];
      if (n != i) move_lane(i, n, l);
      s.arm_a[n] = {c.arm_a[0][i], c.arm_a[1][i], 0};
      s.arm_b[n] = {c.arm_b[0][i], c.arm_b[1][i], 0};
      s.gain[n] = c.gain[i];
      s.screw[n] = 0;
      c_.centre[k] = s.arm_a[n];
      load_pair(n, bin.pair[lanes.place[i]], s);
      const Vec3d& before = c_.history_of(k).normal;
      if (!bin.regions && before.x * c.outward[0][i] + before.y * c.outward[1][i] < -0.9)
        s.through.push_back(static_cast<std::uint32_t>(k));
      begin(k, s);
      s.record[n] = static_cast<std::uint32_t>(k);
    }
  }
  t.touching += n;
  s.gained = true;
  if (n > 0) finish(n, true, s);
  lanes.count = lanes.pairs = 0;
  return left;
}

std::size_t PolygonPass::answer(const Bin& bin, const std::uint32_t* places, std::size_t count, std::uint32_t* rest,
                                Scratch& s, Tally& t) const {
  static thread_local Lanes lanes;
  lanes.count = lanes.pairs = 0;
  std::size_t left = 0;
  if (far_)
    for (std::size_t p = 0; p < count; ++p) fetch(bin, places[p]);
  for (std::size_t p = 0; p < count; ++p) {
    const std::uint32_t r = places[p];
    if (lanes.count + (bin.regions ? contact::max_regions : 1) > chunk_size) left = flush(bin, lanes, rest, left, s, t);
    if (!add(bin, r, lanes)) rest[left++] = r;
  }
  return flush(bin, lanes, rest, left, s, t);
}

}  // namespace dem
