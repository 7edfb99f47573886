// What `dem law` reads: laws and materials with the keys of a scene, two bodies, and what happens to them.
#pragma once

#include <string>
#include <vector>

#include "libdem/law_driver/path.h"
#include "libdem/scene/scene.h"

namespace dem::law_driver {

struct BodyOfTest {
  double radius = 0, mass = 0, density = 0;  // m, kg, kg/m³; 0: not given
  std::string material;                      // empty: a has the first one, b the last
};

struct PathOfTest {
  std::string file;
  std::vector<std::array<double, 4>> rows;  // t, overlap, slip_x, slip_y
  int substeps = 1;
};

struct ImpactOfTest {
  double speed = 0, angle_deg = 0;                // m/s; from the normal
  double normal_speed = 0, tangential_speed = 0;  // m/s, in place of the two
  double spin = 0, spin_b = 0;                    // rad/s
  double dt = 0;                                  // s; 0: automatic
  int steps_per_contact = 0;                      // in place of dt
  double phase = 0;
  double normal() const;
  double tangential() const;
};

struct FitOfTest {
  std::vector<std::string> parameters;
};

// One test: the scene holds law, materials and pairs of materials only.
struct LawTest {
  std::string title;
  Scene scene;
  BodyOfTest a, b;
  PathOfTest path;
  ImpactOfTest impact;
  FitOfTest fit;
  bool has_path = false, has_impact = false;
};

// Throws InputError with file:line:column.
LawTest load_law_test(const std::string& file);

// What such a test drives. Friction and the rest are those of the pair of materials.
struct Setup {
  LawContact contact;
  Ball a, b;
};
Setup setup_of(const LawTest& test);

// Head-on: the contact's duration at the automatic step, s; of one that does not end twice the time to its largest
// overlap.
double contact_duration(const Setup& setup, double normal_speed);
// The approach that the test states, with its step resolved.
Approach approach_of(const LawTest& test, const Setup& setup);

}  // namespace dem::law_driver
