// Contacts for the benches: every law of the lists with partners that suit it, and named combinations.
#pragma once

#include <string>
#include <vector>

#include "libcontact/laws/list.h"
#include "libcontact/laws/mix.h"
#include "libdem/law_driver/impact.h"
#include "tests/libcontact/law_material.h"

namespace laws {

using contact::LawNames;
using contact::LawOptions;
using contact::Material;
using contact::stone;
using contact::wet;
using dem::law_driver::Approach;
using dem::law_driver::Ball;
using dem::law_driver::Drive;
using dem::law_driver::LawContact;
using dem::law_driver::Move;
using dem::law_driver::Rebound;
using shapes::Vec3d;

// Every law of every family once.
std::vector<LawNames> every_law();
std::string title(const LawNames& names);
const contact::NamedLaw& named(const std::string& name);
// The laws of a named combination.
LawNames names_of(const std::string& name);
bool has_normal_law(const std::string& name);
bool has_tangential_law(const std::string& name);

LawContact contact_of(const LawNames& names, const Material& a, const Material& b, const LawOptions& options = {});

// A material with a value for every parameter, 1 mm bodies in mind: E 1e8 Pa, ν 0.3, e 0.6, μ 0.4 …
// Liquid for it.
Ball ball(double radius, double density);

// Undamped Hertz contact, the closed forms of the sheet (1.3).
double hertz_duration(double mass_eff, double radius_eff, double young_eff, double speed);  // s
double hertz_overlap(double mass_eff, double radius_eff, double young_eff, double speed);   // m

}  // namespace laws
