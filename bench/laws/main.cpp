// Every force law against closed forms, published numbers, stability, energy; and what it costs.
#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <filesystem>

#include "bench/laws/report.h"
#include "libdem/io/programs.h"

namespace {

struct Entry {
  const char *name, *what;
  laws::Topic run;
};
constexpr Entry topics[] = {
    {"closed_forms", "laws against 50-digit evaluations of their formulas", laws::closed_forms},
    {"restitution", "every damped law and end of contact hits its restitution", laws::restitution},
    {"tangential", "loops and paths of micro-slip", laws::tangential},
    {"adhesion", "JKR, DMT, liquid bridges", laws::adhesion},
    {"plastic", "laws that yield, viscoelastic ones, elliptical Hertz", laws::plastic},
    {"chung_ooi", "the eight impacts of Chung & Ooi 2011", laws::chung_ooi},
    {"thornton", "oblique impacts of Thornton et al. 2011, 2013", laws::thornton},
    {"kharaz", "rebound angles of Kharaz, Gorham & Salman 2001", laws::kharaz},
    {"bodies", "stack, incline, rolling, spin, terminal velocity", laws::bodies},
    {"stability", "a contact is stable 1 % below its limit and not 1 % above", laws::stability},
    {"assemblies", "many contacts are stable at the bound", laws::assemblies},
    {"energy", "the energy balance of impacts", laws::energy},
    {"loops", "work over closed paths: default laws create no energy", laws::loops},
    {"shape_loops", "work over closed paths of pose: shape pair by law by map", laws::shape_loops},
    {"cost", "nanoseconds per contact", laws::cost},
};

void usage(std::FILE* to) {
  std::string text =
      "bench_laws [--only TOPIC] ... [--out DIR]\n"
      "  prints item, expected, got, error, pass; exit code 1 when one does not pass\n"
      "  --out writes the curves (CSV) and, where gnuplot is installed, figures into DIR\ntopics:\n";
  for (const Entry& t : topics) text += fmt::format("  {:<14}{}\n", t.name, t.what);
  std::fputs(text.c_str(), to);
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder;
  std::vector<const Entry*> wanted;
  for (int i = 1; i < argc; ++i) {
    const auto is = [&](const char* name) { return std::strcmp(argv[i], name) == 0 && i + 1 < argc; };
    if (is("--out")) {
      folder = argv[++i];
      continue;
    }
    if (is("--only")) {
      ++i;
      const std::size_t before = wanted.size();
      for (const Entry& t : topics)
        if (std::strcmp(t.name, argv[i]) == 0) wanted.push_back(&t);
      if (wanted.size() > before) continue;
      fmt::print(stderr, "no topic {}\n", argv[i]);
    }
    const bool help = std::strcmp(argv[i], "--help") == 0;
    usage(help ? stdout : stderr);
    return help ? 0 : 2;
  }
  if (wanted.empty())
    for (const Entry& t : topics) wanted.push_back(&t);
  if (!folder.empty()) {
    std::filesystem::create_directories(folder);
    if (!dem::io::installed("gnuplot")) fmt::print(stderr, "no figures: gnuplot is not installed\n");
  }
  laws::Report report(folder);
  for (const Entry* t : wanted) {
    report.topic(t->name, t->what);
    t->run(report);
  }
  fmt::print("\n{} pass, {} do not\n", report.passed(), report.failed());
  return report.failed() > 0 ? 1 : 0;
}
