// One VTK PolyData file (.vtp): XML with the arrays appended as raw bytes, 64-bit lengths, this machine's byte order.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shapes/math/vec.h"

namespace dem::io {

class Vtp {
 public:
  enum class Cells { vertices, lines, polygons };

  void set_points(const std::vector<shapes::Vec3d>& points, bool double_precision);
  // Cell i has the points connectivity[ends[i − 1]] … connectivity[ends[i] − 1].
  void set_cells(Cells kind, const std::vector<std::int32_t>& connectivity, const std::vector<std::int32_t>& ends);
  // Values in rows of `components`; T: float, double, std::int32_t or std::int64_t.
  template <class T>
  void add_point_array(const std::string& name, int components, const std::vector<T>& values) {
    point_data_ += array(name, components, values);
  }
  template <class T>
  void add_cell_array(const std::string& name, int components, const std::vector<T>& values) {
    cell_data_ += array(name, components, values);
  }
  void write(const std::string& path) const;

 private:
  template <class T>
  std::string array(const std::string& name, int components, const std::vector<T>& values);

  std::size_t point_count_ = 0, cell_count_ = 0;
  Cells kind_ = Cells::vertices;
  std::string points_, cells_, point_data_, cell_data_;  // XML
  std::string appended_;
};

}  // namespace dem::io
