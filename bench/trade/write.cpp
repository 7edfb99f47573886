#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/trade/trade.h"
#include "libcontact/kernels/chunk.h"
#include "libcontact/version.h"

namespace trade {

namespace {

std::string number(double v) { return std::isnan(v) ? "" : fmt::format("{:.3g}", v); }

struct Column {
  const char* name;
  Errors Row::*errors;
};
constexpr Column columns[] = {
    {"gap", &Row::gap}, {"normal", &Row::normal}, {"point", &Row::point}, {"hertz_force", &Row::hertz}};

}  // namespace

void print_rows(const std::vector<Row>& rows) {
  fmt::print("{:<24}{:<7}{:<26}{:<6}{:>10} {:>21}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>6}{:>7}\n", "pair", "config",
             "by", "use", "ns/query", "range", "gap p50", "p99", "max", "normal", "point", "Hertz", "answered", "cert.",
             "handed");
  const pairs::Set* last = nullptr;
  for (const Row& r : rows) {
    const auto n = static_cast<double>(r.pairs);
    fmt::print(
        "{:<24}{:<7}{:<26}{:<6}{:>10.1f} "
        "{:>10.1f}-{:<10.1f}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>8.0f}%{:>5.0f}%{:>6.0f}%\n",
        r.set == last ? "" : r.set->family, r.set == last ? "" : r.set->config, r.by, r.use, r.ns, r.ns_low, r.ns_high,
        number(r.gap.median), number(r.gap.p99), number(r.gap.most), number(r.normal.p99), number(r.point.p99),
        number(r.hertz.p99), 100 * static_cast<double>(r.answered) / n, 100 * static_cast<double>(r.certified) / n,
        100 * static_cast<double>(r.handed_over) / n);
    last = r.set;
  }
  fmt::print(
      "\nnormal, point, Hertz: 99 % of the pairs are at or below. answered, certified, handed over: share of the "
      "pairs\n");
}

void write_csv(const std::vector<Row>& rows, const std::string& path) {
  std::ofstream f(path);
  f << "pair,config,by,use,tolerance,ns,ns_low,ns_high,pairs,answered,certified,handed_over";
  for (const Column& c : columns) f << fmt::format(",{0}_median,{0}_p99,{0}_max", c.name);
  f << "\n";
  for (const Row& r : rows) {
    f << fmt::format("{},{},{},{},{},{:.2f},{:.2f},{:.2f},{},{},{},{}", r.set->family, r.set->config, r.by, r.use,
                     r.tolerance, r.ns, r.ns_low, r.ns_high, r.pairs, r.answered, r.certified, r.handed_over);
    for (const Column& c : columns) {
      const Errors& e = r.*c.errors;
      f << fmt::format(",{},{},{}", number(e.median), number(e.p99), number(e.most));
    }
    f << "\n";
  }
  if (!f.flush()) fmt::print(stderr, "bench_trade: cannot write {}\n", path);
}

void write_json(const std::vector<Row>& rows, const Settings& settings, const std::string& path) {
  nlohmann::json out;
  out["version"] = CONTACT_VERSION;
  out["kernels"] = contact::kernels::kernels().name;
  out["pairs"] = settings.pairs;
  out["truth_in_50_digits"] = settings.truth;
  out["repetitions"] = settings.repetitions;
  out["units"] = {{"ns", "nanoseconds of processor time per query"},
                  {"gap", "over the mean circumradius"},
                  {"normal", "rad"},
                  {"point", "over the mean circumradius"},
                  {"hertz_force", "relative"}};
  out["rows"] = nlohmann::json::array();
  for (const Row& r : rows) {
    nlohmann::json row = {{"pair", r.set->family},
                          {"config", r.set->config},
                          {"by", r.by},
                          {"use", r.use},
                          {"tolerance", r.tolerance},
                          {"ns", r.ns},
                          {"ns_range", {r.ns_low, r.ns_high}},
                          {"pairs", r.pairs},
                          {"answered", r.answered},
                          {"certified", r.certified},
                          {"handed_over", r.handed_over}};
    for (const Column& c : columns) {
      const Errors& e = r.*c.errors;
      if (!std::isnan(e.median)) row[c.name] = {{"median", e.median}, {"p99", e.p99}, {"max", e.most}};
    }
    out["rows"].push_back(row);
  }
  std::ofstream f(path);
  f << out.dump(1) << "\n";
  if (!f.flush()) fmt::print(stderr, "bench_trade: cannot write {}\n", path);
}

}  // namespace trade
