// What a corner or a side of a convex part has about it, in rows of doubles that kernels load whole.
#pragma once

namespace shapes {

// How a side that is a cut begins at its nearer corner: at the reflex corner that the whole cut begins at, or not.
enum class CutMark { outline, from_reflex, other };

// Corners are x, y, m; marks are those of CutMark.
struct alignas(64) CornerRow {
  double corner[2], left[2][2], right[2][2];  // itself; the two after it, the two before it, nearest first
  double far[2];                              // half the way round
  double cut_left[2], cut_right[2];           // marks of the sides between them, nearest first
};
struct alignas(64) SideRow {
  double before[2], start[2], end[2], after[2];  // its ends, and the corners next to them
  double normal[2], offset;
  double cut;                    // mark of the side itself
  double cut_before, cut_after;  // of its neighbours, as seen from it
  double unused[2];
};
static_assert(sizeof(CornerRow) == 16 * sizeof(double) && sizeof(SideRow) == 16 * sizeof(double));

struct Polygon;
// Fills the rows of all parts, from what else is known of them.
void make_rows(Polygon& p);

}  // namespace shapes
