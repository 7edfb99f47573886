// What a scene models and what is off, with the reason, as dem check prints it and a report shows it.
#pragma once

#include <string>
#include <vector>

#include "libdem/world.h"

namespace dem::cli {

struct ModelLine {
  std::string name, text;  // name empty: the line before goes on
};
std::vector<ModelLine> model_lines(const World& world);

}  // namespace dem::cli
