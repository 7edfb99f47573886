// Materials and friction coefficients by name, from the tables in libdem/data: numbers with their sources.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace dem {

struct NamedMaterial {
  std::string name;
  double young = 0;               // Pa
  double poisson = 0;             // –
  std::optional<double> density;  // kg/m³, where the source gives it
  std::string source;
};

struct PublishedFriction {
  std::string pair;  // "glass ball - glass plate"
  double friction = 0;
  std::optional<double> uncertainty, highest;  // as reported: ±, or the upper end of a range that begins at `friction`
  std::string reference;                       // first author and year
  // The pair, with the reference in brackets where the table holds the pair more than once: a name of its own.
  std::string name;
};

// Read once. Throws InputError when the tables are missing or damaged ($DEM_MATERIALS names another folder).
const std::vector<NamedMaterial>& named_materials();
const std::vector<PublishedFriction>& published_friction();

// Entries that a name can mean: an exact name, a pair in either order, or a pair followed by " (reference)".
std::vector<const PublishedFriction*> find_friction(const std::string& name);
// "0.155 (Li 2005)", "0.096 ± 0.006 (Lorenz 1997)", "0.22 to 0.33 (Mullier 1991)".
std::string text_of(const PublishedFriction& entry);

}  // namespace dem
