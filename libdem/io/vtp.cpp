#include "libdem/io/vtp.h"

#include <fmt/format.h>

#include <bit>
#include <type_traits>

#include "libdem/io/files.h"

namespace dem::io {

namespace {

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
}

template <class T>
std::vector<T> flat(const std::vector<shapes::Vec3d>& points) {
  std::vector<T> values;
  values.reserve(3 * points.size());
  for (const auto& p : points)
    for (int k = 0; k < 3; ++k) values.push_back(static_cast<T>(p[k]));
  return values;
}

}  // namespace

template <class T>
std::string Vtp::array(const std::string& name, int components, const std::vector<T>& values) {
  const std::size_t offset = appended_.size();
  const std::uint64_t bytes = values.size() * sizeof(T);
  appended_.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  appended_.append(reinterpret_cast<const char*>(values.data()), bytes);
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
      type_name<T>(), name, components, offset);
}
template std::string Vtp::array(const std::string&, int, const std::vector<float>&);
template std::string Vtp::array(const std::string&, int, const std::vector<double>&);
template std::string Vtp::array(const std::string&, int, const std::vector<std::int32_t>&);
template std::string Vtp::array(const std::string&, int, const std::vector<std::int64_t>&);

void Vtp::set_points(const std::vector<shapes::Vec3d>& points, bool double_precision) {
  point_count_ = points.size();
  points_ = double_precision ? array("Points", 3, flat<double>(points)) : array("Points", 3, flat<float>(points));
}

void Vtp::set_cells(Cells kind, const std::vector<std::int32_t>& connectivity, const std::vector<std::int32_t>& ends) {
  kind_ = kind;
  cell_count_ = ends.size();
  cells_ = array("connectivity", 1, connectivity) + array("offsets", 1, ends);
}

void Vtp::write(const std::string& path) const {
  const auto count = [&](Cells kind) { return kind == kind_ ? cell_count_ : 0; };
  const char* section[] = {"Verts", "Lines", "Polys"};
  const std::string cells = section[static_cast<int>(kind_)];
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian", point_count_, count(Cells::vertices),
      count(Cells::lines), count(Cells::polygons));
  text += "<PointData>\n" + point_data_ + "</PointData>\n<CellData>\n" + cell_data_ + "</CellData>\n";
  text += "<Points>\n" + points_ + "</Points>\n<" + cells + ">\n" + cells_ + "</" + cells + ">\n";
  text += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + appended_ + "\n</AppendedData>\n</VTKFile>\n";
  write_file(path, text);
}

}  // namespace dem::io
