#include "libdem/law_driver/curve.h"

#include <fmt/format.h>

#include <algorithm>

#include "libdem/io/programs.h"

namespace dem::law_driver {

void Curve::add(const Look& look) {
  const Answer& a = look.drive.answer();
  // Across, in the plane of the contact: x there, y as it is.
  const Vec3d n = look.move.normal, x = normalized(Vec3d{n.z, 0, -n.x});
  CurveRow row{look.time,      look.overlap,     look.slip_x, look.slip_y, a.normal,           dot(a.tangential, x),
               a.tangential.y, a.contact_radius, a.energy,    {},          look.drive.memory()};
  for (std::size_t m = 0; m < row.lost.size(); ++m) row.lost[m] = look.drive.lost(static_cast<contact::Mechanism>(m));
  rows_.push_back(std::move(row));
}

std::string Curve::csv() const {
  std::string text =
      "t [s],overlap [m],slip_x [m],slip_y [m],normal_force [N],tangential_x [N],tangential_y [N],contact_radius [m],"
      "stored [J]";
  for (const char* name : contact::mechanism_names) text += fmt::format(",{} [J]", name);
  const std::size_t words = rows_.empty() ? 0 : rows_.front().memory.size();
  for (std::size_t j = 0; j < words; ++j) text += fmt::format(",memory_{}", j);
  text += '\n';
  for (const CurveRow& r : rows_) {
    text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", r.time, r.overlap,
                        r.slip_x, r.slip_y, r.normal, r.tangential_x, r.tangential_y, r.contact_radius, r.stored);
    for (const double w : r.lost) text += fmt::format(",{:.17g}", w);
    for (const double m : r.memory) text += fmt::format(",{:.17g}", m);
    text += '\n';
  }
  return text;
}

std::string Curve::gnuplot(const std::string& file, const std::string& title) const {
  std::string text = fmt::format(
      "set terminal pngcairo size 1400,600\nset output {}\nset multiplot layout 1,2 title {} noenhanced\n"
      "set key off\nset grid\n$data << END\n",
      io::gnuplot_quoted(file), io::gnuplot_quoted(title));
  constexpr std::size_t most = 20000;  // points of a picture
  const std::size_t step = std::max<std::size_t>(1, rows_.size() / most);
  for (std::size_t i = 0; i < rows_.size(); i += step) {
    const CurveRow& r = rows_[i];
    text += fmt::format("{} {} {} {} {} {}\n", r.overlap, r.slip_x, r.slip_y, r.normal, r.tangential_x, r.tangential_y);
  }
  text +=
      "END\nset xlabel \"overlap (m)\"\nset ylabel \"normal force (N)\"\nplot $data using 1:4 with lines lw 2\n"
      "set xlabel \"slip (m)\"\nset ylabel \"tangential force (N)\"\nset key on\n"
      "plot $data using 2:5 with lines lw 2 title \"x\", $data using 3:6 with lines lw 2 title \"y\"\n"
      "unset multiplot\n";
  return text;
}

}  // namespace dem::law_driver
