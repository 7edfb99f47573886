#include "libcontact/dispatch.h"

#include <algorithm>
#include <array>
#include <new>
#include <tuple>

#include "libcontact/methods/list.h"
#include "libcontact/methods/method.h"

namespace contact {

namespace {

using shapes::Kind;
using shapes::kind_count;

struct Entry {
  MethodInfo info{};
  ChunkQuery run = nullptr, own_measure = nullptr;
};

template <class M, class A, class B>
void run_chunk(std::size_t n, const Body* a, const Body* b, const Vec3d* offset, const Options& options, Cache* cache,
               Contact* out) {
  if constexpr (AnswersChunks<M, A, B>)
    if (n > 1) return M::query_chunk(KindPair<A, B>{}, n, a, b, offset, options, cache, out);
  for (std::size_t i = 0; i < n; ++i) {
    // Constructed in place: an answer is 240 bytes, and copying it would cost as much as a pair of spheres.
    ::new (static_cast<void*>(out + i))
        Contact(M::query(placed<A>(a[i]), placed<B>(b[i]), offset[i], options, cache == nullptr ? nullptr : cache + i));
  }
}

template <class M, class A, class B>
void run_own_measure(std::size_t n, const Body* a, const Body* b, const Vec3d* offset, const Options& options,
                     Cache* cache, Contact* out) {
  run_chunk<M, A, B>(n, a, b, offset, options, cache, out);
  for (std::size_t i = 0; i < n; ++i) act_on_own_measure(out[i]);
}

// Calls visit.operator()<M, A, B>() for every method and pair of kinds A <= B that it answers.
template <class Visit>
constexpr void for_each_answer(Visit visit) {
  const auto per_pair = [&]<class M, std::size_t I, std::size_t J>() {
    using A = std::tuple_element_t<I, shapes::List>;
    using B = std::tuple_element_t<J, shapes::List>;
    if constexpr (I <= J && Answers<M, A, B>) visit.template operator()<M, A, B>();
  };
  const auto per_method = [&]<class M>() {
    [&]<std::size_t... IJ>(std::index_sequence<IJ...>) {
      (per_pair.template operator()<M, IJ / kind_count, IJ % kind_count>(), ...);
    }
    (std::make_index_sequence<kind_count * kind_count>{});
  };
  [&]<std::size_t... K>(std::index_sequence<K...>) {
    (per_method.template operator()<std::tuple_element_t<K, Methods>>(), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<Methods>>{});
}

constexpr std::size_t answer_count() {
  std::size_t n = 0;
  for_each_answer([&]<class M, class A, class B>() { ++n; });
  return n;
}

constexpr bool before(const MethodInfo& x, const MethodInfo& y) {
  if (x.a != y.a) return x.a < y.a;
  if (x.b != y.b) return x.b < y.b;
  if (x.cost_rank != y.cost_rank) return x.cost_rank < y.cost_rank;
  return x.name < y.name;
}

constexpr auto table = [] {
  std::array<Entry, answer_count()> entries{};
  std::size_t n = 0;
  for_each_answer([&]<class M, class A, class B>() {
    entries[n].info = {
        M::name,       M::cost_rank, shapes::kind_of<A>(), shapes::kind_of<B>(), always_certified<M, A, B>(),
        is_exact<M>(), M::remark};
    entries[n].run = &run_chunk<M, A, B>;
    if constexpr (is_exact<M>())
      entries[n].own_measure = entries[n].run;
    else
      entries[n].own_measure = &run_own_measure<M, A, B>;
    ++n;
  });
  std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) { return before(x.info, y.info); });
  return entries;
}();

constexpr auto catalogue = [] {
  std::array<MethodInfo, table.size()> infos{};
  for (std::size_t i = 0; i < table.size(); ++i) infos[i] = table[i].info;
  return infos;
}();

// One name must not stand for two methods of one pair.
constexpr bool names_are_unique() {
  for (std::size_t i = 0; i < catalogue.size(); ++i)
    for (std::size_t j = i + 1; j < catalogue.size(); ++j)
      if (catalogue[i].a == catalogue[j].a && catalogue[i].b == catalogue[j].b &&
          catalogue[i].name == catalogue[j].name)
        return false;
  return true;
}
static_assert(names_are_unique());

const Entry* entry_of(Kind a, Kind b, std::string_view method) {
  const Entry* cheapest = nullptr;
  for (const Entry& entry : table) {
    if (entry.info.a != a || entry.info.b != b) continue;
    if (method == entry.info.name) return &entry;
    if (method != "auto" || !entry.info.exact) continue;
    if (entry.info.certified) return &entry;
    if (cheapest == nullptr) cheapest = &entry;
  }
  return cheapest;
}

bool geometry_is_there(const Body& b) {
  if (b.kind == Kind::polyhedron || b.kind == Kind::rounded_polyhedron || b.kind == Kind::potential_particle ||
      b.kind == Kind::polygon)
    return b.geometry != nullptr;
  if (b.kind == Kind::mesh)
    return b.geometry != nullptr && b.part < static_cast<const shapes::Mesh*>(b.geometry)->facets.size();
  return true;
}

}  // namespace

double circumradius(const Body& b) {
  switch (b.kind) {
    case Kind::sphere:
    case Kind::disc:
      return b.size.x;
    case Kind::ellipsoid:
      return max_abs(b.size);
    case Kind::ellipse:
      return std::max(b.size.x, b.size.y);
    case Kind::polyhedron:
      return b.size.x * static_cast<const shapes::Polyhedron*>(b.geometry)->circumradius;
    case Kind::rounded_polyhedron:
      return b.size.x * static_cast<const shapes::Polyhedron*>(b.geometry)->circumradius + b.size.y;
    case Kind::potential_particle:
      return b.size.x * static_cast<const shapes::PotentialParticle*>(b.geometry)->circumradius;
    case Kind::polygon:
      return b.size.x * static_cast<const shapes::Polygon*>(b.geometry)->circumradius;
    case Kind::mesh: {
      double radius = 0;
      for (const Vec3d& v : static_cast<const shapes::Mesh*>(b.geometry)->vertices) radius = std::max(radius, norm(v));
      return b.size.x * radius;
    }
    default:
      return 0;
  }
}

const MethodInfo* methods_begin() { return catalogue.data(); }
const MethodInfo* methods_end() { return catalogue.data() + catalogue.size(); }

const MethodInfo* choose(Kind a, Kind b, std::string_view method) {
  const Entry* entry = entry_of(a, b, method);
  return entry == nullptr ? nullptr : &catalogue[static_cast<std::size_t>(entry - table.data())];
}

ChunkQuery find(Kind a, Kind b, std::string_view method) {
  const Entry* entry = entry_of(a, b, method);
  return entry == nullptr ? nullptr : entry->run;
}

ChunkQuery find_own_measure(Kind a, Kind b, std::string_view method) {
  const Entry* entry = entry_of(a, b, method);
  return entry == nullptr ? nullptr : entry->own_measure;
}

Contact query(const Body& a, const Body& b, const Vec3d& offset, const Options& options, std::string_view method) {
  if (!geometry_is_there(a) || !geometry_is_there(b)) return refused();
  Contact c = refused();
  const bool swapped = b.kind < a.kind;
  const ChunkQuery run = swapped ? find(b.kind, a.kind, method) : find(a.kind, b.kind, method);
  if (run == nullptr) return c;
  if (!swapped) {
    run(1, &a, &b, &offset, options, nullptr, &c);
    return c;
  }
  const Vec3d back = -offset;
  run(1, &b, &a, &back, options, nullptr, &c);
  return exchanged(c, offset);
}

}  // namespace contact
