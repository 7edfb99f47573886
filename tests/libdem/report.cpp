// Pieces of a report: bytes as text, drawings as part of a page, which figures an analysis has.
#include "libdem/report/report.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "libdem/report/base64.h"
#include "libdem/report/figures.h"
#include "libdem/report/html.h"

namespace {

using namespace dem::report;

std::string encoded(const std::string& text) {
  return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(Report, Base64OfRfc4648) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::vector<std::uint8_t>{0xff, 0xfe, 0xfb}), "//77");
}

TEST(Report, TextIsEscaped) {
  EXPECT_EQ(escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
  EXPECT_EQ(table_of({{"<h>"}, {"1"}}),
            "<table class=\"numbers\">\n<tr><th>&lt;h&gt;</th></tr>\n<tr><td>1</td></tr>\n</table>\n");
}

TEST(Report, DrawingInAPage) {
  const std::string svg =
      "<?xml version=\"1.0\"?>\n<svg width=\"6\" xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\"><title>t</title><defs><circle id='gpDot' r='1'/><g "
      "id=\"x\"/></defs>"
      "<use xlink:href='#gpDot'/><g fill=\"url(#x)\"/></svg>";
  EXPECT_EQ(svg_in_page(svg, "rdf"),
            "<svg width=\"6\"><defs><circle id='rdf-gpDot' r='1'/><g id=\"rdf-x\"/></defs><use href='#rdf-gpDot'/>"
            "<g fill=\"url(#rdf-x)\"/></svg>");
  EXPECT_EQ(svg_in_page("no drawing", "rdf"), "");
}

TEST(Report, FiguresOfWhatIsThere) {
  const auto folder = std::filesystem::temp_directory_path() / "dem-report-figures";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "rdf_000000000000.csv") << "# units: r m, g 1\nr,g\n0.1,1\n0.2,3\n";
  std::ofstream(folder / "rdf_000000000010.csv") << "# units: r m, g 1\n# title\nr,g\n";  // without rows
  Listing listing;
  listing.folder = folder.string();
  listing.frames = {{0, 2, 1, 0, 0}, {1, 2, 1, 10, 1e-3}};
  ListedQuantity rdf{"rdf", "", "", {}, {}, {}};
  rdf.tables.push_back(
      {"", "Radial distribution", {"r", "g"}, {"m", "1"}, {"rdf_000000000000.csv", "rdf_000000000010.csv"}});
  ListedQuantity energy{"energy", "", "", {}, {}, {}};
  energy.scalars.push_back({"potential", "J", 2, 1.0, {}, {}, {}, false});
  energy.scalars.push_back({"translational", "J", 1, 1.0, {}, {}, {}, false});  // in one frame: no series
  energy.scalars.push_back({"rotational", "J", 2, 0.0, {}, {}, {}, false});     // zero throughout: no line
  listing.quantities = {rdf, energy};
  const std::vector<Figure> figures = figures_of(listing, {"../analysis", "", ""});
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].name, "series_energy_potential");
  EXPECT_NE(figures[0].script.find("'../analysis/energy_series.csv' using 'time':'potential'"), std::string::npos)
      << figures[0].script;
  EXPECT_EQ(figures[0].group, "Energy and motion");
  EXPECT_EQ(figures[0].title, "Potential energy over time");
  EXPECT_EQ(figures[1].title, "Radial distribution, at t = 0 s");  // not of the last frame
  EXPECT_EQ(figures[1].name, "rdf");
  EXPECT_NE(figures[1].script.find("'../analysis/rdf_000000000000.csv' using 'r':'g'"), std::string::npos)
      << figures[1].script;
  EXPECT_NE(figures[1].script.find("set xlabel 'r (m)'"), std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST(Report, FolderOfFigures) {
  EXPECT_EQ(figures_folder("a/report.html"), "a/report_figures");
  EXPECT_EQ(figures_folder("page"), "page_figures");
}

}  // namespace
