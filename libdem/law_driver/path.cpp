#include "libdem/law_driver/path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/io/io.h"

namespace dem::law_driver {

std::vector<PathPoint> read_path(const std::string& file) {
  const io::Table t = io::read_csv(file);
  const std::size_t time = io::column(t, "t"), overlap = io::column(t, "overlap"), x = io::column(t, "slip_x"),
                    y = io::column(t, "slip_y");
  const auto rotation = io::find_column(t, "rotation");
  std::vector<PathPoint> path;
  for (std::size_t r = 0; r < t.row_count(); ++r) {
    path.push_back({io::number(t, r, time), io::number(t, r, overlap), io::number(t, r, x), io::number(t, r, y),
                    rotation ? io::number(t, r, *rotation) : 0});
    if (r > 0 && !(path[r].time > path[r - 1].time))
      input_error(t.where(r, time), fmt::format("t = {}: must be larger than that of the row before, {}", path[r].time,
                                                path[r - 1].time));
  }
  if (path.size() < 2) input_error({file, t.header_line, 0}, "a path needs two rows at least");
  return path;
}

PathResult follow(Drive& drive, const std::vector<PathPoint>& path, int substeps,
                  const std::function<void(const Look&)>& look) {
  PathResult out;
  Move move;
  double slip_x = path.front().slip_x, slip_y = path.front().slip_y, force = 0;
  Vec3d tangential{};
  const auto step = [&](double time) {
    const Answer& a = drive.step(move);
    out.peak_overlap = std::max(out.peak_overlap, move.overlap);
    out.peak_force = std::max(out.peak_force, a.normal);
    out.least_force = std::min(out.least_force, a.normal);
    out.peak_tangential = std::max(out.peak_tangential, norm(a.tangential));
    out.largest_stored = std::max(out.largest_stored, a.energy);
    out.work += 0.5 * move.dt *
                ((force + a.normal) * move.velocity.z +
                 dot(tangential + a.tangential, Vec3d{move.velocity.x, move.velocity.y, 0}));
    force = a.normal;
    tangential = a.tangential;
    if (look) look({time, move.overlap, slip_x, slip_y, move, drive});
  };
  move.overlap = path.front().overlap;
  step(path.front().time);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PathPoint &from = path[i - 1], &to = path[i];
    const double span = to.time - from.time;
    move.dt = span / substeps;
    const double d = to.overlap - from.overlap, x = to.slip_x - from.slip_x, y = to.slip_y - from.slip_y;
    move.velocity = Vec3d{x, y, d} * (1 / span);
    move.turn = (to.rotation - from.rotation) / span;
    for (int k = 1; k <= substeps; ++k) {
      const double part = static_cast<double>(k) / substeps;
      move.overlap = k == substeps ? to.overlap : from.overlap + part * d;
      slip_x = from.slip_x + part * x;
      slip_y = from.slip_y + part * y;
      step(from.time + part * span);
    }
  }
  out.stored = drive.answer().energy;
  for (std::size_t m = 0; m < out.lost.size(); ++m) out.lost[m] = drive.lost(static_cast<contact::Mechanism>(m));
  return out;
}

}  // namespace dem::law_driver
