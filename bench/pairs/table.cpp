#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/pairs/entries.h"

namespace pairs {

namespace {

double ns_of(const std::vector<Entry>& entries, const std::string& key) {
  for (const Entry& e : entries)
    if (e.key() == key) return e.ns;
  return no_number;
}

struct Bar {
  std::string text;
  double bound, got;
  bool at_least;
};

class Bars {
 public:
  explicit Bars(const std::vector<Entry>& entries) : entries_(entries) {}
  double ns(const std::string& key) const { return ns_of(entries_, key); }
  // ns(top) / ns(bottom) against the bound. Left out when the yardstick, or the set of what is judged, was not timed.
  void at_least(const std::string& top, const std::string& bottom, double bound) { add(top, bottom, bound, true); }
  void at_most(const std::string& top, const std::string& bottom, double bound) { add(top, bottom, bound, false); }
  const std::vector<Bar>& list() const { return list_; }

 private:
  void add(const std::string& top, const std::string& bottom, double bound, bool at_least) {
    const std::string &judged = at_least ? bottom : top, &yardstick = at_least ? top : bottom;
    if (std::isnan(ns(yardstick)) || std::isnan(ns(judged.substr(0, judged.rfind('/')) + "/own scalar"))) return;
    list_.push_back({top + " : " + bottom, bound, ns(top) / ns(bottom), at_least});
  }
  const std::vector<Entry>& entries_;
  std::vector<Bar> list_;
};

}  // namespace

void print_table(const std::vector<Entry>& entries) {
  std::printf("%-34s %-18s %10s %9s %9s %9s %5s\n", "pair", "by", "ns/query", "x scalar", "error", "worst", "lost");
  const Set* last = nullptr;
  for (const Entry& e : entries) {
    const double ratio = e.ns / ns_of(entries, e.set->name() + "/own scalar");
    std::printf("%-34s %-18s %10.1f %9.2f", e.set == last ? "" : e.set->name().c_str(), e.subject.c_str(), e.ns, ratio);
    if (std::isnan(e.error_median))
      std::printf(" %9s %9s", "", "");
    else
      std::printf(" %9.0e %9.0e", e.error_median, e.error_worst);
    if (e.lost > 0) std::printf(" %5zu", e.lost);
    std::printf("\n");
    last = e.set;
  }
}

void print_csv(const std::vector<Entry>& entries, const std::string& path) {
  FILE* const f = std::fopen(path.c_str(), "w");
  if (f == nullptr) {
    std::fprintf(stderr, "bench_pairs: cannot write %s\n", path.c_str());
    return;
  }
  std::fprintf(f, "pair,config,by,ns_per_query,error_median,error_worst,lost\n");
  for (const Entry& e : entries)
    std::fprintf(f, "%s,%s,%s,%.2f,%.3g,%.3g,%zu\n", e.set->family.c_str(), e.set->config.c_str(), e.subject.c_str(),
                 e.ns, e.error_median, e.error_worst, e.lost);
  std::fclose(f);
}

int print_bars(const std::vector<Entry>& entries) {
  Bars bars(entries);
  const std::string sphere = "sphere/touch/own scalar";
  bars.at_least(sphere, "sphere/touch/own packed", 2.5);
  const std::string e2 = "ellipsoid_1_1_2/touch/", e10 = "ellipsoid_1_1_10/touch/";
  bars.at_least(e2 + "libccd MPR", e2 + "own scalar", 4);
  bars.at_least(e2 + "libccd MPR", e2 + "own chunk", 14);
  bars.at_least(e2 + "libccd MPR", e2 + "own warm", 20);
  for (const char* by : {"own scalar", "own chunk", "own warm"}) bars.at_most(e10 + by, e2 + by, 2);
  struct Warm {
    const char* family;
    double bar;
  };
  for (const Warm& warm : {Warm{"cube", 8}, {"poly12", 8}, {"poly50", 20}, {"poly200", 20}, {"poly1000", 20}}) {
    const std::string pair = std::string(warm.family) + "/touch/", epa = pair + "libccd EPA 1e-10";
    bars.at_least(epa, pair + "own scalar", 2.5);
    bars.at_least(epa, pair + "own chunk cached", warm.bar);
  }
  for (const char* family : {"ellipsoid_1_1_2", "ellipsoid_1_1_10", "ellipsoid_1_.5_.25", "cube", "poly12", "poly50",
                             "poly200", "poly1000", "ellipse_1_.5", "octagon"})
    bars.at_most(std::string(family) + "/apart/own chunk cached", sphere, 4);
  bars.at_most("ellipse_1_.5/touch/own scalar", e2 + "own scalar", 0.5);
  bars.at_most("octagon/touch/own chunk cached", sphere, 15);
  for (const Entry& e : entries) {
    const Set& s = *e.set;
    if (s.member_a == s.member_b || e.subject != "own scalar" || s.config != "touch") continue;
    const std::string a = s.member_a + "/touch/own scalar", b = s.member_b + "/touch/own scalar";
    bars.at_most(e.key(), bars.ns(a) > bars.ns(b) ? a : b, 3);
  }
  int missed = 0;
  std::printf("\n%-92s %8s %8s\n", "bar (ratio of times)", "bar", "got");
  for (const Bar& b : bars.list()) {
    const bool pass = b.at_least ? b.got >= b.bound : b.got <= b.bound;
    if (!pass) ++missed;
    std::printf("%-92s %s %5.1f %8.2f %s\n", b.text.c_str(), b.at_least ? ">=" : "<=", b.bound, b.got,
                pass ? "pass" : (std::isnan(b.got) ? "MISSED: there is no such way yet" : "MISSED"));
  }
  return missed;
}

}  // namespace pairs
