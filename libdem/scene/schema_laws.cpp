// Keys of [law], [[material]] and [[material_pair]].
#include "libcontact/laws/list.h"
#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem {

using bind::value;
using bind::word;

namespace {

template <class List>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  contact::each_law<List>([&](auto law, std::size_t) { names.emplace_back(law.name); });
  return names;
}

std::vector<std::string> combinations(bool hertzian_only) {
  std::vector<std::string> names;
  for (const contact::NamedLaw& l : contact::named_laws)
    if (!hertzian_only || contact::hertzian(l.normal)) names.emplace_back(l.name);
  return names;
}

static_assert(std::size(contact::named_laws) == law_name_count);

}  // namespace

std::vector<Key> law_keys() {
  return {
      word<&LawSpec::name>("name", "A combination of laws; see dem list laws.", combinations(false)).must(),
      value<&LawSpec::normal>("normal", "", "A normal law in place of the combination's.")
          .one_of(names_of<contact::NormalLaws>()),
      value<&LawSpec::tangential>("tangential", "", "A tangential law in place of the combination's.")
          .one_of(names_of<contact::TangentialLaws>()),
      value<&LawSpec::rolling>("rolling", "", "Resistance to rolling and twisting in place of the combination's.")
          .one_of(names_of<contact::RollingLaws>()),
      value<&LawSpec::cohesion>("cohesion", "", "Attraction beside the normal law in place of the combination's.")
          .one_of(names_of<contact::CohesionLaws>()),
      word<&LawSpec::map>(
          "map",
          "Radius that a law of spheres takes on other bodies; auto = that of the sphere of equal "
          "volume, and none on prisms; equivalent_radius: on prisms that of the disc of equal area; "
          "curvature: of the elliptical Hertz contact at the first touch; edge_radius: law.edge_radius "
          "on flat-faced bodies; volume: force from a potential of the overlap's volume. See dem list maps.",
          {"auto", "equivalent_radius", "curvature", "edge_radius", "volume"}),
      value<&LawSpec::edge_radius>("edge_radius", "m", "Radius to which edges and corners are rounded.")
          .above(0)
          .when("map", {"edge_radius"})
          .must(),
      value<&LawSpec::rescale>("rescale", "", "Shorten the tangential spring when the contact radius shrinks.")
          .when("name", combinations(true)),
      value<&LawSpec::clip>("clip", "",
                            "A contact ends when its force is zero; false = when its overlap is: until then the "
                            "dashpot may pull, and restitution may be 0."),
      value<&LawSpec::deficit>("deficit", "",
                               "Tangential law mindlin_deresiewicz: remember the slip that an increment did not make; "
                               "false = as printed, which may create energy."),
      value<&LawSpec::ledger>("ledger", "", "Book the work of every mechanism (summary.json)."),
      value<&LawSpec::reference_speed>("reference_speed", "m/s",
                                       "Linear laws: stiffness such that an impact at this speed lasts as long as that "
                                       "of Hertz, from young, poisson and the largest bodies; in place of "
                                       "material.stiffness.")
          .above(0),
      value<&LawSpec::surface_tension>("surface_tension", "N/m", "Of the liquid in bridges.").from(0),
      value<&LawSpec::bridge_volume>("bridge_volume", "m^3", "Of the liquid of one bridge.").from(0),
  };
}

std::vector<Key> material_keys() {
  return {
      value<&MaterialSpec::name>("name", "", "Name by which bodies and walls refer to it.").own_name(),
      value<&MaterialSpec::like>("like", "",
                                 "A named material whose young, poisson and density stand in for those left out here.")
          .named_in("materials"),
      value<&MaterialSpec::young>("young", "Pa", "Young's modulus; needed by Hertzian laws unless rigid.").above(0),
      value<&MaterialSpec::poisson>("poisson", "", "Poisson's ratio.").from(0).to(0.5),
      value<&MaterialSpec::density>("density", "kg/m^3",
                                    "Mass density; needed where a body, not only a wall, is made of it.")
          .above(0),
      value<&MaterialSpec::restitution>("restitution", "", "Rebound speed over impact speed, head-on; 1 = undamped.")
          .from(0)
          .to(1),
      value<&MaterialSpec::friction>("friction", "", "Coulomb friction coefficient; inf = no slip.")
          .from(0)
          .or_infinite(),
      value<&MaterialSpec::stiffness>("stiffness", "N/m", "Normal stiffness; needed by linear laws unless rigid.")
          .above(0),
      value<&MaterialSpec::viscous_time>("viscous_time", "s", "Time A of Kuwabara and Kono's viscous solid.").from(0),
      value<&MaterialSpec::yield_pressure>("yield_pressure", "Pa", "Contact pressure at which it begins to yield.")
          .above(0),
      value<&MaterialSpec::work_of_adhesion>(
          "work_of_adhesion", "J/m^2",
          "Work that parts two surfaces of it, twice the surface energy of one; give "
          "this or surface_energy.")
          .from(0),
      value<&MaterialSpec::surface_energy>("surface_energy", "J/m^2",
                                           "Energy of one surface of it, half the work of adhesion.")
          .from(0),
      value<&MaterialSpec::plastic_stiffness>("plastic_stiffness", "N/m",
                                              "Unloading stiffness that adhesive_plastic_spring reaches.")
          .above(0),
      value<&MaterialSpec::adhesive_stiffness>("adhesive_stiffness", "N/m",
                                               "Slope of the branch on which adhesive_plastic_spring pulls.")
          .from(0),
      value<&MaterialSpec::plastic_depth>("plastic_depth", "", "Depth, in 2 R*, from which plastic_stiffness holds.")
          .above(0)
          .to(1),
      value<&MaterialSpec::rolling_friction>("rolling_friction", "", "Rolling resistance, of laws with law.rolling.")
          .from(0),
      value<&MaterialSpec::rolling_viscosity>("rolling_viscosity", "s/m", "Of law.rolling = viscous.").from(0),
      value<&MaterialSpec::rolling_damping>("rolling_damping", "",
                                            "Damping of law.rolling = spring, part of the critical one.")
          .from(0),
      value<&MaterialSpec::twisting_friction>("twisting_friction", "",
                                              "Resistance to spin about the normal, of laws with law.rolling.")
          .from(0),
      value<&MaterialSpec::cohesion>("cohesion", "N", "Attraction while in contact, of law.cohesion = constant.")
          .from(0),
      value<&MaterialSpec::contact_angle>("contact_angle", "rad", "Of the liquid in bridges on it.").from(0).to(1.5),
      value<&MaterialSpec::rigid>("rigid", "", "Adds no compliance to a contact; not for two that can meet."),
  };
}

std::vector<Key> pair_keys() {
  return {
      value<&MaterialPairSpec::a>("a", "", "One material.").refers("material").must(),
      value<&MaterialPairSpec::b>("b", "", "The other one (or the same).").refers("material").must(),
      value<&MaterialPairSpec::restitution>("restitution", "", "Replaces the mixed restitution.").from(0).to(1),
      value<&MaterialPairSpec::friction>("friction", "", "Replaces the mixed friction.").from(0).or_infinite(),
      value<&MaterialPairSpec::published>(
          "published", "", "A published friction coefficient by its pair of surfaces; replaces the mixed friction.")
          .named_in("friction"),
      value<&MaterialPairSpec::work_of_adhesion>("work_of_adhesion", "J/m^2", "Replaces sqrt(W1 W2).").from(0),
      value<&MaterialPairSpec::rolling_friction>("rolling_friction", "", "Replaces the smaller one.").from(0),
      value<&MaterialPairSpec::twisting_friction>("twisting_friction", "", "Replaces the smaller one.").from(0),
      value<&MaterialPairSpec::cohesion>("cohesion", "N", "Replaces the smaller one.").from(0),
      value<&MaterialPairSpec::stiffness>("stiffness", "N/m", "Replaces the mixed normal stiffness (linear laws).")
          .above(0),
  };
}

}  // namespace dem
