// What one contact went through, row by row, as a table and as a picture.
#pragma once

#include <string>
#include <vector>

#include "libdem/law_driver/impact.h"

namespace dem::law_driver {

struct CurveRow {
  double time, overlap, slip_x, slip_y;               // s, m
  double normal, tangential_x, tangential_y;          // on b, N
  double contact_radius, stored;                      // m, J
  std::array<double, contact::mechanism_count> lost;  // J
  std::vector<double> memory;
};

class Curve {
 public:
  void add(const Look& look);
  const std::vector<CurveRow>& rows() const { return rows_; }
  // CSV with units in its header, 17 digits.
  std::string csv() const;
  // Normal force over overlap and tangential force over slip, as commands of gnuplot that write a PNG file.
  std::string gnuplot(const std::string& file, const std::string& title) const;

 private:
  std::vector<CurveRow> rows_;
};

}  // namespace dem::law_driver
