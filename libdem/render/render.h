// Pictures without a display: Embree casts rays at exact spheres and ellipsoids, and at triangles of polyhedra and
// walls. The same input gives the same bytes, whatever the number of threads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libdem/io/surfaces.h"
#include "libdem/world.h"

namespace dem::render {

struct Body {  // what a picture needs of a particle; read from a World or from a frame of the record
  shapes::Kind kind;
  const shapes::Polyhedron* polyhedron;  // of a polygon: a prism; null: round
  Vec3d size;                            // as Particles::size
  Vec3d position;
  Quatd orientation;
  double value;  // colour-by value; not a number: it has none, and is grey
};

// Colours from elsewhere: of the bodies in order of their ids. As Picture has them.
struct Colouring {
  std::string label;
  std::vector<std::string> names;
  std::vector<double> values;
};

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // width·height·3
};

struct Range {
  double lower, upper;
};

struct View {
  int width = 1200, height = 900;
  std::string color_by = "speed";      // speed | id | shape | size | material | species | force
  std::optional<Colouring> colouring;  // instead of color_by
  bool legend = true;
  std::optional<io::Box> box;  // what must be in the picture; default: picture_box (a movie keeps one for all frames)
  std::optional<Range> range;  // of the colours; default: of the values, without the highest 4 %
  std::optional<Vec3d> orthographic;  // look along this direction, in parallel projection; default: perspective
};

// What is drawn. `names` not empty: value is an index into it and colours are categories; else it is a quantity.
struct Picture {
  std::vector<Body> bodies;
  std::vector<io::WallSurface> walls;
  Vec3d up{0, 0, 1};
  std::string label;
  std::vector<std::string> names;
};

// Names that View::color_by knows.
const std::vector<std::string>& color_names();
// Bodies with their values, walls, up = against gravity. Seen along z, lines are strips of their solid, behind the
// bodies. RunError for an unknown color_by.
Picture picture_of(const World& world, const View& view);
// Particles and, unless they would shrink the particles to nothing, mesh walls.
io::Box picture_box(const World& world);

bool available();  // built with Embree
Image draw(const World& world, const View& view);
// view.box is needed here. A legend has a margin of its own to the right of the scene, unless the picture is narrow.
Image draw(const Picture& picture, const View& view);
void write_png(const std::string& path, const Image& image);

}  // namespace dem::render
