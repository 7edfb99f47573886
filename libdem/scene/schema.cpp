// The schema table itself: one line per key. The order is the order of the reference page and of a written scene.
#include "libdem/scene/schema.h"

#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem {

namespace {

using bind::heading;
using bind::table;
using bind::tables;
using bind::value;
using bind::word;

template <auto Number, auto IsAuto>
Key number_or_auto(std::string name, std::string unit, std::string sentence) {
  Key key = value<Number>(std::move(name), std::move(unit), std::move(sentence));
  key.type = KeyType::number_or_auto;
  using Spec = typename decltype(bind::split(Number))::Class;
  key.set = [](void* spec, const Node& n) {
    static_cast<Spec*>(spec)->*IsAuto = n.kind == Node::Kind::text;
    if (n.is_number()) static_cast<Spec*>(spec)->*Number = n.as_number();
  };
  key.get = [](const void* spec) {
    const Spec& s = *static_cast<const Spec*>(spec);
    return s.*IsAuto ? Node::of(std::string("auto")) : Node::of(s.*Number);
  };
  return key;
}

Key skin() {
  Key key =
      value<&RunSpec::skin>("skin", "m",
                            "Distance that the neighbour list adds to pairs; auto: of each body as its speed asks for, "
                            "tuned as the run goes. The result does not depend on it.");
  key.type = KeyType::number_or_auto;
  key.set = [](void* spec, const Node& n) { static_cast<RunSpec*>(spec)->skin = n.is_number() ? n.as_number() : -1; };
  key.get = [](const void* spec) {
    const double s = static_cast<const RunSpec*>(spec)->skin;
    return s < 0 ? Node::of(std::string("auto")) : Node::of(s);
  };
  return key;
}

// Read and taken out before the rest of a scene: a resolved scene has none.
Key include() {
  Key key;
  key.name = "include";
  key.type = KeyType::texts;
  key.sentence =
      "TOML files that are read before this one, relative to it: arrays of tables add up, any other key here replaces "
      "theirs.";
  key.set = [](void*, const Node&) {};
  key.get = [](const void*) { return Node::array_of({}); };
  return key;
}

Key uncertified_share() {
  Key key = value<&RunSpec::max_uncertified_share>(
      "max_uncertified_share", "",
      "Share of contact-steps that may be uncertified or not converged before the run stops.");
  key.set = [](void* spec, const Node& n) { bind::from_node(n, static_cast<Scene*>(spec)->run.max_uncertified_share); };
  key.get = [](const void* spec) { return Node::of(static_cast<const Scene*>(spec)->run.max_uncertified_share); };
  return key;
}

std::vector<Key> run_keys() {
  return {
      value<&RunSpec::time>("time", "s", "Simulated time; give this or run.steps.").above(0),
      value<&RunSpec::steps>("steps", "", "Number of steps; give this or run.time.").from(1),
      number_or_auto<&RunSpec::dt, &RunSpec::dt_auto>(
          "dt", "s", "Time step; auto = run.dt_fraction of the smallest stability limit.")
          .above(0),
      value<&RunSpec::dt_fraction>("dt_fraction", "", "Automatic time step divided by the smallest stability limit.")
          .above(0)
          .to(0.5),
      value<&RunSpec::dt_overlap>(
          "dt_overlap", "",
          "Overlap, in smaller radii, at which the stiffness of nonlinear laws is judged for the limit.")
          .above(0)
          .to(0.5),
      value<&RunSpec::dt_contacts>("dt_contacts", "", "Contacts per body whose stiffness is summed for the limit.")
          .from(1)
          .to(100),
      value<&RunSpec::until>("until", "",
                             "Condition that ends the run before its time, like \"kinetic_energy < 1e-9\"; looked at "
                             "every run.check_every steps.")
          .as_condition(),
      value<&RunSpec::check_every>("check_every", "", "Steps between looks at run.until and event.when.").from(1),
      skin().above(0),
      value<&RunSpec::rebuild_every>(
          "rebuild_every", "",
          "Steps between rebuilds of the neighbour list; 0 = when a body has moved by half the skin.")
          .from(0),
      value<&RunSpec::turn_spheres>("turn_spheres", "",
                                    "false: spheres and discs keep the orientation they began with, which no contact "
                                    "asks for, and their rotation is not added up; all else is the same, and faster."),
      value<&RunSpec::seed>("seed", "", "Seed of the random numbers that place and turn the bodies of a fill.").from(0),
      value<&RunSpec::max_initial_overlap>("max_initial_overlap", "",
                                           "Largest overlap at the start, in smaller inscribed radii; more is refused.")
          .from(0)
          .to(1),
  };
}

std::vector<Key> output_keys() {
  return {
      value<&OutputSpec::interval>("interval", "s", "Simulated time between frames; 0 = only the first and the last.")
          .from(0),
      value<&OutputSpec::checkpoint_interval>(
          "checkpoint_interval", "s", "Simulated time between checkpoints; 0 = at the end and on an interrupt only.")
          .from(0),
      value<&OutputSpec::cell_interval>("cell_interval", "s",
                                        "Simulated time between rows of cell.csv (periodic box); 0 = with the frames.")
          .from(0),
      value<&OutputSpec::walls_interval>("walls_interval", "s",
                                         "Simulated time between rows of walls.csv; 0 = with the frames.")
          .from(0),
      value<&OutputSpec::vtk>("vtk", "", "Write frames for ParaView (frames.pvd)."),
      value<&OutputSpec::hdf5>("hdf5", "", "Write frames into the record (record.h5)."),
      value<&OutputSpec::picture>("picture", "", "Draw the final state (final.png)."),
      value<&OutputSpec::walls>("walls", "", "Write force, torque, power of the walls over time (walls.csv)."),
  };
}

std::vector<Key> shape_keys() {
  const std::vector<std::string> platonic{"tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"};
  std::vector<std::string> kinds{"sphere",  "ellipsoid",       "disc", "ellipse",
                                 "polygon", "regular_polygon", "box",  "prism"};
  kinds.insert(kinds.end(), platonic.begin(), platonic.end());
  kinds.insert(kinds.end(), {"polyhedron", "potential_particle", "generated", "voronoi", "clump", "union"});
  std::vector<std::string> round{"prism", "regular_polygon"};
  round.insert(round.end(), platonic.begin(), platonic.end());
  std::vector<std::string> flat{"box", "prism"};
  flat.insert(flat.end(), platonic.begin(), platonic.end());
  flat.insert(flat.end(), {"polyhedron", "generated", "voronoi"});
  std::vector<Key> keys{
      value<&ShapeSpec::name>("name", "", "Name by which bodies refer to it.").own_name(),
      value<&ShapeSpec::kind>("kind", "", "What it is.").one_of(kinds).must(),
      value<&ShapeSpec::radius>("radius", "m", "Radius.").above(0).when("kind", {"sphere", "disc"}).must(),
      value<&ShapeSpec::semi_axes>("semi_axes", "m", "Semi-axes along x, y, z.")
          .above(0)
          .when("kind", {"ellipsoid"})
          .must(),
      value<&ShapeSpec::semi_axis_a>("semi_axis_a", "m", "Semi-axis along x.")
          .above(0)
          .when("kind", {"ellipse"})
          .must(),
      value<&ShapeSpec::semi_axis_b>("semi_axis_b", "m", "Semi-axis along y.")
          .above(0)
          .when("kind", {"ellipse"})
          .must(),
      value<&ShapeSpec::extents>("extents", "m", "Full edge lengths along x, y, z.")
          .above(0)
          .when("kind", {"box"})
          .must(),
      value<&ShapeSpec::sides>("sides", "", "Number of side faces, of a polygon: of sides.")
          .from(3)
          .to(1000)
          .when("kind", {"prism", "regular_polygon"})
          .must(),
      value<&ShapeSpec::circumradius>(
          "circumradius", "m",
          "Radius of the sphere (prism: of the base's circle; polygon: of the circle) through the vertices.")
          .above(0)
          .when("kind", round)
          .must(),
      value<&ShapeSpec::height>("height", "m", "Height along z.").above(0).when("kind", {"prism"}).must(),
      value<&ShapeSpec::vertices>(
          "vertices", "m",
          "Polyhedron: points whose convex hull is the body; give this, half_spaces or file. Polygon: its "
          "corners in order, [x, y, 0]; it is centred on its centroid.")
          .when("kind", {"polyhedron", "polygon"}),
      value<&ShapeSpec::pieces>("pieces", "m",
                                "In place of a polygon's vertices: outlines [[x, y, 0], …] of pieces that share edges, "
                                "welded into one body; how it was cut does not matter.")
          .when("kind", {"polygon"}),
      value<&ShapeSpec::half_spaces>("half_spaces", "m",
                                     "Half-spaces n·x <= offset whose intersection is the body; of a "
                                     "potential particle its planes, about the origin inside.")
          .when("kind", {"polyhedron", "potential_particle"})
          .must_for({"potential_particle"}),
      value<&ShapeSpec::file>(
          "file", "",
          "OFF, OBJ or STL file of a closed convex mesh, or a shipped one: grain:NAME, grain-fine:NAME, solid:NAME.")
          .as_file()
          .when("kind", {"polyhedron"}),
      value<&ShapeSpec::diameter>(
          "diameter", "m", "Rescales the body to the volume of a sphere of this diameter; needed by shipped shapes.")
          .above(0)
          .when("kind", {"polyhedron", "potential_particle", "clump", "generated", "voronoi"})
          .must_for({"generated", "voronoi"}),
      value<&ShapeSpec::rounding>("rounding", "m",
                                  "Rounds edges and corners: the body is all that lies within this distance of the "
                                  "polyhedron (shape.diameter is that of the whole).")
          .above(0)
          .when("kind", flat),
      value<&ShapeSpec::k>("k", "",
                           "Share of the sphere in (1-k)[sum <a.x-d>^2/r^2 - 1] + k[x^2/R^2 - 1] <= 0: 1 is the "
                           "sphere, a small one leaves flat faces.")
          .above(0)
          .to(1)
          .when("kind", {"potential_particle"})
          .must(),
      value<&ShapeSpec::r>("r", "m", "How far the faces stand out from their planes, which is what rounds the edges.")
          .above(0)
          .when("kind", {"potential_particle"})
          .must(),
      value<&ShapeSpec::R>("R", "m", "Radius of the sphere.").above(0).when("kind", {"potential_particle"}).must(),
  };
  for (auto* more : {part_keys, grain_keys})
    for (Key& key : more()) keys.push_back(std::move(key));
  return keys;
}

std::vector<Key> body_keys() {
  return {
      value<&BodySpec::shape>("shape", "", "Its shape.").refers("shape").must(),
      value<&BodySpec::material>("material", "", "Its material.").refers("material").must(),
      value<&BodySpec::species>("species", "", "Its species.").refers("species"),
      value<&BodySpec::scale>("scale", "", "Factor on the size of the shape.").above(0),
      value<&BodySpec::position>("position", "m", "Centre of mass.").must(),
      value<&BodySpec::orientation>("orientation", "", "Unit quaternion w, x, y, z: body axes to world axes."),
      value<&BodySpec::velocity>("velocity", "m/s", "Initial velocity."),
      value<&BodySpec::spin>("spin", "rad/s", "Initial angular velocity, world axes."),
  };
}

// Written where the scene asks for something alone.
Key analysis() {
  Key key = table<&Scene::analysis>("analysis", "What a run finds out about itself as it goes.", analysis_keys());
  key.count = [](const void* scene) -> std::size_t {
    return static_cast<const Scene*>(scene)->analysis.what.empty() ? 0 : 1;
  };
  return key;
}

std::shared_ptr<const Section> whole() {
  std::vector<Key> keys{
      include(),
      value<&Scene::title>("title", "", "One line about the scene."),
      table<&Scene::run>("run", "Time, step and neighbour list.", run_keys()),
      table<&Scene::output>("output", "What a run writes, and when.", output_keys()),
      analysis(),
      heading<Scene>(
          "world", "What surrounds the bodies.",
          {value<&Scene::gravity>("gravity", "m/s^2", "Acceleration of gravity; [0, 0, 0] for none.").must(),
           value<&Scene::dimension>("dimension", "", "3, or 2 for bodies that move in the plane z = 0.").from(2).to(3),
           word<&Scene::disc_model>("disc_model", "2-D bodies: prisms of world.thickness, or (discs only) spheres.",
                                    {"prism", "sphere"}),
           value<&Scene::thickness>("thickness", "m", "Thickness of the prisms; needed where dimension = 2.").above(0)})
          .must(),
      table<&Scene::periodic>("periodic", "Periodic boundaries.", periodic_keys()),
      table<&Scene::drag>("drag", "The drag of a given flow on the bodies.", drag_keys()),
      heading<Scene>(
          "contact", "How contacts are detected.",
          {value<&Scene::method>("method", "",
                                 "Name of a detection method, or auto = the cheapest certified one of each pair."),
           value<&Scene::tolerance>("tolerance", "",
                                    "With method auto: the cheapest method that proves each gap to within this part of "
                                    "the smaller circumradius; 0 = exact.")
               .from(0)
               .to(0.1),
           uncertified_share().from(0).to(1)}),
      table<&Scene::law>("law", "The force law.", law_keys()).must(),
      tables<&Scene::materials>("material", "A material.", material_keys()).must(),
      tables<&Scene::pairs>("material_pair", "What two materials do together, in place of the mixed values.",
                            pair_keys()),
      tables<&Scene::shapes>("shape", "A shape of bodies.", shape_keys()).must(),
      tables<&Scene::walls>("wall", "A wall.", wall_keys()),
      tables<&Scene::bodies>("body", "One body.", body_keys()),
      tables<&Scene::csv>(
          "bodies_csv", "Bodies from a CSV or CSV.gz file with columns x, y, z and radius or scale.",
          {value<&CsvSpec::file>("file", "", "The file.").as_file().must(),
           value<&CsvSpec::shape>("shape", "", "Their shape, where the file has no such column.").refers("shape"),
           value<&CsvSpec::material>("material", "", "Their material, where the file has no such column.")
               .refers("material")}),
  };
  for (Key& key : insertion_tables()) keys.push_back(std::move(key));
  return bind::section<Scene>(std::move(keys));
}

}  // namespace

const Section& schema() {
  static const std::shared_ptr<const Section> root = whole();
  return *root;
}

}  // namespace dem
