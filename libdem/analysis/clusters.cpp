#include "libdem/analysis/clusters.h"

#include <algorithm>
#include <numeric>

namespace dem::analysis {

namespace {

Clusters::Shift sum(const Clusters::Shift& a, const Clusters::Shift& b, int sign = 1) {
  return {a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]};
}

}  // namespace

Clusters::Clusters(std::size_t count)
    : parent_(count), size_(count, 1), marks_(count, 0), winding_(count, 0), shift_(count) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

std::uint32_t Clusters::find(std::uint32_t i) {
  path_.clear();
  while (parent_[i] != i) {
    path_.push_back(i);
    i = parent_[i];
  }
  for (std::size_t k = path_.size(); k-- > 0;) {  // from the root down: shifts add up, everyone hangs on the root
    const std::uint32_t p = path_[k], up = parent_[p];
    if (up != i) shift_[p] = sum(shift_[p], shift_[up]);
    parent_[p] = i;
  }
  return i;
}

void Clusters::join(std::uint32_t a, std::uint32_t b, const Shift& shift) {
  std::uint32_t ra = find(a), rb = find(b);
  // b's image in the frame of a is b + shift; where b stands in the frame of a's root:
  Shift between = sum(sum(shift_[a], shift), shift_[b], -1);  // frame of rb as seen from ra
  if (ra == rb) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (between[axis] != 0) winding_[ra] |= 1u << axis;
    return;
  }
  if (size_[ra] < size_[rb]) {
    std::swap(ra, rb);
    between = sum({}, between, -1);
  }
  parent_[rb] = ra;
  shift_[rb] = between;
  size_[ra] += size_[rb];
  marks_[ra] |= marks_[rb];
  winding_[ra] |= winding_[rb];
}

void Clusters::mark(std::uint32_t i, std::uint32_t marks) { marks_[find(i)] |= marks; }

Clusters::List Clusters::list(std::uint32_t least) {
  const auto count = static_cast<std::uint32_t>(parent_.size());
  std::vector<std::uint32_t> smallest;  // of each component that is large enough, in order of the bodies
  std::vector<std::uint8_t> seen(count, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t root = find(i);
    if (seen[root] == 0 && size_[root] >= least) smallest.push_back(i);
    seen[root] = 1;
  }
  std::stable_sort(smallest.begin(), smallest.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return size(a) > size(b); });
  List result;
  std::vector<std::uint32_t> place(count, none);
  for (std::uint32_t k = 0; k < smallest.size(); ++k) {
    place[find(smallest[k])] = k;
    result.sizes.push_back(size(smallest[k]));
  }
  for (std::uint32_t i = 0; i < count; ++i) result.of_body.push_back(place[find(i)]);
  return result;
}

}  // namespace dem::analysis
