#include "libdem/analysis/box_share.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "libdem/analysis/round_in_box.h"

namespace dem::analysis {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
using shapes::HalfSpace;
using shapes::Kind;

std::array<HalfSpace, 6> planes_of(const Grid::Box& box) {
  return {{{{-1, 0, 0}, -box.lower.x},
           {{1, 0, 0}, box.upper.x},
           {{0, -1, 0}, -box.lower.y},
           {{0, 1, 0}, box.upper.y},
           {{0, 0, -1}, -box.lower.z},
           {{0, 0, 1}, box.upper.z}}};
}

double ellipse_in_planes(std::span<const HalfSpace> planes) {  // of the unit disc
  CutSolid s = CutSolid::box({-1.5, -1.5, 0}, {1.5, 1.5, 1});
  for (const HalfSpace& h : planes) s.cut(h.normal, h.offset);
  DiscSums sums;
  for (const CutSolid::Face& f : s.faces()) {
    if (!(f.normal.z > 0.5)) continue;
    const auto c = s.corners(f);
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Vec3d &p = c[i], &q = c[i + 1 == c.size() ? 0 : i + 1];
      add_edge_in_disc(p.x, p.y, q.x, q.y, 1, sums);
    }
  }
  return std::clamp(sums.area, 0.0, pi);
}

double ball_in_planes(std::span<const HalfSpace> planes) {  // of the unit ball
  CutSolid s = CutSolid::box({-1, -1, -1}, {1, 1, 1});
  for (const HalfSpace& h : planes) s.cut(h.normal, h.offset);
  return volume_in_ball(s, RoundFrame{});
}

double pieces_in_planes(const BodyPieces& body, std::span<const HalfSpace> planes) {
  double sum = 0;
  std::vector<const HalfSpace*> cutting;
  for (const BodyPiece& piece : body.pieces) {
    cutting.clear();
    bool outside = false;
    for (const HalfSpace& h : planes) {
      const double height = dot(h.normal, piece.middle) - h.offset;
      outside = outside || height >= piece.reach;
      if (height > -piece.reach) cutting.push_back(&h);
    }
    if (outside) continue;
    if (cutting.empty()) {
      sum += piece.volume;
      continue;
    }
    CutSolid cut = piece.solid;
    for (const HalfSpace* h : cutting) cut.cut(h->normal, h->offset);
    sum += piece.volume_of(cut);
  }
  return sum;
}

bool is_ellipsoidal(Kind k) {
  return k == Kind::sphere || k == Kind::disc || k == Kind::ellipsoid || k == Kind::ellipse;
}

}  // namespace

BoxShares::BoxShares(const Snapshot& snapshot) : s_(snapshot) {
  for (const ShapeEntry& shape : s_.shapes) {
    pieces_.push_back(pieces_of(shape));
    if (!pieces_.back().exact)
      notes_.push_back(
          fmt::format("shares of \"{}\" that box faces cut are approximate: its ellipsoids overlap other "
                      "round parts, and the overlap ({:.2g} of the body) is counted for both",
                      shape.name, pieces_.back().volume / shape.volume - 1));
  }
}

Grid::Box BoxShares::bounds(std::size_t i) const {
  const Kind kind = s_.shape_of(i).kind;
  const Vec3d& x = s_.position[i];
  double r = s_.bounding_radius[i];
  if (is_round(kind)) r = s_.size[i].x;
  Vec3d low{-r, -r, -r}, high{r, r, r};
  if (kind == Kind::ellipsoid || kind == Kind::ellipse) {
    const Mat3d turn = rotation_matrix(s_.orientation[i]);
    for (int k = 0; k < 3; ++k) low[k] = -(high[k] = norm(scaled(turn.row[k], s_.size[i])));
  } else if (kind == Kind::polyhedron) {
    const Mat3d turn = rotation_matrix(s_.orientation[i]);
    low = {r, r, r}, high = -low;
    for (const Vec3d& v : s_.shape_of(i).polyhedron->vertices) {
      const Vec3d at = s_.size[i].x * (turn * v);
      for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
    }
  }
  return {x + low, x + high};
}

double BoxShares::in_half_spaces(std::size_t i, const Vec3d& shift, std::span<const HalfSpace> planes) const {
  const ShapeEntry& shape = s_.shape_of(i);
  const Vec3d centre = s_.position[i] + shift;
  const double reach = s_.bounding_radius[i];
  std::vector<HalfSpace> near;
  Grid::Box box{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  bool upright = true;  // all of them along axes
  for (const HalfSpace& h : planes) {
    const double height = dot(h.normal, centre) - h.offset;
    if (height >= reach) return 0;
    if (height <= -reach) continue;
    near.push_back(h);
    int axis = 0;
    while (axis < 3 && std::fabs(h.normal[axis]) != 1) ++axis;
    if (axis == 3)
      upright = false;
    else if (h.normal[axis] > 0)
      box.upper[axis] = std::min(box.upper[axis], h.offset);
    else
      box.lower[axis] = std::max(box.lower[axis], -h.offset);
  }
  const double volume = s_.volume[i];
  if (near.empty()) return volume;
  if (is_round(shape.kind) && upright) return in_box(i, shift, box);

  // In the body frame at scale 1; of ellipsoids in the frame in which they are the unit ball.
  const bool round = is_ellipsoidal(shape.kind);
  const Vec3d scale = round ? s_.size[i] : Vec3d{s_.size[i].x, s_.size[i].x, s_.size[i].x};
  const Mat3d turn = rotation_matrix(s_.orientation[i]);
  for (HalfSpace& h : near) {
    const Vec3d n = scaled(transposed_times(turn, h.normal), scale);
    const double length = norm(n);
    h = {n * (1 / length), (h.offset - dot(h.normal, centre)) / length};
  }
  if (!round) {
    const BodyPieces& pieces = pieces_[s_.shape[i]];
    return volume * std::clamp(pieces_in_planes(pieces, near) / pieces.volume, 0.0, 1.0);
  }
  const bool one = near.size() == 1;
  if (s_.dimension == 2) return volume * ((one ? unit_disc_below(near[0].offset) : ellipse_in_planes(near)) / pi);
  return volume * ((one ? unit_ball_below(near[0].offset) : ball_in_planes(near)) / (4 * pi / 3));
}

double BoxShares::in_box(std::size_t i, const Vec3d& shift, const Grid::Box& box) const {
  const Kind kind = s_.shape_of(i).kind;
  const Vec3d centre = s_.position[i] + shift;
  const double r = s_.size[i].x;
  if (is_round(kind)) {
    if (s_.dimension == 2) return s_.volume[i] * (disc_in_box(centre, r, box.lower, box.upper) / (pi * r * r));
    return s_.volume[i] * (ball_in_box(centre, r, box.lower, box.upper) / (4 * pi / 3 * r * r * r));
  }
  const auto planes = planes_of(box);
  return in_half_spaces(i, shift, std::span(planes).first(s_.dimension == 2 ? 4 : 6));
}

std::vector<BoxShare> BoxShares::on(const Grid& grid) const {
  constexpr std::size_t chunk = 512;
  const std::size_t chunks = (s_.count() + chunk - 1) / chunk;
  std::vector<std::vector<BoxShare>> found(chunks);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t c = 0; c < chunks; ++c)
    for (std::size_t i = c * chunk; i < std::min(s_.count(), (c + 1) * chunk); ++i) {
      const auto add = [&](std::size_t place, double volume) {
        if (volume > 0) found[c].push_back({static_cast<std::uint32_t>(i), place, volume});
      };
      const auto whole = [&](const Grid::Box& body, const Vec3d& shift, const Grid::Box& box) {
        bool in = true;
        for (int k = 0; k < s_.dimension; ++k)
          in = in && body.lower[k] + shift[k] >= box.lower[k] && body.upper[k] + shift[k] <= box.upper[k];
        return in;
      };
      const Vec3d reach{s_.bounding_radius[i], s_.bounding_radius[i], s_.bounding_radius[i]};
      const std::size_t here = grid.index(s_.position[i]);
      if (here != Grid::none && whole({s_.position[i] - reach, s_.position[i] + reach}, {}, grid.box(here))) {
        add(here, s_.volume[i]);
        continue;
      }
      const Grid::Box body = bounds(i);
      grid.each_touched(body.lower, body.upper, [&](std::size_t place, const Vec3d& shift) {
        const Grid::Box box = grid.box(place);
        add(place, whole(body, shift, box) ? s_.volume[i] : in_box(i, shift, box));
      });
    }
  std::vector<BoxShare> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace dem::analysis
