#include "libdem/cli/list_maps.h"

#include <fmt/format.h>

#include "libcontact/laws/list.h"
#include "libdem/law_map.h"

namespace dem::cli {
namespace {

std::string text_of(const MapVerdict& v) {
  const char* word = v.verdict == Verdict::theory ? "theory" : v.verdict == Verdict::model ? "model" : "refused";
  return *v.why == 0 ? word : fmt::format("{}: {}", word, v.why);
}

}  // namespace

std::vector<MapRow> map_rows() {
  std::vector<MapRow> rows;
  const auto add = [&](const std::string& of, const auto&... what) {
    MapRow row{{"of", of}};
    for (std::size_t m = 0; m < map_count; ++m) {
      const auto map = static_cast<LawMap>(m);
      row.emplace_back(name_of(map), text_of(map_verdict(map, what...)));
    }
    rows.push_back(row);
  };
  for (std::size_t a = 0; a < shapes::kind_count; ++a)
    for (std::size_t b = a; b < shapes::kind_count; ++b) {
      const auto kind_a = static_cast<shapes::Kind>(a), kind_b = static_cast<shapes::Kind>(b);
      if (shapes::is_wall(kind_a) || shapes::dimension_of(kind_a) != shapes::dimension_of(kind_b)) continue;
      add(fmt::format("{} - {}", shapes::name_of(kind_a), shapes::name_of(kind_b)), kind_a, kind_b);
    }
  contact::each_law<contact::NormalLaws>([&](auto law, std::size_t) {
    add(fmt::format("law {}", law.name), *contact::law_model({law.name, "coulomb_spring"}));
  });
  contact::each_law<contact::CohesionLaws>([&](auto law, std::size_t) {
    if (std::is_same_v<decltype(law), contact::NoCohesion>) return;
    add(fmt::format("law hertz with {}", law.name), *contact::law_model({"hertz", "coulomb_spring", "none", law.name}));
  });
  return rows;
}

}  // namespace dem::cli
