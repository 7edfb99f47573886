#include "libdem/forecast/memory.h"

#include <sys/resource.h>
#include <unistd.h>

namespace dem::forecast {
namespace {

template <class T>
double bytes(const std::vector<T>& v) {
  return static_cast<double>(v.capacity() * sizeof(T));
}

// One entry of every list of Particles.
constexpr double body_size = sizeof(std::uint64_t) + 2 * sizeof(std::uint32_t) + sizeof(shapes::Kind) + sizeof(Motion) +
                             sizeof(Quatd) + 6 * sizeof(Vec3d) + sizeof(double);
// Lists that grow by doubling hold half as much again, on average.
constexpr double growth = 1.5;

// A candidate in Contacts: its record, its place in a bin and in the lists of its two bodies. Of pairs of round bodies
// those that have met have a seat: about half of them.
constexpr double record_size = sizeof(Key) + 3 * sizeof(std::uint32_t) + 1;
constexpr double met_size = 0.5 * (sizeof(contact::History) + sizeof(Slot) + growth * 5 * sizeof(std::uint32_t));
constexpr double bin_size = growth * 4 * sizeof(std::uint32_t);
constexpr double entry_size = 2 * sizeof(std::uint32_t);  // incidence and active
constexpr double general_size = sizeof(Vec3d) + sizeof(contact::Cache) + sizeof(contact::History) + 2 * sizeof(Slot);
constexpr double row_size = sizeof(Key) + 2 * sizeof(std::uint32_t);  // while the list is made

double geometry_of(const World& world) {
  double sum = 0;
  for (const ShapeEntry& s : world.shapes)
    for (const shapes::Polyhedron* p : {s.polyhedron.get(), s.drawing.get()})
      if (p) sum += static_cast<double>(sizeof *p) + bytes(p->vertices) + bytes(p->faces) + bytes(p->face_vertices);
  for (const ShapeEntry& s : world.shapes)
    if (s.potential) sum += static_cast<double>(sizeof *s.potential) + bytes(s.potential->planes);
  for (const ShapeEntry& s : world.shapes) {
    if (!s.compound) continue;
    sum += static_cast<double>(sizeof *s.compound) + bytes(s.compound->parts) + bytes(s.compound->joints);
    for (const auto& joint : s.compound->joints) sum += bytes(joint.points);
    for (const auto& part : s.compound->parts)
      if (part.solid)
        sum += static_cast<double>(sizeof *part.solid) + bytes(part.solid->vertices) + bytes(part.solid->faces) +
               bytes(part.solid->face_vertices);
  }
  for (const Wall& w : world.walls)
    if (w.mesh)
      sum += static_cast<double>(sizeof *w.mesh) + bytes(w.mesh->vertices) + bytes(w.mesh->triangles) +
             bytes(w.mesh->facets) + bytes(w.mesh->edges) + bytes(w.mesh->facet_borders);
  return sum;
}

}  // namespace

Bytes bytes_of(const World& world) {
  const Particles& p = world.particles;
  const Contacts& c = world.contacts;
  Bytes sum;
  sum.bodies = bytes(p.id) + bytes(p.shape) + bytes(p.kind) + bytes(p.material) + bytes(p.size) + bytes(p.motion) +
               bytes(p.orientation) + bytes(p.rotation) + bytes(p.angular_momentum) + bytes(p.inertia) + bytes(p.mass) +
               bytes(p.force) + bytes(p.torque) + bytes(c.reference) + bytes(c.allowance) + bytes(c.incidence_start) +
               bytes(c.active_count);
  sum.contacts = bytes(c.key) + bytes(c.index_a) + bytes(c.index_b) + bytes(c.seat) + bytes(c.history) +
                 bytes(c.memory) + bytes(c.ledger) + bytes(c.touching) + bytes(c.slot) + bytes(c.centre) +
                 bytes(c.cache) + bytes(c.incidence) + bytes(c.active) + bytes(c.wall_records) + bytes(c.groups) +
                 bytes(c.part_query) + bytes(c.share) + bytes(c.reference_orientation);
  for (const Bin& b : c.bins) {
    sum.contacts += bytes(b.records) + bytes(b.a_index) + bytes(b.b_index) + bytes(b.pair);
    for (const auto* list : {&b.met.record, &b.met.a, &b.met.b, &b.met.pair, &b.met.seat, &b.met.place})
      sum.contacts += bytes(*list);
  }
  sum.geometry = geometry_of(world);
  return sum;
}

Bytes bytes_of_packed(const World& world, double bodies, double records, double wall_records, bool round) {
  Bytes sum;
  // Lists of bodies are filled one by one, the last three beside them once per rebuild.
  sum.bodies = bodies * (growth * body_size + sizeof(Vec3d) + sizeof(double) + 2 * sizeof(std::uint32_t));
  const double own = record_size + (round ? met_size : general_size);
  const double total = bodies * records;
  sum.contacts = total * (own + bin_size) + bodies * (2 * records - wall_records) * entry_size +
                 bodies * wall_records * (growth * sizeof(std::uint32_t));
  // The new list, its rows and the old one stand side by side; a list of caches is made in any case.
  sum.rebuild = total * (own + row_size + (round ? static_cast<double>(sizeof(contact::Cache)) : 0)) +
                bodies * sizeof(std::uint32_t);
  sum.geometry = geometry_of(world);
  return sum;
}

double peak_of_process() {
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? 1024.0 * static_cast<double>(usage.ru_maxrss) : 0;
}

double memory_of_machine() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0 ? static_cast<double>(pages) * static_cast<double>(size) : 0;
}

}  // namespace dem::forecast
