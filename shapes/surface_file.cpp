#include "shapes/surface_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <string_view>
#include <tuple>

#include "shapes/polyhedron_build.h"

namespace shapes {
namespace {

// The words of a text file, line by line; comments run from # to the end of the line.
class Lines {
 public:
  explicit Lines(const std::string& path) : path_(path), in_(path) {}

  // Next line that holds a word.
  bool next() {
    while (std::getline(in_, line_)) {
      ++number_;
      rest_ = std::string_view(line_).substr(0, line_.find('#'));
      if (rest_.find_first_not_of(blank) != std::string_view::npos) return true;
    }
    rest_ = {};
    return false;
  }
  // Next word of the line; empty at its end.
  std::string_view word() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blank), rest_.size()));
    const std::string_view w = rest_.substr(0, rest_.find_first_of(blank));
    rest_.remove_prefix(w.size());
    return w;
  }
  template <class Number>
  Number number(std::string_view w, const char* what) const {
    Number value{};
    const bool plus = w.size() > 1 && w[0] == '+' && w[1] != '-';
    const auto [end, error] = std::from_chars(w.data() + (plus ? 1 : 0), w.data() + w.size(), value);
    if (w.empty() || error != std::errc{} || end != w.data() + w.size())
      fail(what, w, "a number in the range of its type");
    return value;
  }
  double coordinate() {
    const std::string_view w = word();
    const double x = number<double>(w, "coordinate");
    if (!std::isfinite(x)) fail("coordinate", w, "a finite number");
    const auto exponent_at = std::min(w.find_first_of("eE"), w.size()), point = std::min(w.find('.'), exponent_at);
    int last_place = point < exponent_at ? -static_cast<int>(exponent_at - point - 1) : 0;
    if (exponent_at < w.size()) last_place += number<int>(w.substr(exponent_at + 1), "exponent");
    last_place_ = std::min(last_place_, last_place);
    return x;
  }
  // Unit of the finest decimal place among the coordinates read.
  double resolution() const { return std::pow(10.0, last_place_); }
  Vec3d vertex() {
    const double x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }
  [[noreturn]] void fail(const char* what, std::string_view value, const char* allowed) const {
    throw Error(path_ + ":" + std::to_string(number_) + ": " + what + " '" + std::string(value) +
                "'; allowed: " + allowed);
  }

 private:
  static constexpr const char* blank = " \t\r\f\v";
  std::string path_;
  std::ifstream in_;
  std::string line_;
  std::string_view rest_;
  std::size_t number_ = 0;
  int last_place_ = std::numeric_limits<double>::max_exponent10;
};

Surface read_off(const std::string& path) {
  Lines lines(path);
  if (!lines.next()) lines.fail("header", "", "OFF");
  if (const auto header = lines.word(); header != "OFF") lines.fail("header", header, "OFF");
  auto count = lines.word();
  if (count.empty()) {
    if (!lines.next()) lines.fail("counts", "", "numbers of vertices and faces");
    count = lines.word();
  }
  const auto vertices = lines.number<std::uint32_t>(count, "number of vertices");
  const auto faces = lines.number<std::uint32_t>(lines.word(), "number of faces");
  Surface s;
  for (std::uint32_t i = 0; i < vertices; ++i) {
    if (!lines.next()) lines.fail("vertex", "end of file", "as many vertices as the header says");
    s.vertices.push_back(lines.vertex());
  }
  for (std::uint32_t i = 0; i < faces; ++i) {
    if (!lines.next()) lines.fail("face", "end of file", "as many faces as the header says");
    const auto size = lines.number<std::uint32_t>(lines.word(), "face size");
    std::vector<std::uint32_t> face;
    for (std::uint32_t k = 0; k < size; ++k) {
      const auto w = lines.word();
      const auto index = lines.number<std::uint32_t>(w, "vertex index");
      if (index >= vertices) lines.fail("vertex index", w, "0 to the number of vertices less 1");
      face.push_back(index);
    }
    s.faces.push_back(std::move(face));
  }
  s.resolution = lines.resolution();
  return s;
}

Surface read_obj(const std::string& path) {
  Lines lines(path);
  Surface s;
  while (lines.next()) {
    const auto keyword = lines.word();
    if (keyword == "v") s.vertices.push_back(lines.vertex());
    if (keyword != "f") continue;
    std::vector<std::uint32_t> face;
    const auto count = static_cast<std::int64_t>(s.vertices.size());
    for (auto w = lines.word(); !w.empty(); w = lines.word()) {
      const auto given = lines.number<std::int64_t>(w.substr(0, w.find('/')), "vertex index");
      const std::int64_t index = given < 0 ? count + given : given - 1;
      if (given == 0 || index < 0 || index >= count)
        lines.fail("vertex index", w, "1 to the number of vertices so far, or -1 back");
      face.push_back(static_cast<std::uint32_t>(index));
    }
    s.faces.push_back(std::move(face));
  }
  s.resolution = lines.resolution();
  return s;
}

Surface read_stl(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_ValidateDataStructure);
  if (scene == nullptr) throw Error(path + ": not read: " + importer.GetErrorString() + "; allowed: an STL file");
  Surface s;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    const auto base = static_cast<std::uint32_t>(s.vertices.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& v = mesh.mVertices[i];
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        throw Error(path + ": vertex " + std::to_string(i) + " is not finite; allowed: finite numbers");
      s.vertices.push_back({v.x, v.y, v.z});
      s.resolution = std::fmax(s.resolution, 0x1p-22 * max_abs(s.vertices.back()));
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      s.faces.emplace_back();
      for (unsigned k = 0; k < face.mNumIndices; ++k) s.faces.back().push_back(base + face.mIndices[k]);
    }
  }
  return s;
}

void join_identical(Surface& s) {
  std::map<std::tuple<double, double, double>, std::uint32_t> number_of;
  std::vector<std::uint32_t> number;
  std::vector<Vec3d> joined;
  for (const Vec3d& v : s.vertices) {
    const auto [it, fresh] = number_of.emplace(std::tuple{v.x, v.y, v.z}, static_cast<std::uint32_t>(joined.size()));
    if (fresh) joined.push_back(v);
    number.push_back(it->second);
  }
  s.vertices = std::move(joined);
  for (auto& face : s.faces)
    for (auto& v : face) v = number[v];
}

}  // namespace

Surface read_surface(const std::string& path) {
  std::string suffix = path.substr(std::min(path.rfind('.'), path.size()));
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (suffix != ".off" && suffix != ".obj" && suffix != ".stl")
    throw Error(path + ": format '" + suffix + "'; allowed: .off, .obj, .stl");
  if (!std::ifstream(path)) throw Error(path + ": cannot be opened; allowed: a file that exists and can be read");
  Surface s = suffix == ".off" ? read_off(path) : (suffix == ".obj" ? read_obj(path) : read_stl(path));
  if (s.faces.empty()) throw Error(path + ": 0 faces; allowed: at least 1");
  join_identical(s);
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    auto sorted = s.faces[f];
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      throw Error(path + ": face " + std::to_string(f) + " has " + std::to_string(sorted.size()) +
                  " vertices, or one twice; allowed: at least 3 different ones");
  }
  return s;
}

}  // namespace shapes
