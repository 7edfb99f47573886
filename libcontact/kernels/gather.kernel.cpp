// Four records at a time are turned into lanes and back (rows.h). Arithmetic is lane by lane: every set gives the same
// bits. Index lists are padded to a multiple of four by the caller (any valid record will do).
#include "libcontact/kernels/gather.h"

#include "libcontact/kernels/rows.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

[[gnu::always_inline]] inline Row& lane_of(Lane& lane, std::size_t i) { return *reinterpret_cast<Row*>(&lane.v[i]); }
[[gnu::always_inline]] inline const Row& lane_of(const Lane& lane, std::size_t i) {
  return *reinterpret_cast<const Row*>(&lane.v[i]);
}

[[gnu::always_inline]] inline Rows lanes(const Lane3& v, const Lane& w, std::size_t i) {
  return {lane_of(v.x, i), lane_of(v.y, i), lane_of(v.z, i), lane_of(w, i)};
}
[[gnu::always_inline]] inline void put(Lane3& v, std::size_t i, const Row& x, const Row& y, const Row& z) {
  lane_of(v.x, i) = x;
  lane_of(v.y, i) = y;
  lane_of(v.z, i) = z;
}

template <bool periodic>
[[gnu::always_inline]] inline void clearance(const Motion* motion, const Index* a, const Index* b, std::size_t count,
                                             [[maybe_unused]] const Lattice* lattice, Lane& out) {
  for (std::size_t i = 0; i < count; i += 4) {
    const Rows pa = Rows::load(motion, sizeof(Motion), a + i, 0).turned();
    const Rows pb = Rows::load(motion, sizeof(Motion), b + i, 0).turned();
    Row x = pb.a - pa.a, y = pb.b - pa.b, z = pb.c - pa.c;
    if constexpr (periodic) to_nearest(*lattice, x, y, z);
    const Row reach = pa.d + pb.d;
    lane_of(out, i) = (x * x + y * y + z * z) - reach * reach;
  }
}

template <bool periodic>
[[gnu::always_inline]] inline void gather(const Motion* motion, const Index* a, const Index* b, std::size_t count,
                                          [[maybe_unused]] const Lattice* lattice, SphereChunk& s, LawChunk& c) {
  for (std::size_t i = 0; i < count; i += 4) {
    const Rows pa = Rows::load(motion, sizeof(Motion), a + i, 0).turned();
    const Rows pb = Rows::load(motion, sizeof(Motion), b + i, 0).turned();
    Row x = pb.a - pa.a, y = pb.b - pa.b, z = pb.c - pa.c;
    if constexpr (periodic) to_nearest(*lattice, x, y, z);
    put(s.offset, i, x, y, z);
    lane_of(s.radius_a, i) = pa.d;
    lane_of(s.radius_b, i) = pb.d;
    const Rows va = Rows::load(motion, sizeof(Motion), a + i, 1).turned();
    const Rows vb = Rows::load(motion, sizeof(Motion), b + i, 1).turned();
    Row vx = va.a - vb.a, vy = va.b - vb.b, vz = va.c - vb.c;
    if constexpr (periodic) leave_flow(*lattice, x, y, z, vx, vy, vz);
    put(c.velocity, i, vx, vy, vz);
    lane_of(s.inverse_mass, i) = va.d + vb.d;
    const Rows wa = Rows::load(motion, sizeof(Motion), a + i, 2).turned();
    const Rows wb = Rows::load(motion, sizeof(Motion), b + i, 2).turned();
    put(s.spin_a, i, wa.a, wa.b, wa.c);
    put(s.spin_b, i, wb.a, wb.b, wb.c);
  }
}

}  // namespace

void sphere_clearance(const Motion* motion, const Index* a, const Index* b, std::size_t count, Lane& out) {
  clearance<false>(motion, a, b, count, nullptr, out);
}
void periodic_clearance(const Motion* motion, const Index* a, const Index* b, std::size_t count, const Lattice& lattice,
                        Lane& out) {
  clearance<true>(motion, a, b, count, &lattice, out);
}

void gather_spheres(const Motion* motion, const Index* a, const Index* b, std::size_t count, SphereChunk& s,
                    LawChunk& c) {
  gather<false>(motion, a, b, count, nullptr, s, c);
}
void periodic_gather(const Motion* motion, const Index* a, const Index* b, std::size_t count, const Lattice& lattice,
                     SphereChunk& s, LawChunk& c) {
  gather<true>(motion, a, b, count, &lattice, s, c);
}

void load_history(const History* history, const Index* record, std::size_t count, LawChunk& c) {
  for (std::size_t i = 0; i < count; i += 4) {
    const Rows p = Rows::load(history, sizeof(History), record + i, 0).turned();
    const Rows q = Rows::load(history, sizeof(History), record + i, 1).turned();
    put(c.history_force, i, p.a, p.b, p.c);
    lane_of(c.history_overlap, i) = p.d;
    put(c.history_normal, i, q.a, q.b, q.c);
    lane_of(c.history_twist, i) = q.d;
  }
}

void store_history(const LawChunk& c, const Index* record, std::size_t count, History* history) {
  for (std::size_t i = 0; i < count; i += 4) {
    lanes(c.history_force, c.history_overlap, i).turned().store(history, sizeof(History), record + i, 0, count - i);
    lanes(c.history_normal, c.history_twist, i).turned().store(history, sizeof(History), record + i, 1, count - i);
  }
}

void store_slots(const LawChunk& c, const Index* record, std::size_t count, Slot* slot) {
  for (std::size_t i = 0; i < count; i += 4) {
    lanes(c.force, c.lever_a, i).turned().store(slot, sizeof(Slot), record + i, 0, count - i);
    lanes(c.couple, c.lever_b, i).turned().store(slot, sizeof(Slot), record + i, 1, count - i);
  }
}

void store_double(const LawChunk& c, const Index* record, std::size_t count, Slot* slot) {
  const Row no{}, one = no + 1;
  for (std::size_t i = 0; i < count; i += 4) {
    const auto store = [&](const Lane3& v, const Row& lever, std::size_t row) {
      const Rows rows{lane_of(v.x, i), lane_of(v.y, i), lane_of(v.z, i), lever};
      rows.turned().store(slot, 2 * sizeof(Slot), record + i, row, count - i);
    };
    store(c.force, one, 0);
    store(c.couple, no, 1);
    store(c.force, no, 2);
    store(c.couple_b, one, 3);
  }
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
