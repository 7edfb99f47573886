// The parts of dem check's page, in order.
#pragma once

#include <string>
#include <vector>

#include "libdem/forecast/cost.h"
#include "libdem/forecast/loads.h"
#include "libdem/world.h"

namespace dem::cli {

void head(const std::string& title);
void line(const std::string& name, const std::string& text);

// Bodies, materials with their sources, walls.
void print_inventory(const World& world);
// What is modelled, and what is off with its reason.
void print_model(const World& world);
// The step against the limits of each pair.
void print_time_step(const World& world, const std::vector<BodyGroup>& groups, const forecast::Loads& loads,
                     const std::vector<forecast::PairForecast>& pairs);
void print_loads(const World& world, const forecast::Loads& loads, const std::vector<forecast::PairForecast>& pairs);
// `base`: bytes of the program before it read the scene.
void print_cost(const forecast::Cost& cost, double base);

}  // namespace dem::cli
