// From the words of a scene to the laws that its contacts run.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libcontact/laws/model.h"
#include "libdem/scene/scene.h"

namespace dem {

// The law of each family: that of the combination, or the one named in its place.
contact::LawNames law_names(const LawSpec& law);
// Every name must be in its list (the schema has seen to that).
contact::LawModel law_model_of(const LawSpec& law);
contact::LawOptions law_options_of(const LawSpec& law);
contact::Material material_of(const MaterialSpec& spec, const LawSpec& law);
// What a [[material_pair]] states in place of the mixed values.
void override_pair(contact::PairParameters& pair, const MaterialPairSpec& spec, bool clip);
// Names and units of a law's list of parameters: "young (Pa), poisson" is young, " (Pa)" and poisson, "".
std::vector<std::pair<std::string, std::string>> split_parameters(std::string_view list);
// Name of the combination, with the laws that stand in the place of its own: "hertz_mindlin, rolling spring".
std::string law_title(const LawSpec& law);

}  // namespace dem
