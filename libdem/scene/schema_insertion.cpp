// The keys of [[region]], [[species]], [[fill]], [[rain]], [[outlet]] and [[event]].
#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem {

using bind::tables;
using bind::value;
using bind::word;

namespace {

Key size_factor() {
  Key key = value<&FillItem::scale_min>(
      "scale", "",
      "Factor on the size of the shape: one number, or [min, max]; lognormal: where the distribution is cut off.");
  key.type = KeyType::number_or_range;
  key.set = [](void* spec, const Node& n) {
    FillItem& item = *static_cast<FillItem*>(spec);
    const bool list = n.kind == Node::Kind::array;
    item.scale_min = list ? n.items[0].as_number() : n.as_number();
    item.scale_max = list ? n.items[1].as_number() : n.as_number();
  };
  key.get = [](const void* spec) {
    const FillItem& item = *static_cast<const FillItem*>(spec);
    return Node::array_of({Node::of(item.scale_min), Node::of(item.scale_max)});
  };
  return key;
}

std::vector<Key> item_keys() {
  return {
      value<&FillItem::shape>("shape", "", "Shape of these bodies.").refers("shape").must(),
      value<&FillItem::material>("material", "", "Their material.").refers("material").must(),
      value<&FillItem::species>("species", "", "Their species.").refers("species"),
      value<&FillItem::weight>("weight", "", "Their share of the number, relative to the other items.").above(0),
      word<&FillItem::distribution>("distribution", "Of the factor on the size.", {"uniform", "lognormal", "table"}),
      size_factor().above(0).when("distribution", {"uniform", "lognormal"}).must_for({"lognormal"}),
      value<&FillItem::median>("median", "", "Median of the factor.")
          .above(0)
          .when("distribution", {"lognormal"})
          .must(),
      value<&FillItem::sigma>("sigma", "", "Standard deviation of the factor's logarithm.")
          .above(0)
          .to(3)
          .when("distribution", {"lognormal"})
          .must(),
      value<&FillItem::table>("table", "", "Factors with their shares: [[factor, share], ...].")
          .above(0)
          .when("distribution", {"table"})
          .must(),
      word<&FillItem::share_by>("share_by", "What the shares of the table are of.", {"number", "mass"})
          .when("distribution", {"table"}),
  };
}

std::vector<Key> region_keys() {
  return {
      value<&RegionSpec::name>("name", "", "Name by which fills, rain, outlets, species and events refer to it.")
          .own_name(),
      value<&RegionSpec::kind>("kind", "", "What it is; in two dimensions a box (a rectangle) or a disc.")
          .one_of({"box", "cylinder", "sphere", "disc"}),
      value<&RegionSpec::lower>("lower", "m", "Lower corner.").when("kind", {"box"}).must(),
      value<&RegionSpec::upper>("upper", "m", "Upper corner.").when("kind", {"box"}).must(),
      value<&RegionSpec::centre>("centre", "m", "Centre.").when("kind", {"cylinder", "sphere", "disc"}).must(),
      value<&RegionSpec::radius>("radius", "m", "Radius.").above(0).when("kind", {"cylinder", "sphere", "disc"}).must(),
      value<&RegionSpec::axis>("axis", "", "Direction of the axis; any length.").when("kind", {"cylinder"}),
      value<&RegionSpec::height>("height", "m", "Length along the axis.").above(0).when("kind", {"cylinder"}).must(),
  };
}

std::vector<Key> species_keys() {
  return {
      value<&SpeciesSpec::name>("name", "", "Its name, in output too.").own_name(),
      value<&SpeciesSpec::region>("region", "", "Bodies that begin with their centres in it are of this species.")
          .refers("region"),
      value<&SpeciesSpec::material>("material", "", "Bodies of this material are (with region: those in it).")
          .refers("material"),
      value<&SpeciesSpec::shape>("shape", "", "Bodies of this shape are (with the others: those that fit all).")
          .refers("shape"),
  };
}

std::vector<Key> fill_keys() {
  const std::vector<std::string> regular{"cubic", "hexagonal", "fcc"};
  return {
      value<&FillSpec::region>("region", "", "What is filled; or give lower and upper.").refers("region"),
      value<&FillSpec::lower>("lower", "m", "Lower corner of the box that is filled; or give region."),
      value<&FillSpec::upper>("upper", "m", "Upper corner."),
      value<&FillSpec::count>("count", "", "Number of bodies; or give solid_fraction or mass.")
          .from(1)
          .to(static_cast<double>(most_bodies)),
      value<&FillSpec::solid_fraction>("solid_fraction", "", "Volume of the bodies over that of the region.")
          .above(0)
          .to(1),
      value<&FillSpec::mass>("mass", "kg", "Mass of the bodies.").above(0),
      word<&FillSpec::arrangement>("arrangement",
                                   "Cells filled with jitter (lattice), one body after the other at random, or a "
                                   "regular lattice; auto = lattice where it has room, else random.",
                                   {"auto", "random", "lattice", "cubic", "hexagonal", "fcc"}),
      value<&FillSpec::spacing>("spacing", "m", "Between neighbours of a regular lattice; left out, they touch.")
          .above(0)
          .when("arrangement", regular),
      word<&FillSpec::turned>("turned", "Orientations: at random, or all as given.", {"random", "given"}),
      value<&FillSpec::orientation>("orientation", "", "Unit quaternion w, x, y, z: body axes to world axes.")
          .when("turned", {"given"})
          .must(),
      value<&FillSpec::velocity>("velocity", "m/s", "Their initial velocity."),
      tables<&FillSpec::items>("items", "What the region is filled with.", item_keys()).must(),
  };
}

std::vector<Key> rain_keys() {
  return {
      value<&RainSpec::name>("name", "", "Name in messages, events and output.").own_name(),
      value<&RainSpec::region>("region", "", "Where bodies appear.").refers("region").must(),
      value<&RainSpec::rate>("rate", "1/s", "Bodies per second; or give mass_rate.").above(0),
      value<&RainSpec::mass_rate>("mass_rate", "kg/s", "Mass per second; or give rate.").above(0),
      value<&RainSpec::start>("start", "s", "When it begins; not where an event starts it.").from(0),
      value<&RainSpec::stop>("stop", "s", "When it ends.").above(0),
      value<&RainSpec::count>("count", "", "Number of bodies at which it ends.").from(1),
      value<&RainSpec::mass>("mass", "kg", "Mass that it does not pass.").above(0),
      value<&RainSpec::tries>("tries", "",
                              "Positions tried per step; when all are blocked the body waits for the next step.")
          .from(1)
          .to(1000),
      word<&RainSpec::turned>("turned", "Orientations: at random, or all as given.", {"random", "given"}),
      value<&RainSpec::orientation>("orientation", "", "Unit quaternion w, x, y, z: body axes to world axes.")
          .when("turned", {"given"})
          .must(),
      value<&RainSpec::velocity>("velocity", "m/s", "Their initial velocity."),
      tables<&RainSpec::items>("items", "What rains.", item_keys()).must(),
  };
}

std::vector<Key> outlet_keys() {
  return {
      value<&OutletSpec::name>("name", "", "Name in messages and output.").own_name(),
      value<&OutletSpec::region>("region", "", "Bodies whose centre is in it go; or give point and normal.")
          .refers("region"),
      value<&OutletSpec::point>("point", "m", "A point on the plane behind which bodies go."),
      value<&OutletSpec::normal>("normal", "", "Towards the bodies that stay; any length."),
      value<&OutletSpec::recycle_to>("recycle_to", "", "Bodies are not deleted but moved to this region, without spin.")
          .refers("region"),
      value<&OutletSpec::velocity>("velocity", "m/s", "Of bodies that were moved to recycle_to."),
  };
}

std::vector<Key> event_keys() {
  return {
      value<&EventSpec::name>("name", "", "Name in messages and output.").own_name(),
      value<&EventSpec::at>("at", "s", "When it happens; or give when.").above(0),
      value<&EventSpec::when>("when", "",
                              "Condition at which it happens, like \"time > 0.5 and max_speed < 0.001\"; looked at "
                              "every run.check_every steps.")
          .as_condition(),
      value<&EventSpec::delay>("delay", "s", "From the condition to the actions.").from(0),
      value<&EventSpec::remove_wall>("remove_wall", "", "Takes this wall away.").refers("wall"),
      value<&EventSpec::insert_wall>("insert_wall", "", "Puts this wall into place.").refers("wall"),
      value<&EventSpec::start_motion>("start_motion", "", "Lets this wall begin its motion, which waits for it.")
          .refers("wall"),
      value<&EventSpec::stop_motion>("stop_motion", "", "Holds this wall where it is.").refers("wall"),
      value<&EventSpec::start_rain>("start_rain", "", "Lets this rain begin, which waits for it.").refers("rain"),
      value<&EventSpec::stop_rain>("stop_rain", "", "Ends this rain.").refers("rain"),
      value<&EventSpec::gravity>("gravity", "m/s^2", "Acceleration of gravity from now on."),
      value<&EventSpec::friction>("friction", "", "Friction of the materials a and b from now on.")
          .from(0)
          .or_infinite(),
      value<&EventSpec::a>("a", "", "One material of friction.").refers("material"),
      value<&EventSpec::b>("b", "", "The other one (or the same).").refers("material"),
      value<&EventSpec::species>("species", "", "Bodies get this species; all, or those in region or of material.")
          .refers("species"),
      value<&EventSpec::region>("region", "", "Which bodies get the species.").refers("region"),
      value<&EventSpec::material>("material", "", "Which bodies get the species.").refers("material"),
      value<&EventSpec::stop>("stop", "", "Ends the run."),
  };
}

}  // namespace

std::vector<Key> insertion_tables() {
  return {
      tables<&Scene::regions>("region", "A region of space.", region_keys()),
      tables<&Scene::species>("species", "A tag on bodies, to tell them apart in output.", species_keys()),
      tables<&Scene::fills>("fill", "Bodies in a region at the start, without overlap.", fill_keys()),
      tables<&Scene::rains>("rain", "Bodies that appear at a rate, without overlap.", rain_keys()),
      tables<&Scene::outlets>("outlet",
                              "Bodies whose centre is behind a plane or in a region are counted, and deleted or moved.",
                              outlet_keys()),
      tables<&Scene::events>("event", "Something that happens once, at a time or when a condition holds.",
                             event_keys()),
  };
}

}  // namespace dem
