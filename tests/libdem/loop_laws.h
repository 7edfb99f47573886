// The laws that closed loops are led through: named combinations, as they are and elastic, with friction and without.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "libdem/law_map.h"
#include "tests/libdem/laws_in_loop.h"

namespace dem::loops {

struct Variant {
  std::string name;
  LawSpec law;
  MaterialSpec material;
  bool damped = false;
  bool conserves = false;         // the force is a slope of the stored energy alone: a lap neither takes nor gives
  const char* literal = nullptr;  // kept to its source, which is known to create energy: why
};

inline Variant variant_of(std::size_t combination, double friction, bool elastic, bool rescale = true) {
  const contact::NamedLaw& named = contact::named_laws[combination];
  Variant v;
  v.law = law_loop::combination(combination);
  v.law.rescale = rescale;
  v.material = law_loop::material();
  v.material.friction = friction;
  if (elastic) v.material.restitution = 1;
  v.damped = named.damped && !elastic;
  v.name = std::string(named.name) + (v.damped ? ", damped" : "") + (friction > 0 ? "" : ", no friction") +
           (rescale ? "" : ", rescale = false");
  v.conserves = friction == 0 && !v.damped && (named.normal == "linear" || named.normal == "hertz");
  if (friction > 0) {
    if (named.tangential == "mindlin_deresiewicz") v.literal = "Box 9.1";
    if (named.tangential == "thornton_peeling") v.literal = "Box 9.1 after peeling";
    if (!rescale) v.literal = "rescale = false";
  }
  return v;
}

// Each way of calculating once: without friction the tangential law says nothing, but for peeling.
inline std::vector<Variant> every_variant() {
  std::vector<Variant> all;
  std::set<std::string> known;
  for (std::size_t i = 0; i < std::size(contact::named_laws); ++i) {
    const contact::NamedLaw& n = contact::named_laws[i];
    const std::string normal = std::string(n.normal) + "," + std::string(n.cohesion);
    if (known.insert(normal).second) all.push_back(variant_of(i, 0, true));
    if (known.insert(normal + "," + std::string(n.tangential)).second) all.push_back(variant_of(i, 0.4, true));
    if (n.damped) all.push_back(variant_of(i, 0.4, false));
  }
  all.push_back(variant_of(static_cast<std::size_t>(LawName::hertz_mindlin), 0.4, true, false));
  return all;
}

// Whether a map differs from the default one in what this law sees of two such kinds, and is for them.
inline bool worth_measuring(LawMap map, const contact::LawModel& law, shapes::Kind a, shapes::Kind b) {
  if (map_verdict(map, law).verdict == Verdict::refused) return false;
  const bool planar = shapes::dimension_of(a) == 2;
  if (map == LawMap::automatic) return !planar || !law.hertzian;
  if (map_verdict(map, a, b).verdict == Verdict::refused) return false;
  if (map == LawMap::equivalent_radius) return planar && law.hertzian;
  if (map == LawMap::volume) return true;
  const auto edged = [](shapes::Kind k) {
    return k == shapes::Kind::polyhedron || k == shapes::Kind::polygon || k == shapes::Kind::rounded_polyhedron ||
           k == shapes::Kind::compound;
  };
  return law.hertzian && (map != LawMap::edge_radius || edged(a) || edged(b));
}

constexpr LawMap every_map[] = {LawMap::automatic, LawMap::equivalent_radius, LawMap::curvature, LawMap::edge_radius,
                                LawMap::volume};

}  // namespace dem::loops
