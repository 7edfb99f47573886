// The library's own ways to a pair, gather of the bodies and scatter of the answers included.
#include <algorithm>
#include <cmath>

#include "bench/pairs/entries.h"
#include "libcontact/kernels/chunk.h"
#include "libcontact/methods/analytic.h"
#include "libcontact/methods/planar.h"
#include "libcontact/methods/support_newton.h"
#include "libcontact/sphere_pairs.h"

namespace pairs {

namespace {

using contact::Cache;
using contact::Contact;
using contact::Options;
using shapes::Kind;

// All that a subject reads and writes, allocated once.
struct Work {
  const Set& set;
  contact::ChunkQuery query;
  std::vector<Kept> kept;
  std::vector<Cache> cache, scratch;  // as the first pose left them; a copy for the run
  explicit Work(const Set& s)
      : set(s), query(contact::find(s.a, s.b)), kept(s.list.size()), cache(s.list.size()), scratch(s.list.size()) {}
};

void keep(const Contact& c, Kept& k) { k = {c.normal, c.patch.centre, c.gap}; }

// One pair after the other through one function.
template <class Query>
std::function<void()> one_by_one(const std::shared_ptr<Work>& w, Query query) {
  return [w, query] {
    const Body* bodies = w->set.bodies.data();
    std::size_t i = 0;
    for (const Pair& p : w->set.list) keep(query(bodies[p.a], bodies[p.b], p.offset), w->kept[i++]);
  };
}

// Chunks through the door of dispatch.h, as libdem gathers them.
void chunks(Work& w, const Options& options, bool next, Cache* cache) {
  ask(w.set, w.query, options, next, w.set.list.size(), largest_chunk, cache, w.kept.data());
}

// Half the width of the proven interval, over the size: a bound of the error.
void note_own_errors(Entry& e, const Set& set, const char* method) {
  std::vector<double> errors;
  for (const Pair& p : set.list) {
    const Contact c = contact::query(set.bodies[p.a], set.bodies[p.b], p.offset, {}, method);
    errors.push_back(0.5 * (c.gap_upper - c.gap_lower) / p.size);
  }
  note_errors(e, std::move(errors));
}

// Spheres as the loop of libdem holds them: positions and radii in records, answers in lanes.
void add_loop_kernels(const Set& set, std::vector<Entry>& entries) {
  namespace k = contact::kernels;
  struct Packed {
    std::vector<contact::Motion> motion;
    std::vector<k::Index> a, b;
    k::SphereChunk in;
    k::LawChunk out;
  };
  auto w = std::make_shared<Packed>();
  for (const Pair& p : set.list) {
    w->a.push_back(static_cast<k::Index>(w->motion.size()));
    w->b.push_back(w->a.back() + 1);
    contact::Motion m;
    m.bounding_radius = set.bodies[p.a].size.x;
    m.inverse_mass = 1;
    w->motion.push_back(m);
    m.bounding_radius = set.bodies[p.b].size.x;
    m.position = p.offset;
    w->motion.push_back(m);
  }
  entries.push_back({&set, "own loop kernels", set.list.size(), [w] {
                       const std::size_t all = w->a.size();
                       for (std::size_t i = 0; i < all; i += k::chunk_size) {
                         const std::size_t n = std::min(k::chunk_size, all - i);
                         k::kernels().gather_spheres(w->motion.data(), &w->a[i], &w->b[i], n, w->in, w->out);
                         k::kernels().spheres(w->in, w->out, n);
                       }
                     }});
}

// Spheres through sphere_pairs: centres and radii in rows, answers in arrays.
void add_sphere_rows(const Set& set, std::vector<Entry>& entries) {
  struct Packed {
    std::vector<contact::SphereRow> spheres;
    std::vector<std::uint32_t> a, b;
    std::vector<double> answers;
  };
  auto w = std::make_shared<Packed>();
  for (const Pair& p : set.list) {
    w->a.push_back(static_cast<std::uint32_t>(w->spheres.size()));
    w->b.push_back(w->a.back() + 1);
    w->spheres.push_back({{}, set.bodies[p.a].size.x});
    w->spheres.push_back({p.offset, set.bodies[p.b].size.x});
  }
  w->answers.resize(7 * set.list.size());
  entries.push_back({&set, "own packed", set.list.size(), [w] {
                       const std::size_t n = w->a.size();
                       double* const r = w->answers.data();
                       contact::sphere_pairs(w->spheres.data(), w->a.data(), w->b.data(), n,
                                             {r, {r + n, r + 2 * n, r + 3 * n}, {r + 4 * n, r + 5 * n, r + 6 * n}});
                     }});
}

}  // namespace

void add_own(const Set& set, std::vector<Entry>& entries) {
  const auto work = std::make_shared<Work>(set);
  const auto add = [&](const char* subject, std::function<void()> run) -> Entry& {
    return entries.emplace_back(Entry{&set, subject, set.list.size(), std::move(run)});
  };
  const auto scalar = [&]<class Method, class A, class B>() {
    return one_by_one(work, [](const Body& a, const Body& b, const Vec3d& offset) {
      return Method::query(contact::placed<A>(a), contact::placed<B>(b), offset, Options{}, nullptr);
    });
  };
  std::function<void()> one;
  if (set.a == Kind::sphere && set.b == Kind::sphere)
    one = scalar.operator()<contact::Analytic, shapes::Sphere, shapes::Sphere>();
  else if (set.a == Kind::ellipsoid && set.b == Kind::ellipsoid)
    one = scalar.operator()<contact::SupportNewton, shapes::Ellipsoid, shapes::Ellipsoid>();
  else if (set.a == Kind::ellipse && set.b == Kind::ellipse)
    one = scalar.operator()<contact::Planar, shapes::Ellipse, shapes::Ellipse>();
  else
    one = one_by_one(work, [query = work->query](const Body& a, const Body& b, const Vec3d& offset) {
      Contact c;
      query(1, &a, &b, &offset, Options{}, nullptr, &c);
      return c;
    });
  note_own_errors(add("own scalar", one), set, "auto");
  // The general convex methods: cold, to what they stop at by themselves.
  for (const char* method : {"gjk_epa", "mpr", "constrained_minimisation"})
    if (const contact::ChunkQuery query = contact::find(set.a, set.b, method))
      note_own_errors(add(("own " + std::string(method)).c_str(),
                          one_by_one(work,
                                     [query](const Body& a, const Body& b, const Vec3d& offset) {
                                       Contact c;
                                       query(1, &a, &b, &offset, Options{}, nullptr, &c);
                                       return c;
                                     })),
                      set, method);
  add("own chunk", [work] { chunks(*work, Options{}, false, nullptr); });
  // What the loop asks: overlap only, with what the pose before left in the cache.
  chunks(*work, {.overlap_only = true}, false, work->cache.data());
  add("own chunk cached", [work] {
    std::copy(work->cache.begin(), work->cache.end(), work->scratch.begin());
    chunks(*work, {.overlap_only = true}, true, work->scratch.data());
  });
  if (set.a == Kind::polyhedron && set.b == Kind::polyhedron) {
    add("own cached depth", [work] {  // with the measure that libdem's laws act on
      std::copy(work->cache.begin(), work->cache.end(), work->scratch.begin());
      chunks(*work, {.overlap_only = true, .measure = true}, true, work->scratch.data());
    });
  }
  if (set.a == Kind::sphere && set.b == Kind::sphere) {
    add_sphere_rows(set, entries);
    add_loop_kernels(set, entries);
  }
  if (set.a == Kind::ellipsoid && set.b == Kind::ellipsoid) {
    const auto warm = std::make_shared<Work>(set);
    chunks(*warm, {.warm_start = true}, false, warm->cache.data());
    add("own warm", [warm] {
      std::copy(warm->cache.begin(), warm->cache.end(), warm->scratch.begin());
      chunks(*warm, {.warm_start = true}, true, warm->scratch.data());
    });
  }
}

}  // namespace pairs
