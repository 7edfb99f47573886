// Symmetric tensors of second order: principal values, deviator, and their place in a result.
#pragma once

#include <array>
#include <string>

#include "libdem/analysis/result.h"
#include "shapes/math/vec.h"

namespace dem::analysis {

using shapes::Mat3d;
using shapes::Vec3d;

// Values in falling order with unit axes, whose largest component is positive. In the plane the first two lie in it,
// the third is z. Error a few ulp of the largest value.
struct Principal {
  std::array<double, 3> value{};
  std::array<Vec3d, 3> axis{};
};
Principal principal_of(const Mat3d& symmetric, int dimension);

// √(3/2 T':T'), in the plane √(2 T':T') = T1 − T2, of the traceless part; the same where two principal values are
// equal.
double deviator(const Mat3d& symmetric, int dimension);

Mat3d outer(const Vec3d& a, const Vec3d& b);
void add_to(Mat3d& sum, const Mat3d& term, double factor = 1);
double trace(const Mat3d& m);

// name_xx, name_yy, name_xy (and in space name_zz, name_xz, name_yz), the symmetric part; the scalars of its principal
// values name_1, name_2 (name_3) and of its deviator.
void add_tensor(Result& result, const std::string& name, const std::string& unit, const Mat3d& m, int dimension);
// Rows: the principal axes; columns value, x, y, z.
Table axes_table(const std::string& name, const std::string& title, const std::string& unit, const Principal& p,
                 int dimension);

}  // namespace dem::analysis
