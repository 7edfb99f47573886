// The state as bytes: what a checkpoint holds. One list of members, read and written by the same code.
#include <bit>
#include <cstring>

#include "libdem/broad_phase/part_candidates.h"
#include "libdem/world.h"

namespace dem {
namespace {

// Small values are put together into pieces.
class Writer {
 public:
  explicit Writer(const Sink& sink) : sink_(sink) { held_.reserve(piece); }
  template <class T>
  void value(const T& v) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(&v, sizeof v);
  }
  template <class T>
  void list(const std::vector<T>& v) {
    value(static_cast<std::uint64_t>(v.size()));
    put(v.data(), v.size() * sizeof(T));
  }
  template <class T>
  void items(const T* v, std::size_t count) {
    put(v, count * sizeof(T));
  }
  void flush() {
    sink_(held_);
    held_.clear();
  }

 private:
  static constexpr std::size_t piece = 1 << 16;
  void put(const void* from, std::size_t size) {
    const std::span bytes(static_cast<const std::uint8_t*>(from), size);
    if (held_.size() + size > piece) flush();
    if (size > piece)
      sink_(bytes);
    else
      held_.insert(held_.end(), bytes.begin(), bytes.end());
  }
  const Sink& sink_;
  std::vector<std::uint8_t> held_;
};

class Reader {
 public:
  explicit Reader(const std::vector<std::uint8_t>& b) : bytes_(b) {}
  template <class T>
  void value(T& v) {
    need(sizeof v);
    std::memcpy(&v, bytes_.data() + at_, sizeof v);
    at_ += sizeof v;
  }
  template <class T>
  void list(std::vector<T>& v) {
    std::uint64_t n = 0;
    value(n);
    if (n > (bytes_.size() - at_) / sizeof(T)) throw RunError("checkpoint: shorter than its own lists");
    v.resize(n);
    if (n > 0) std::memcpy(v.data(), bytes_.data() + at_, n * sizeof(T));
    at_ += n * sizeof(T);
  }
  void done() const {
    if (at_ != bytes_.size()) throw RunError("checkpoint: longer than this scene's state");
  }

 private:
  void need(std::size_t n) const {
    if (bytes_.size() - at_ < n) throw RunError("checkpoint: shorter than this scene's state");
  }
  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
};

// A touching contact as it is kept.
struct Kept {
  Key key;
  std::uint32_t a, b;
  contact::History history;
  Vec3d force;
  Vec3d centre;
  double share;
};

struct WallState {
  Vec3d position;
  Quatd orientation;
  Vec3d velocity, spin, force, torque;
  std::array<Accumulator, 3> impulse;
  Accumulator work;
  double resistance;
  Vec3d reference;  // events move these four
  Quatd reference_orientation;
  double start, stop;
  std::uint64_t present, unchecked;
};

template <class Archive, class W>
void particles(Archive& a, W& world) {
  auto& p = world.particles;
  a.value(world.step);
  a.value(world.next_id);
  a.value(world.time_step.dt);
  a.value(world.tightest_limit);
  a.value(world.counters);
  a.value(world.balance);
  a.value(world.drag_force);
  a.list(world.discharge);
  std::remove_reference_t<decltype(p)>::each_array(p, [&](auto& array) { a.list(array); });
  auto& cell = world.cell;
  a.value(cell.lower);
  a.value(cell.lattice);
  a.value(cell.virial);
  a.value(cell.work);
  for (auto& o : world.outlets) {
    a.value(o.count);
    a.value(o.mass);
    a.list(o.by_species);
    a.value(o.tries);
    a.value(o.waits);
  }
  a.value(world.scene.gravity);
  a.list(world.pairs);
  for (auto& r : world.rains) {
    a.value(r.active);
    a.value(r.count);
    a.value(r.tries);
    a.value(r.waits);
    a.value(r.mass);
    a.value(r.since);
    a.value(r.count_before);
    a.value(r.mass_before);
  }
  for (auto& e : world.events) {
    a.value(e.met);
    a.value(e.done);
  }
  a.value(world.ended_by);
}

}  // namespace

namespace {

void write(Writer& w, const World& world) {
  particles(w, world);
  for (const Wall& x : world.walls) {
    w.value(WallState{x.position, x.orientation, x.velocity, x.spin, x.force, x.torque, x.load.impulse, x.load.work,
                      x.resistance, x.reference, x.reference_orientation, x.motion.start, x.motion.stop,
                      x.present ? 1u : 0u, x.unchecked ? 1u : 0u});
    w.list(x.load.map);
    w.list(x.load.squares);
  }
  const Contacts& c = world.contacts;
  const auto each_touching = [&](auto visit) {
    for (std::size_t k = 0; k < c.count(); ++k)
      if (c.touching[k] != 0) visit(k);
  };
  std::uint64_t count = 0;
  each_touching([&](std::size_t) { ++count; });
  w.value(count);
  each_touching([&](std::size_t k) {
    w.value(Kept{c.key[k], c.index_a[k], c.index_b[k], c.history_of(k), c.slot[c.slot_of(k)].force,
                 c.centre.empty() ? Vec3d{} : c.centre[k], c.share.empty() ? 1 : c.share[k]});
  });
  w.value(static_cast<std::uint64_t>(count * c.words));
  each_touching([&](std::size_t k) { w.items(c.memory.data() + k * c.words, c.words); });
  w.value(c.ledger.empty() ? std::uint64_t(0) : count);
  if (!c.ledger.empty()) each_touching([&](std::size_t k) { w.value(c.ledger[k]); });
}

}  // namespace

void save_state(const World& world, const Sink& sink) {
  Writer w(sink);
  write(w, world);
  w.flush();
}

std::vector<std::uint8_t> save_state(const World& world) {
  std::vector<std::uint8_t> bytes;
  save_state(world,
             [&](std::span<const std::uint8_t> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); });
  return bytes;
}

void load_state(World& world, const std::vector<std::uint8_t>& bytes) {
  Reader r(bytes);
  particles(r, world);
  for (Wall& x : world.walls) {
    WallState s;
    r.value(s);
    x.position = s.position;
    x.orientation = s.orientation;
    x.velocity = s.velocity;
    x.spin = s.spin;
    x.force = s.force;
    x.torque = s.torque;
    x.load.impulse = s.impulse;
    x.load.work = s.work;
    x.resistance = s.resistance;
    x.reference = s.reference;
    x.reference_orientation = s.reference_orientation;
    x.motion.start = s.start;
    x.motion.stop = s.stop;
    x.present = s.present != 0;
    x.unchecked = s.unchecked != 0;
    const std::size_t triangles = x.load.map.size();
    r.list(x.load.map);
    r.list(x.load.squares);
    const bool on_squares = x.motion.pressure_map && !x.mesh;
    if (x.load.map.size() != (on_squares ? x.load.squares.size() : triangles))
      throw RunError("checkpoint: another pressure map than this scene's");
  }
  std::vector<Kept> kept;
  r.list(kept);
  std::vector<double> memory;
  std::vector<contact::Ledger> ledger;
  r.list(memory);
  r.list(ledger);
  r.done();
  // The touching contacts alone are a list that output can read; the next step makes the full one.
  Contacts& c = world.contacts = {};
  const bool parts = has_compounds(world);
  for (const Kept& k : kept) {
    c.list(k.key, k.a, k.b, k.history, k.force);
    c.centre.push_back(k.centre);
    if (parts) c.share.push_back(k.share);
  }
  c.words = kept.empty() ? 0 : memory.size() / kept.size();
  c.memory = std::move(memory);
  c.ledger = std::move(ledger);
}

}  // namespace dem
