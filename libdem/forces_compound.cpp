#include "libdem/forces_compound.h"

#include <algorithm>
#include <numbers>

#include "libdem/contact_share.h"
#include "libdem/parts.h"

namespace dem {

// Normal and centres as seen from body a = key.a, whatever the order of the kinds of the parts.
struct CompoundPass::Meet {
  std::uint32_t record = 0;
  std::uint32_t a = 0, b = 0;  // bodies; b: wall
  std::uint32_t part_a = 0, part_b = 0;
  bool wall = false, touches = false;
  bool holds = false;            // on, across a gap
  Mat3d rotation_a, rotation_b;  // of the bodies
  PartBody of_a, of_b;           // of_b.centre: relative to b's centre
  Vec3d offset;                  // b's centre less a's
  Vec3d normal;                  // a to b
  contact::Patch patch;          // centre relative to a's centre
  PartContact contact;
};

struct CompoundPass::Working {
  std::vector<Meet> meets;
  std::vector<std::pair<std::size_t, std::size_t>> groups;  // first, last of `meets`
  std::vector<std::size_t> touching;
  std::vector<PartContact> contacts;
  std::vector<double> depth;
  std::vector<contact::History> histories;
};

void CompoundPass::place(const Group& group, Working& w) const {
  const Key& key = c_.key[group.first];
  Meet m;
  m.wall = key.b >= wall_base;
  m.a = c_.index_a[group.first];
  m.b = c_.index_b[group.first];
  const Vec3d& x = p_.motion[m.a].position;
  m.rotation_a = shapes::rotation_matrix(p_.orientation[m.a]);
  if (m.wall) {
    m.of_b.body = walls_[m.b].body;
    m.of_b.radius = 0;
    m.offset = world_.walls[m.b].position - x;
    m.rotation_b = m.of_b.body.rotation;
  } else {
    m.rotation_b = is_round(p_.kind[m.b]) ? Mat3d::identity() : shapes::rotation_matrix(p_.orientation[m.b]);
    m.offset = p_.motion[m.b].position - x;
    if (lattice_ != nullptr) m.offset = lattice_->nearest(m.offset);
  }
  if (is_round(p_.kind[m.a])) m.rotation_a = Mat3d::identity();
  const std::size_t first = w.meets.size();
  for (std::uint32_t k = group.first; k < group.first + group.count; ++k) {
    m.record = k;
    m.part_a = c_.key[k].part_a;
    m.part_b = c_.key[k].part;
    m.of_a = part_body(world_, m.a, m.part_a, m.rotation_a);
    if (m.wall)
      m.of_b.body.part = m.part_b;
    else
      m.of_b = part_body(world_, m.b, m.part_b, m.rotation_b);
    w.meets.push_back(m);
  }
  w.groups.emplace_back(first, w.meets.size());
}

void CompoundPass::query(Working& w, Scratch& s, Tally& t) const {
  contact::Options wanted = wanted_;
  wanted.measure = false;  // parts are weighed by the patches under their faces
  for (std::size_t q = 0; q < c_.part_queries.size(); ++q) {
    std::size_t n = 0;
    std::size_t of[chunk_size];
    const auto flush = [&] {
      c_.part_queries[q].query(n, s.a, s.b, s.offset, wanted, s.cache, s.answer);
      for (std::size_t r = 0; r < n; ++r) {
        Meet& m = w.meets[of[r]];
        const contact::Contact& found = s.answer[r];
        c_.cache[m.record] = s.cache[r];
        const bool refused = found.status == contact::Status::refused;
        if (refused || found.status == contact::Status::not_converged) ++t.not_converged;
        if (found.gap_lower > 0 && found.iterations == 0 && !(found.gap_upper < infinity)) ++t.by_axis;
        m.touches = !refused && overlap(found);
        m.holds = !refused && !m.touches && may_hold(m.record);
        if (!m.touches && !m.holds) continue;
        if (!found.certified) ++t.uncertified;
        if (found.handed_over) ++t.handed_over;
        const bool swapped = m.of_b.body.kind < m.of_a.body.kind;
        const bool faces = m.of_a.body.kind == shapes::Kind::polyhedron;
        m.normal = swapped ? -found.normal : found.normal;
        m.patch = m.touches ? found.patch
                            : across_gap(c_.part_queries[q].query, faces, m.record, s.a[r], s.b[r], s.offset[r], found);
        m.patch.centre += swapped ? m.offset + m.of_b.centre : m.of_a.centre;
        m.contact = {};
        m.contact.overlap = -found.gap;
        m.contact.centre = m.patch.centre;
      }
      t.candidates += n;
      n = 0;
    };
    for (std::size_t i = 0; i < w.meets.size(); ++i) {
      const Meet& m = w.meets[i];
      if (c_.part_query[m.record] != q) continue;
      of[n] = i;
      s.offset[n] = m.offset + m.of_b.centre - m.of_a.centre;
      // The plane's own origin may be far away: its foot below the part serves as well and keeps every digit.
      if (m.wall && is_half_space(m.of_b.body.kind))
        s.offset[n] = walls_[m.b].normal * dot(walls_[m.b].normal, s.offset[n]);
      const bool swapped = m.of_b.body.kind < m.of_a.body.kind;
      s.a[n] = swapped ? m.of_b.body : m.of_a.body;
      s.b[n] = swapped ? m.of_a.body : m.of_b.body;
      if (swapped) s.offset[n] = -s.offset[n];
      s.cache[n] = c_.cache[m.record];
      if (++n == chunk_size) flush();
    }
    if (n > 0) flush();
  }
}

// How deep the place in which two contacts join directly lies under the surface of the other body, by the normal of
// each: the depth of the contact less what the joint's farthest point stays behind the part's.
double CompoundPass::joined_depth(const Meet& i, const Meet& j) const {
  const double alike = std::clamp(10 * dot(i.normal, j.normal) - 9, 0.0, 1.0);
  if (!(alike > 0) || (i.wall && i.part_b != j.part_b)) return 0;
  const auto joint_of = [&](std::uint32_t body, std::uint32_t p, std::uint32_t q) {
    return p == q ? nullptr : compound_of(world_, body)->joint(p, q);
  };
  const auto *joint_a = joint_of(i.a, i.part_a, j.part_a),
             *joint_b = i.wall ? nullptr : joint_of(i.b, i.part_b, j.part_b);
  const bool apart_in_a = i.part_a != j.part_a && joint_a == nullptr;
  if (apart_in_a || (i.part_b != j.part_b && joint_b == nullptr)) return 0;
  double depth = std::min(i.contact.overlap, j.contact.overlap);
  for (const Meet* m : {&i, &j}) {
    double behind = 0;
    const auto add = [&](std::uint32_t body, const shapes::Compound::Joint* joint, const PartBody& part,
                         const Mat3d& rotation, const Vec3d& n) {
      if (joint == nullptr) return;
      const double reach = shapes::extent(*compound_of(world_, body), *joint, transposed_times(rotation, n));
      behind += dot(n, part.centre) + part_extent(part.body, n) - reach * p_.size[body].x;
    };
    add(m->a, joint_a, m->of_a, m->rotation_a, m->normal);
    add(m->b, joint_b, m->of_b, m->rotation_b, -m->normal);
    depth = std::min(depth, m->contact.overlap - behind);
  }
  if (!i.wall && (joint_a == nullptr) != (joint_b == nullptr))
    depth = std::min(depth, sideways_depth(i, j, joint_a, joint_b));
  return std::max(0.0, depth) * alike;
}

// The two contacts may lie on the same face of the other body and yet the joint beside it: how far the joint reaches
// back over the other part, along the way from the contacts to the joint.
double CompoundPass::sideways_depth(const Meet& i, const Meet& j, const shapes::Compound::Joint* joint_a,
                                    const shapes::Compound::Joint* joint_b) const {
  const bool of_a = joint_a != nullptr;
  const std::uint32_t body = of_a ? i.a : i.b;
  const Mat3d& rotation = of_a ? i.rotation_a : i.rotation_b;
  const shapes::Compound::Joint& joint = of_a ? *joint_a : *joint_b;
  const double scale = p_.size[body].x;
  const Vec3d from = of_a ? Vec3d{} : i.offset;  // the body's centre
  const Vec3d middle = from + rotation * (joint.middle * scale);
  Vec3d way = middle - 0.5 * (i.contact.centre + j.contact.centre);
  way -= dot(way, i.normal) * i.normal;
  const double length = norm(way);
  if (!(length > i.contact.overlap)) return i.contact.overlap;
  way *= 1 / length;
  const PartBody& other = of_a ? i.of_b : i.of_a;
  const Vec3d other_centre = of_a ? i.offset + i.of_b.centre : i.of_a.centre;
  const double back = shapes::extent(*compound_of(world_, body), joint, transposed_times(rotation, -way)) * scale;
  return dot(way, other_centre - from) + part_extent(other.body, way) + back;
}

// Whether the surface that a contact is with is that of the body, looked at from the point y before it, at a distance
// of the overlap δ: a neighbour that y lies in hides it. A point (no patch) is besides one of the body only where no
// neighbour is nearer to y: an edge inside a flat side is none. Both are continuous on round parts.
double CompoundPass::cover(const Meet& m) const {
  const double depth = m.contact.overlap;
  const bool point = !(m.patch.weight > 0);
  const Vec3d ahead = m.normal * depth;
  // A patch's centre is midway in the overlap; a point's too, and half of that is left to the surface.
  const double way = point ? 1.5 : 1;
  const auto of = [&](std::uint32_t body, std::uint32_t part, const Mat3d& rotation, const Vec3d& before) {
    const shapes::Compound* c = compound_of(world_, body);
    if (c == nullptr) return 1.0;
    const double scale = p_.size[body].x, rounding = 1e-9 + 64 * contact::epsilon * (c->circumradius * scale / depth);
    const auto flat = [&](std::uint32_t k) { return c->parts[k].kind == shapes::Compound::PartKind::polyhedron; };
    const Vec3d x = transposed_times(rotation, before) * (1 / scale);
    double least = 1;
    for (const std::uint32_t k : c->parts[part].neighbours) {
      const double away = part_distance(c->parts[k], x) * scale / depth;
      const double seen = !point ? 1 + 2 * away : flat(part) && flat(k) ? 2 - (1 - away) / rounding : away;
      least = std::min(least, std::clamp(seen, 0.0, 1.0));
    }
    return least;
  };
  const double of_a = of(m.a, m.part_a, m.rotation_a, m.patch.centre + way * ahead);
  return m.wall ? of_a : std::min(of_a, of(m.b, m.part_b, m.rotation_b, m.patch.centre - way * ahead - m.offset));
}

void CompoundPass::weigh(std::size_t first, std::size_t last, Working& w) const {
  w.touching.clear();
  for (std::size_t i = first; i < last; ++i)
    if (w.meets[i].touches) w.touching.push_back(i);
  const std::size_t n = w.touching.size();
  w.contacts.clear();
  for (const std::size_t i : w.touching) {
    Meet& m = w.meets[i];
    const double depth = m.contact.overlap, ra = m.of_a.radius, rb = m.of_b.radius;
    const auto round = [](const PartBody& p) {
      return p.body.kind == shapes::Kind::sphere || p.body.kind == shapes::Kind::ellipsoid;
    };
    m.contact.weight = m.patch.weight;
    if (!(m.contact.weight > 0))  // a point: the cap of a sphere, or next to nothing
      m.contact.weight =
          depth * depth *
          (round(m.of_a) || round(m.of_b) ? std::numbers::pi * (m.wall ? ra : ra * rb / (ra + rb)) : depth);
    m.contact.cover = cover(m);
    w.contacts.push_back(m.contact);
  }
  w.depth.assign(n * n, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      w.depth[i * n + j] = w.depth[j * n + i] = joined_depth(w.meets[w.touching[i]], w.meets[w.touching[j]]);
  share_stiffness(w.contacts, w.depth);
  w.histories.clear();
  for (std::size_t i = 0; i < n; ++i) {
    Meet& m = w.meets[w.touching[i]];
    m.contact = w.contacts[i];
    w.histories.push_back(c_.history_of(m.record));
  }
  if (n < 2) return;
  for (std::size_t i = 0; i < n && staged_; ++i) pool_memory(i, w);
  pool_histories(w.contacts, w.depth, w.histories);
  for (std::size_t i = 0; i < n; ++i) c_.history_of(w.meets[w.touching[i]].record) = w.histories[i];
}

// What a contact that is new finds in the memory of the normal law and of cohesion is that of the deepest with which it
// is one: bodies do not yield afresh as they pass from part to part. Both are of lengths, whatever the share.
void CompoundPass::pool_memory(std::size_t i, const Working& w) const {
  const std::size_t n = w.touching.size(), record = w.meets[w.touching[i]].record;
  if (c_.touching[record] != 0 || !(w.contacts[i].share > 0)) return;
  const std::size_t none = c_.count();
  std::size_t from = none;
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t other = w.meets[w.touching[j]].record;
    if (i == j || c_.touching[other] == 0 || !(w.depth[i * n + j] > 0.5)) continue;
    if (from == none || c_.history_of(other).overlap > c_.history_of(from).overlap) from = other;
  }
  if (from == none) return;
  const auto copy = [&](std::size_t first, std::size_t last) {
    const auto at = [&](std::size_t k) {
      return c_.memory.begin() + static_cast<std::ptrdiff_t>(k * c_.words + first);
    };
    std::copy_n(at(from), last - first, at(record));
  };
  const contact::LawModel& law = world_.law;
  copy(law.memory_normal, law.memory_tangential);
  copy(law.memory_cohesion, law.words);
}

void CompoundPass::act(Working& w, Scratch& s, Tally& t) const {
  LawChunk& l = s.law;
  const auto materials = static_cast<std::uint32_t>(world_.materials.size());
  std::size_t n = 0;
  s.gained = false;
  for (const Meet& m : w.meets) {
    // Across a gap a contact keeps the share that it parted with.
    const double share = m.touches ? m.contact.share : m.holds ? c_.share[m.record] : 0;
    if (!(share > 0)) {
      forget(m.record, s);
      continue;
    }
    const std::uint32_t material_b = m.wall ? world_.walls[m.b].material : p_.material[m.b];
    s.pair[n] = ~std::uint32_t(0);
    load_pair(n, p_.material[m.a] * materials + material_b, s);
    s.pair[n] = ~std::uint32_t(0);  // the lane holds a share of it
    gather(m.record, n,
           {m.a, m.b, m.wall, m.touches ? m.contact.common_overlap : m.contact.overlap, m.normal, m.patch.centre,
            m.patch.spread, m.offset, m.rotation_a, m.rotation_b, m.of_a.radius, m.of_b.radius,
            m.touches ? m.contact.common_centre : m.patch.centre},
           s);
    apply_map(m.record, n, m.of_a.body, m.of_b.body, m.normal, {}, s);
    // Springs and dashpots of a share of the contact: the dashpot goes with sqrt(stiffness · mass).
    contact::each_extensive_parameter(l.pair, [&](contact::kernels::Lane& lane) { lane[n] *= share; });
    l.pair.wetting[n] *= share;  // what the pull of a liquid goes with
    l.mass_eff[n] *= share;
    c_.share[m.record] = share;
    begin(m.record, s);
    s.record[n] = m.record;
    ++t.touching;
    if (++n == chunk_size) {
      finish(n, true, s);
      n = 0;
    }
  }
  if (n > 0) finish(n, true, s);
}

Tally CompoundPass::answer(std::size_t first, std::size_t last, Scratch& s) const {
  static thread_local Working w;
  w.meets.clear();
  w.groups.clear();
  for (std::size_t g = first; g < last; ++g) place(c_.groups[g], w);
  Tally t;
  query(w, s, t);
  for (const auto& [from, to] : w.groups) weigh(from, to, w);
  act(w, s, t);
  return t;
}

}  // namespace dem
