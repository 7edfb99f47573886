// The keys of [[wall]]: what it is, how it moves, what it reports.
#include <iterator>

#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem {

using bind::value;
using bind::word;

namespace {

void append(std::vector<Key>& keys, std::vector<Key> more) {
  keys.insert(keys.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<Key> generated_keys() {
  const std::vector<std::string> round{"cylinder", "cone", "drum"}, boxes{"box", "die"};
  return {
      value<&WallSpec::corner>("corner", "m", "A corner of the panel.").when("kind", {"panel"}).must(),
      value<&WallSpec::side_1>("side_1", "m", "Its side from there.").when("kind", {"panel"}).must(),
      value<&WallSpec::side_2>("side_2", "m", "Its other side from there.").when("kind", {"panel"}).must(),
      value<&WallSpec::lower>("lower", "m", "Lower corner of the box, or of the cavity of the die.")
          .when("kind", boxes)
          .must(),
      value<&WallSpec::upper>("upper", "m", "Upper corner; a die is open there, at upper.z.")
          .when("kind", boxes)
          .must(),
      value<&WallSpec::flange>("flange", "m", "Width of the table about the opening of the die.")
          .above(0)
          .when("kind", {"die"})
          .must(),
      value<&WallSpec::base>("base", "m", "Centre of the one end; of a V: where the axes of its arms meet.")
          .when("kind", {"cylinder", "cone", "drum", "v_shell"})
          .must(),
      value<&WallSpec::top>("top", "m", "Centre of the other end.").when("kind", round).must(),
      value<&WallSpec::radius>("radius", "m", "Radius through the corners of the facets.")
          .above(0)
          .when("kind", {"cylinder", "drum", "v_shell"})
          .must(),
      value<&WallSpec::base_radius>("base_radius", "m", "Radius at base.").from(0).when("kind", {"cone"}).must(),
      value<&WallSpec::top_radius>("top_radius", "m", "Radius at top.").from(0).when("kind", {"cone"}).must(),
      value<&WallSpec::angle>("angle", "rad", "Between the arms of the V, which lie in x-z, at angle / 2 from z.")
          .above(0)
          .to(3.1)
          .when("kind", {"v_shell"})
          .must(),
      value<&WallSpec::length>("length", "m", "Of the axis of each arm of the V.")
          .above(0)
          .when("kind", {"v_shell"})
          .must(),
      value<&WallSpec::segments>("segments", "", "Flat facets around.")
          .from(3)
          .to(10000)
          .when("kind", {"cylinder", "cone", "drum", "v_shell"}),
      value<&WallSpec::open>("open", "",
                             "Faces left out. Box: -x, +x, -y, +y, -z, +z; die: -z, its bottom; round ones: base, top; "
                             "v_shell: ends.")
          .one_of({"-x", "+x", "-y", "+y", "-z", "+z", "base", "top", "ends"})
          .when("kind", {"box", "die", "cylinder", "cone", "v_shell"}),
  };
}

std::vector<Key> motion_keys() {
  const std::vector<std::string> moving{"translation", "rotation", "oscillation", "table", "servo"};
  return {
      word<&WallSpec::motion>("motion", "How it moves: not at all, as prescribed, or as a servo that keeps a force.",
                              {"fixed", "translation", "rotation", "oscillation", "table", "servo"}),
      value<&WallSpec::velocity>("velocity", "m/s", "Velocity.").when("motion", {"translation"}).must(),
      value<&WallSpec::axis>("axis", "",
                             "Direction of the axis of rotation, or of the push of a servo on the bodies; any length.")
          .when("motion", {"rotation", "table", "servo"})
          .must_for({"rotation", "servo"}),
      value<&WallSpec::centre>("centre", "m", "A point on the axis.")
          .when("motion", {"rotation", "table"})
          .must_for({"rotation"}),
      value<&WallSpec::rate>("rate", "rad/s", "Angular velocity about the axis.").when("motion", {"rotation"}).must(),
      value<&WallSpec::amplitude>("amplitude", "m", "Displacement = amplitude · sin(2π · frequency · t + phase).")
          .when("motion", {"oscillation"})
          .must(),
      value<&WallSpec::frequency>("frequency", "Hz", "Frequency.").above(0).when("motion", {"oscillation"}).must(),
      value<&WallSpec::phase>("phase", "rad", "Phase.").when("motion", {"oscillation"}),
      value<&WallSpec::displacements>(
          "displacements", "s, m",
          "Rows [time since start, x, y, z] of displacement, straight in between, at rest before the first and after "
          "the last.")
          .when("motion", {"table"}),
      value<&WallSpec::turns>("turns", "s, rad", "Rows [time since start, angle about the axis], likewise.")
          .when("motion", {"table"}),
      value<&WallSpec::table_file>("table_file", "",
                                   "CSV with columns time and any of x, y, z (m), angle (rad), in place of both.")
          .as_file()
          .when("motion", {"table"}),
      value<&WallSpec::target_force>("target_force", "N", "Push along the axis to keep; give this or target_pressure.")
          .above(0)
          .when("motion", {"servo"}),
      value<&WallSpec::target_pressure>("target_pressure", "Pa", "Push to keep, per area.")
          .above(0)
          .when("motion", {"servo"}),
      value<&WallSpec::area>("area", "m^2",
                             "Area on which the pressure acts; a plane needs it, a mesh has its own along the axis.")
          .above(0)
          .when("motion", {"servo"}),
      value<&WallSpec::speed_limit>("speed_limit", "m/s", "Largest speed of the servo; its speed until it is in touch.")
          .above(0)
          .when("motion", {"servo"})
          .must(),
      value<&WallSpec::gain>("gain", "", "Speed of the servo per missing force, relative to the critically damped one.")
          .above(0)
          .to(1)
          .when("motion", {"servo"}),
      value<&WallSpec::start>("start", "s", "When the motion begins.").from(0).when("motion", moving),
      value<&WallSpec::stop>("stop", "s", "When the motion ends.").above(0).when("motion", moving),
      value<&WallSpec::pressure_map>("pressure_map", "",
                                     "Write the mean pressure and shear traction since the frame before, on each "
                                     "triangle, or on each square of a plane that was touched, into the frames of the "
                                     "walls.")
          .when("kind", {"plane", "mesh", "panel", "box", "cylinder", "cone", "drum", "die", "v_shell"}),
      value<&WallSpec::map_cell>("map_cell", "m",
                                 "Side of the squares of a plane's map; wall.point is a corner of four of them.")
          .above(0)
          .when("kind", {"plane"}),
      value<&WallSpec::present>("present", "", "Whether it is there at the start; an event may insert or remove it."),
      value<&WallSpec::remove_at>("remove_at", "s", "When the wall is taken away (a gate).").from(0),
  };
}

}  // namespace

std::vector<Key> wall_keys() {
  std::vector<Key> keys{
      value<&WallSpec::name>("name", "", "Name in messages and output.").own_name(),
      value<&WallSpec::kind>(
          "kind", "",
          "Infinite plane (2-D: line, polygon, or a polyline with solid on one side), triangle mesh, or a mesh made of "
          "a few numbers.")
          .one_of({"plane", "line", "polygon", "polyline", "mesh", "panel", "box", "cylinder", "cone", "drum", "die",
                   "v_shell"})
          .must(),
      value<&WallSpec::material>("material", "", "Its material.").refers("material").must(),
      value<&WallSpec::point>("point", "m", "A point on the plane or line.").when("kind", {"plane", "line"}).must(),
      value<&WallSpec::normal>("normal", "", "Out of the wall, towards the bodies; any length.")
          .when("kind", {"plane", "line"})
          .must(),
      value<&WallSpec::file>("file", "", "OFF, OBJ or STL file; give this, or vertices and triangles.")
          .as_file()
          .when("kind", {"mesh"}),
      value<&WallSpec::scale>("scale", "", "Factor on the coordinates of the mesh.").above(0).when("kind", {"mesh"}),
      value<&WallSpec::vertices>("vertices", "m",
                                 "Vertices of the mesh; of the polygon, in order; of the polyline, with the bodies on "
                                 "the left of the way from one to the next.")
          .when("kind", {"mesh", "polygon", "polyline"})
          .must_for({"polygon", "polyline"}),
      value<&WallSpec::depth>("depth", "m",
                              "How deep the solid is on the right of the polyline; its back is a wall too.")
          .above(0)
          .when("kind", {"polyline"})
          .must(),
      value<&WallSpec::closed>("closed", "",
                               "Whether the last vertex is joined to the first: a ring; counter-clockwise, the bodies "
                               "are within.")
          .when("kind", {"polyline"}),
      value<&WallSpec::triangles>("triangles", "", "Triangles as indices of vertices, from 0.")
          .from(0)
          .to(4294967295.0)
          .when("kind", {"mesh"}),
  };
  append(keys, generated_keys());
  append(keys, motion_keys());
  return keys;
}

}  // namespace dem
