#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/trade/trade.h"
#include "libcontact/methods/method.h"
#include "tests/reference/answer.h"

namespace trade {

namespace {

using contact::Body;
using contact::Cache;
using contact::ChunkQuery;
using contact::Contact;
using contact::Options;
using contact::Status;
using pairs::Pair;
using pairs::Set;
using shapes::Vec3d;

struct Truth {
  double gap, half_width;
  Vec3d normal, point;
};

std::vector<Truth> truths(const Set& set, std::size_t referenced) {
  std::vector<Truth> list;
  for (std::size_t i = 0; i < set.list.size(); ++i) {
    const Pair& p = set.list[i];
    const Contact c = contact::query(set.bodies[p.a], set.bodies[p.b], p.offset);
    Truth t{c.gap, 0.5 * (c.gap_upper - c.gap_lower), c.normal, c.patch.centre};
    if (i < referenced) {
      const auto body = [&](std::uint32_t k) {
        const Body& b = set.bodies[k];
        return reference::Body{b.kind, b.size, set.orientation[k], b.geometry};
      };
      const reference::Answer known = reference::answer(body(p.a), body(p.b), p.offset);
      if (known.matched) {
        t.gap = static_cast<double>(known.lower);
        t.half_width = 0;
        t.normal = reference::rounded(known.normal);
      }
    }
    list.push_back(t);
  }
  return list;
}

struct Way {
  std::string by, use;
  ChunkQuery query;
  Options options;
  bool own_measure;  // its overlap, normal and point are its own, else gap, normal and the patch's centre
};

std::vector<Way> ways(const Set& set) {
  std::vector<Way> list;
  const std::string_view exact = contact::choose(set.a, set.b)->name;
  for (const contact::MethodInfo* m = contact::methods_begin(); m != contact::methods_end(); ++m)
    if (m->a == set.a && m->b == set.b)
      list.push_back({std::string(m->name), "cold", contact::find(set.a, set.b, m->name), {}, !m->exact});
  for (const double tolerance : {0.0, 1e-9, 1e-6, 1e-4, 1e-2}) {
    Options o;
    o.tolerance = tolerance;
    const ChunkQuery query = contact::find(set.a, set.b, "auto", tolerance);
    const std::string name = tolerance > 0 ? fmt::format("auto {:.0e}", tolerance) : std::string(exact);
    if (tolerance > 0) list.push_back({name, "cold", query, o, false});
    list.push_back({name, "batch", query, o, false});
    if (tolerance > 0) continue;
    o.warm_start = true;
    list.push_back({name, "warm", query, o, false});
  }
  return list;
}

Errors spread(std::vector<double> v) {
  if (v.empty()) return {};
  std::sort(v.begin(), v.end());
  return {v[v.size() / 2], v[v.size() * 99 / 100], v.back()};
}

void note_errors(Row& row, const Way& way, const Set& set, const std::vector<Truth>& truth) {
  std::vector<double> gap, normal, point, hertz;
  for (std::size_t i = 0; i < row.pairs; ++i) {
    const Pair& p = set.list[i];
    Contact c;
    way.query(1, &set.bodies[p.a], &set.bodies[p.b], &p.offset, way.options, nullptr, &c);
    if (c.status == Status::refused || c.status == Status::not_converged) continue;
    ++row.answered;
    row.certified += c.certified;
    row.handed_over += c.handed_over;
    const Truth& t = truth[i];
    gap.push_back(std::max(std::abs(c.gap - t.gap), t.half_width) / p.size);
    if (way.own_measure) act_on_own_measure(c);
    normal.push_back(std::atan2(norm(cross(c.normal, t.normal)), dot(c.normal, t.normal)));
    point.push_back(norm(c.patch.centre - t.point) / p.size);
    if (t.gap < 0) hertz.push_back(std::abs(std::pow(std::max(0.0, -c.gap) / -t.gap, 1.5) - 1));
  }
  row.gap = spread(std::move(gap));
  row.normal = spread(std::move(normal));
  row.point = spread(std::move(point));
  row.hertz = spread(std::move(hertz));
}

struct Runner {
  const Set& set;
  Way way;
  std::size_t count, chunk;
  bool next = false;
  std::vector<Cache> left{}, cache{};
  std::vector<pairs::Kept> kept = std::vector<pairs::Kept>(count);

  void run() {
    std::copy(left.begin(), left.end(), cache.begin());
    pairs::ask(set, way.query, way.options, next, count, chunk, cache.empty() ? nullptr : cache.data(), kept.data());
  }
};

std::shared_ptr<Runner> runner(const Set& set, const Way& way, std::size_t count) {
  auto r = std::make_shared<Runner>(set, way, count, way.use == "cold" ? std::size_t{1} : pairs::largest_chunk);
  if (way.use != "warm") return r;
  r->cache.resize(count);
  r->run();
  r->left = r->cache;
  r->next = true;
  return r;
}

// Pairs of a slow way that are timed and judged: what takes about a fiftieth of a second.
std::size_t affordable(const Set& set, const Way& way) {
  const std::size_t few = std::min<std::size_t>(4, set.list.size());
  pairs::Entry probe{&set, way.by, few, [r = runner(set, way, few)] { r->run(); }};
  std::vector<pairs::Entry> entries{std::move(probe)};
  pairs::time_all(entries, 1, 0);
  const double allowed = 2e7 / std::max(1.0, entries[0].ns);
  return std::clamp(static_cast<std::size_t>(allowed), few, set.list.size());
}

}  // namespace

std::vector<Row> measure(const Set& set, const Settings& settings) {
  const std::vector<Truth> truth = truths(set, settings.truth);
  std::vector<Row> rows;
  std::vector<pairs::Entry> entries;
  for (const Way& way : ways(set)) {
    Row row{.set = &set, .by = way.by, .use = way.use, .tolerance = way.options.tolerance};
    row.pairs = affordable(set, way);
    note_errors(row, way, set, truth);
    rows.push_back(row);
    entries.push_back({&set, way.by, row.pairs, [r = runner(set, way, row.pairs)] { r->run(); }});
  }
  pairs::time_all(entries, settings.repetitions, settings.sample);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].ns = entries[i].ns;
    rows[i].ns_low = entries[i].ns_low;
    rows[i].ns_high = entries[i].ns_high;
  }
  return rows;
}

}  // namespace trade
