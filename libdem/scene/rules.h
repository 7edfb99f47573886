// What the rules of a scene share: the tree that was read, the scene made of it, and how a broken rule is told.
#pragma once

#include <string>

#include "libdem/scene/errors.h"
#include "libdem/scene/node.h"
#include "libdem/scene/scene.h"

namespace dem {

struct RuleContext {
  const Node& root;
  const Scene& scene;
  Errors& errors;

  // The value of a key of the i-th entry of an array of tables (or of a plain table), or null.
  const Node* node(const char* table, std::size_t i, const char* key) const;
  // Adds an error at the key's value, or at its table when it was left out or key is null.
  void wrong(const char* table, std::size_t i, const char* key, const std::string& problem) const;
  void nonzero(const char* table, std::size_t i, const char* key, const Vec3d& v) const;
};

void check_wall_rules(const RuleContext& context, std::size_t wall);
void check_periodic_rules(const RuleContext& context);
void check_analysis_rules(const RuleContext& context);
void check_law_rules(const RuleContext& context);        // laws, materials, pairs of materials
void check_insertion_rules(const RuleContext& context);  // regions, fills, rain, outlets, species, events, run.until

}  // namespace dem
