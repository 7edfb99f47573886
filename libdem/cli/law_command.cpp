// dem law: one contact, led along a path or through an impact.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "libdem/cli/commands.h"
#include "libdem/cli/law_fit.h"
#include "libdem/io/files.h"
#include "libdem/io/programs.h"
#include "libdem/law_driver/curve.h"
#include "libdem/law_driver/spec.h"
#include "libdem/laws_of_scene.h"

namespace dem::cli {
namespace {

using namespace law_driver;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

void print_lost(const std::array<double, contact::mechanism_count>& lost) {
  for (std::size_t m = 0; m < lost.size(); ++m) fmt::print("  {:<24} {:.9g} J\n", contact::mechanism_names[m], lost[m]);
}

void print_impact(const Approach& how, const Rebound& r) {
  fmt::print("step                       {:.6g} s, {} in contact\n", how.dt, r.steps);
  if (!r.ended) {
    fmt::print("they stay together: no rebound within {:.6g} s\n", r.duration);
  } else {
    fmt::print("restitution                {:.9g}\n", r.restitution);
    if (how.tangential_speed != 0) fmt::print("tangential restitution     {:.9g}\n", r.tangential_restitution);
    fmt::print("rebound angle, centre      {:.6f} deg\n", degrees(std::atan2(r.tangential_speed, -r.normal_speed)));
    fmt::print("rebound angle, contact     {:.6f} deg\n", degrees(std::atan2(r.contact_slip, -r.normal_speed)));
    fmt::print("spin afterwards            {:.9g} rad/s, b {:.9g} rad/s\n", r.spin_a, r.spin_b);
  }
  fmt::print("duration                   {:.9g} s\n", r.duration);
  fmt::print("peak overlap               {:.9g} m\npeak force                 {:.9g} N\n", r.peak_overlap,
             r.peak_force);
  fmt::print("kinetic energy             {:.9g} J before, {:.9g} J after\nlost\n", r.kinetic_before, r.kinetic_after);
  print_lost(r.lost);
  fmt::print("worst energy balance       {:.3g} of the energy before\n", r.energy_error / r.kinetic_before);
}

void print_path(const PathResult& r) {
  fmt::print("peak overlap               {:.9g} m\nnormal force               {:.9g} N … {:.9g} N\n", r.peak_overlap,
             r.least_force, r.peak_force);
  fmt::print("peak tangential force      {:.9g} N\nwork on the contact        {:.9g} J\n", r.peak_tangential, r.work);
  fmt::print("stored at the end          {:.9g} J, {:.9g} J at most\nlost\n", r.stored, r.largest_stored);
  print_lost(r.lost);
}

std::vector<PathPoint> path_of(const LawTest& test) {
  if (!test.path.file.empty()) return read_path(test.path.file);
  std::vector<PathPoint> path;
  for (const auto& row : test.path.rows) path.push_back({row[0], row[1], row[2], row[3], 0});
  return path;
}

void draw(const Curve& curve, const std::string& file, const std::string& title) {
  if (!io::installed("gnuplot")) return fmt::print(stderr, "no picture: gnuplot is not installed\n");
  io::run_gnuplot(curve.gnuplot(file, title));
  fmt::print(stderr, "wrote {}\n", file);
}

}  // namespace

int law_command(const LawArguments& arguments) {
  const LawTest test = load_law_test(arguments.spec);
  if (!arguments.fit.empty()) return fit_law(test, arguments.fit);
  const std::string title = test.title.empty() ? law_title(test.scene.law) : test.title;
  if (!test.has_path && !test.has_impact) throw InputError(test.scene.path + ": needs [path] or [impact] (or --fit)");
  const Setup setup = setup_of(test);
  Curve curve;
  const bool wanted = !arguments.out.empty() || !arguments.plot.empty();
  const std::function<void(const Look&)> look = [&](const Look& l) { curve.add(l); };
  fmt::print("{}\n", title);
  fmt::print("law                        {}\nR*, m*                     {:.9g} m, {:.9g} kg\n",
             law_title(test.scene.law), setup.contact.radius_eff, setup.contact.mass_eff);
  if (test.has_impact) {
    const Approach how = approach_of(test, setup);
    print_impact(how, impact(setup.contact, setup.a, setup.b, how, wanted ? look : nullptr));
  } else {
    Drive drive(setup.contact);
    print_path(follow(drive, path_of(test), test.path.substeps, wanted ? look : nullptr));
  }
  if (!arguments.out.empty()) io::write_file(arguments.out, curve.csv());
  if (!arguments.plot.empty()) draw(curve, arguments.plot, title);
  return success;
}

}  // namespace dem::cli
