// The dispatch table, made from any two lists: how dispatch.cpp makes that of the library, and how a host makes one
// with shapes and methods of its own.
//
// A shape of a host is any type; its kind is its position in the host's list, which begins with shapes::List, so that
// the kinds of the library keep their numbers. It needs
//   template <> struct contact::Placed<host::Capsule> {
//     …                                               what a query of it reads
//     static Placed of(const Body& b);                from size, rotation and geometry of a body
//     double circumradius() const;                    m, about the body's origin; 0 of a wall
//   };
// A method of a host is a method as methods/method.h says. Then
//   using Shapes = contact::Joined<shapes::List, std::tuple<host::Capsule>>;
//   using Methods = contact::Joined<contact::Methods, std::tuple<host::CapsulePair>>;      (methods/list.h)
//   using Table = contact::Dispatch<Shapes, Methods>;
//   Table::query(a, b, offset)                        with a.kind = Table::kind_of<host::Capsule>()
// answers pairs of either. Pairs are stated in the order of the host's list.
//
// Cost: that of dispatch.h; instantiates every query of the lists. Test: tests/linkable (a foreign shape, method, law).
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <tuple>

#include "libcontact/dispatch.h"
#include "libcontact/methods/method.h"

namespace contact {

template <class... Lists>
using Joined = decltype(std::tuple_cat(std::declval<Lists>()...));

template <class Shapes, class Methods>
class Dispatch {
 public:
  using Kind = shapes::Kind;

  template <class S>
  static constexpr Kind kind_of() {
    return static_cast<Kind>(position<S>(std::make_index_sequence<std::tuple_size_v<Shapes>>{}));
  }

  // As the functions of dispatch.h.
  static const MethodInfo* begin() { return catalogue_.data(); }
  static const MethodInfo* end() { return catalogue_.data() + catalogue_.size(); }
  static const MethodInfo* choose(Kind a, Kind b, std::string_view method = "auto", double tolerance = 0) {
    const Entry* entry = entry_of(a, b, method, tolerance);
    return entry == nullptr ? nullptr : &catalogue_[static_cast<std::size_t>(entry - table_.data())];
  }
  static ChunkQuery find(Kind a, Kind b, std::string_view method = "auto", double tolerance = 0) {
    const Entry* entry = entry_of(a, b, method, tolerance);
    return entry == nullptr ? nullptr : to_tolerance(method, tolerance) ? entry->within : entry->run;
  }
  static ChunkQuery find_own_measure(Kind a, Kind b, std::string_view method = "auto") {
    const Entry* entry = entry_of(a, b, method, 0);
    return entry == nullptr ? nullptr : entry->own_measure;
  }
  static Contact query(const Body& a, const Body& b, const Vec3d& offset, const Options& options = {},
                       std::string_view method = "auto") {
    Contact c = refused();
    const bool swapped = b.kind < a.kind;
    const Kind low = swapped ? b.kind : a.kind, high = swapped ? a.kind : b.kind;
    const ChunkQuery run = find(low, high, method, options.tolerance);
    if (run == nullptr) return c;
    if (!swapped) {
      run(1, &a, &b, &offset, options, nullptr, &c);
      return c;
    }
    const Vec3d back = -offset;
    run(1, &b, &a, &back, options, nullptr, &c);
    return exchanged(c, offset);
  }

 private:
  struct Entry {
    MethodInfo info{};
    ChunkQuery run = nullptr, own_measure = nullptr, within = nullptr;
  };

  template <class S, std::size_t... I>
  static constexpr std::size_t position(std::index_sequence<I...>) {
    std::size_t found = sizeof...(I);
    ((std::is_same_v<S, std::tuple_element_t<I, Shapes>> ? void(found = I) : void()), ...);
    return found;
  }

  template <class M, class A, class B>
  static void run_chunk(std::size_t n, const Body* a, const Body* b, const Vec3d* offset, const Options& options,
                        Cache* cache, Contact* out) {
    if constexpr (AnswersChunks<M, A, B>)
      if (n > 1) return M::query_chunk(KindPair<A, B>{}, n, a, b, offset, options, cache, out);
    for (std::size_t i = 0; i < n; ++i) {
      // Constructed in place: an answer is 240 bytes, and copying it would cost as much as a pair of spheres.
      ::new (static_cast<void*>(out + i)) Contact(
          M::query(placed<A>(a[i]), placed<B>(b[i]), offset[i], options, cache == nullptr ? nullptr : cache + i));
    }
  }

  template <class M, class A, class B>
  static void run_own_measure(std::size_t n, const Body* a, const Body* b, const Vec3d* offset, const Options& options,
                              Cache* cache, Contact* out) {
    run_chunk<M, A, B>(n, a, b, offset, options, cache, out);
    for (std::size_t i = 0; i < n; ++i) act_on_own_measure(out[i]);
  }

  template <class S>
  static double size_of(const Body& b) {
    double radius = 0;
    if constexpr (requires(const Placed<S>& p) { p.circumradius(); })
      radius = placed<S>(b).circumradius();
    else if (!is_wall(b.kind))
      radius = circumradius(b);
    return radius > 0 ? radius : std::numeric_limits<double>::infinity();
  }

  // The cheapest method that reaches the tolerance answers all pairs; those that it leaves with a wider interval, or
  // without a proof of it, go on to the next. The narrowest interval stays, a proven one before others.
  template <class A, class B>
  static void run_within(std::size_t n, const Body* a, const Body* b, const Vec3d* offset, const Options& options,
                         Cache* cache, Contact* out) {
    constexpr std::size_t first = first_of(kind_of<A>(), kind_of<B>());
    bool answered = false;
    for (std::size_t k = first; k < table_.size(); ++k) {
      const Entry& entry = table_[k];
      if (entry.info.a != kind_of<A>() || entry.info.b != kind_of<B>()) break;
      if (!(entry.info.reach <= options.tolerance)) continue;
      if (!answered) {
        entry.run(n, a, b, offset, options, cache, out);
        answered = true;
        continue;
      }
      for (std::size_t i = 0; i < n; ++i) {
        if (narrow(out[i], options.tolerance * std::min(size_of<A>(a[i]), size_of<B>(b[i])))) continue;
        Contact other;
        entry.run(1, a + i, b + i, offset + i, options, cache == nullptr ? nullptr : cache + i, &other);
        if (!better(other, out[i])) continue;
        out[i] = other;
        out[i].handed_over = true;
      }
    }
    if (!answered) std::fill_n(out, n, refused());
  }
  static constexpr std::size_t first_of(Kind a, Kind b) {
    std::size_t k = 0;
    while (table_[k].info.a != a || table_[k].info.b != b) ++k;
    return k;
  }
  static bool narrow(const Contact& c, double width) {
    return c.status == Status::refused || (c.certified && (c.gap_upper - c.gap_lower <= width || proves_apart(c)));
  }
  static bool proves_apart(const Contact& c) {  // an `overlap_only` query that ended at its proof
    return c.status == Status::separated && c.gap_lower > 0 && c.gap_upper == std::numeric_limits<double>::infinity();
  }
  static bool better(const Contact& c, const Contact& than) {
    if (c.status == Status::refused || c.certified != than.certified) return c.status != Status::refused && c.certified;
    return proves_apart(c) || c.gap_upper - c.gap_lower < than.gap_upper - than.gap_lower;
  }

  // Calls visit.operator()<M, A, B>() for every method and pair of kinds A <= B that it answers.
  template <class Visit>
  static constexpr void for_each_answer(Visit visit) {
    constexpr std::size_t kinds = std::tuple_size_v<Shapes>;
    const auto per_pair = [&]<class M, std::size_t I, std::size_t J>() {
      using A = std::tuple_element_t<I, Shapes>;
      using B = std::tuple_element_t<J, Shapes>;
      if constexpr (I <= J && Answers<M, A, B>) visit.template operator()<M, A, B>();
    };
    const auto per_method = [&]<class M>() {
      [&]<std::size_t... IJ>(std::index_sequence<IJ...>) {
        (per_pair.template operator()<M, IJ / kinds, IJ % kinds>(), ...);
      }
      (std::make_index_sequence<kinds * kinds>{});
    };
    [&]<std::size_t... K>(std::index_sequence<K...>) {
      (per_method.template operator()<std::tuple_element_t<K, Methods>>(), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<Methods>>{});
  }

  static constexpr std::size_t answer_count() {
    std::size_t n = 0;
    for_each_answer([&]<class M, class A, class B>() { ++n; });
    return n;
  }

  static constexpr bool before(const MethodInfo& x, const MethodInfo& y) {
    if (x.a != y.a) return x.a < y.a;
    if (x.b != y.b) return x.b < y.b;
    if (x.cost_rank != y.cost_rank) return x.cost_rank < y.cost_rank;
    return x.name < y.name;
  }

  static constexpr auto make_table() {
    std::array<Entry, answer_count()> entries{};
    std::size_t n = 0;
    for_each_answer([&]<class M, class A, class B>() {
      entries[n].info = {M::name,       cost_of<M, A, B>(), kind_of<A>(), kind_of<B>(), always_certified<M, A, B>(),
                         is_exact<M>(), reach_of<M>(),      M::remark};
      entries[n].run = &run_chunk<M, A, B>;
      if constexpr (is_exact<M>())
        entries[n].own_measure = entries[n].run;
      else
        entries[n].own_measure = &run_own_measure<M, A, B>;
      entries[n].within = &run_within<A, B>;
      ++n;
    });
    std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) { return before(x.info, y.info); });
    return entries;
  }
  static constexpr auto make_catalogue() {
    std::array<MethodInfo, answer_count()> infos{};
    for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = table_[i].info;
    return infos;
  }
  // One name must not stand for two methods of one pair.
  static constexpr bool names_are_unique() {
    for (std::size_t i = 0; i < catalogue_.size(); ++i)
      for (std::size_t j = i + 1; j < catalogue_.size(); ++j)
        if (catalogue_[i].a == catalogue_[j].a && catalogue_[i].b == catalogue_[j].b &&
            catalogue_[i].name == catalogue_[j].name)
          return false;
    return true;
  }

  static bool to_tolerance(std::string_view method, double tolerance) { return method == "auto" && tolerance > 0; }

  static const Entry* entry_of(Kind a, Kind b, std::string_view method, double tolerance) {
    static_assert(names_are_unique());
    const Entry* cheapest = nullptr;
    for (const Entry& entry : table_) {
      if (entry.info.a != a || entry.info.b != b) continue;
      if (method == entry.info.name) return &entry;
      if (to_tolerance(method, tolerance)) {
        if (entry.info.reach <= tolerance) return &entry;
        continue;
      }
      if (method != "auto" || !entry.info.exact) continue;
      if (entry.info.certified) return &entry;
      if (cheapest == nullptr) cheapest = &entry;
    }
    return cheapest;
  }

  static constexpr std::array<Entry, answer_count()> table_ = make_table();
  static constexpr std::array<MethodInfo, answer_count()> catalogue_ = make_catalogue();
};

}  // namespace contact
