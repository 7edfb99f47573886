// The extremes of detection as a table and a heat map: pair × dimension.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "libdem/render/color.h"
#include "libdem/render/legend.h"
#include "tests/extremes/dimensions.h"

namespace {

using extremes::Verdict;

struct Entry {
  int asked = 0, inside = 0, uncertified = 0;
  double widest = 0;  // eps L
  Verdict worst = Verdict::holds;
};

struct Row {
  std::string pair;
  std::vector<Entry> entries;
};

Entry measure(const contact::MethodInfo& m, const extremes::Dimension& dimension, int count) {
  Entry e;
  each_case(dimension, m.a, m.b, count, [&](const extremes::Case& c, double) {
    const extremes::Outcome o = judge(c, ask(c, m.name));
    ++e.asked;
    e.inside += o.verdict == Verdict::holds;
    e.uncertified += o.verdict != Verdict::refused && !o.certified;
    e.widest = std::max(e.widest, o.width);
    e.worst = std::max(e.worst, o.verdict);
  });
  return e;
}

// Names as the picture's key has them; the last for pairs that have no such case.
const std::vector<std::string> verdicts{"holds", "wider", "refused", "wrong", "no such case"};

std::size_t index_of(const Entry& e) { return e.asked == 0 ? 4 : static_cast<std::size_t>(e.worst); }

void draw(const std::vector<Row>& rows, const std::string& path) {
  using namespace dem::render;
  const auto& dimensions = extremes::dimensions();
  constexpr int line = 26, left = 520, top = 40 + 16 * line / 2, cell = 60;
  Image image;
  image.width = left + cell * static_cast<int>(dimensions.size()) + 320;
  image.height = top + line * static_cast<int>(rows.size()) + 20;
  image.rgb.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3, 255);
  const shapes::Vec3<float> colors[] = {from_srgb(0.2, 0.6, 0.35), from_srgb(0.95, 0.75, 0.2),
                                        from_srgb(0.55, 0.6, 0.7), from_srgb(0.85, 0.1, 0.1),
                                        from_srgb(0.93, 0.93, 0.93)};
  const auto fill = [&](int x, int y, int width, int height, const Color& c) {
    for (int j = y; j < y + height; ++j)
      for (int i = x; i < x + width; ++i)
        for (int k = 0; k < 3; ++k)
          image.rgb[3 * static_cast<std::size_t>(j * image.width + i) + static_cast<std::size_t>(k)] = to_srgb(c[k]);
  };
  for (std::size_t d = 0; d < dimensions.size(); ++d)
    draw_words(image, left + static_cast<int>(d) * cell, 20 + static_cast<int>(d % 8) * line, dimensions[d].name);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const int y = top + static_cast<int>(r) * line;
    draw_words(image, 10, y + 4, rows[r].pair);
    for (std::size_t d = 0; d < dimensions.size(); ++d)
      fill(left + static_cast<int>(d) * cell, y, cell - 2, line - 2, colors[index_of(rows[r].entries[d])]);
  }
  for (std::size_t k = 0; k < verdicts.size(); ++k) {
    const int y = top + static_cast<int>(k) * 2 * line, x = image.width - 300;
    fill(x, y, line, line - 2, colors[k]);
    draw_words(image, x + 2 * line, y + 4, verdicts[k]);
  }
  write_png(path, image);
}

}  // namespace

int main(int argc, char** argv) {
  int count = 8;
  std::string csv, png;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--count") count = std::atoi(argv[i + 1]);
    if (option == "--csv") csv = argv[i + 1];
    if (option == "--png") png = argv[i + 1];
  }
  if (argc % 2 == 0 || count < 1) {
    std::fputs("usage: bench_extremes [--count N] [--csv FILE] [--png FILE]\n", stderr);
    return 2;
  }
  std::vector<Row> rows;
  std::string table = "pair,dimension,verdict,cases,share_inside_64_eps_L,widest_eps_L,share_uncertified\n";
  bool wrong = false;
  for (const contact::MethodInfo* m = contact::methods_begin(); m != contact::methods_end(); ++m) {
    if (m->b == shapes::Kind::mesh || !m->exact) continue;
    Row row{fmt::format("{} {}", name_of(m->a), name_of(m->b)), {}};
    fmt::print("{} ({})\n", row.pair, m->name);
    for (const extremes::Dimension& dimension : extremes::dimensions()) {
      const Entry e = measure(*m, dimension, count);
      row.entries.push_back(e);
      if (e.asked == 0) continue;
      wrong = wrong || e.worst == Verdict::wrong || (e.worst == Verdict::refused) == dimension.answered;
      const double inside = static_cast<double>(e.inside) / e.asked,
                   open = static_cast<double>(e.uncertified) / e.asked;
      fmt::print("  {:12} {:8} {:4} cases  inside 64 eps L {:5.1f} %  widest {:8.3g} eps L  uncertified {:5.1f} %\n",
                 dimension.name, verdicts[index_of(e)], e.asked, 100 * inside, e.widest, 100 * open);
      table += fmt::format("{},{},{},{},{},{},{}\n", row.pair, dimension.name, verdicts[index_of(e)], e.asked, inside,
                           e.widest, open);
    }
    rows.push_back(std::move(row));
    std::fflush(stdout);
  }
  if (!csv.empty()) std::ofstream(csv) << table;
  if (!png.empty()) draw(rows, png);
  return wrong ? 1 : 0;
}
