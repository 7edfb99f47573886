#include "libdem/validate/held_states.h"

#include "libdem/deformation.h"

namespace dem::validate {

namespace {

HeldState state_of(const World& w) {
  const Mat3d stress = cell_stress(w);
  const Coordination z = coordination(w);
  return {(stress.row[0].x + stress.row[1].y + stress.row[2].z) / 3, solid_fraction(w), z.backbone, z.rattlers};
}

}  // namespace

std::vector<HeldState> held_states(Runs& runs, const std::vector<std::string>& overrides, const std::string& label) {
  std::vector<HeldState> states;
  const World last = runs.run(overrides, label, [&](const World& w) {
    const auto& entries = w.scene.periodic.deform;
    const std::size_t next = states.size() + 1;
    if (next < entries.size() && w.time() + w.time_step.dt >= entries[next].start) states.push_back(state_of(w));
  });
  states.push_back(state_of(last));
  return states;
}

Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double mx = 0, my = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mx += x[i] / n;
    my += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mx) * (x[i] - mx);
    sxy += (x[i] - mx) * (y[i] - my);
  }
  Line line;
  line.slope = sxy / sxx;
  line.at_zero = my - line.slope * mx;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = y[i] - line.at_zero - line.slope * x[i];
    line.misfit += d * d;
  }
  return line;
}

}  // namespace dem::validate
