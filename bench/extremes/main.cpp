// The extremes of detection as a table and a heat map: pair × dimension.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
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
    const contact::Contact got = ask(c, m.name);
    extremes::Outcome o = judge(c, got);
    if ((o.verdict == Verdict::refused) == dimension.answered || !scales(c, m.name, got)) o.verdict = Verdict::wrong;
    ++e.asked;
    e.inside += o.verdict == Verdict::holds;
    e.uncertified += o.verdict != Verdict::refused && !o.certified;
    e.widest = std::max(e.widest, o.width);
    e.worst = std::max(e.worst, o.verdict);
  });
  return e;
}

// The last for pairs that have no such case.
const std::vector<std::string> verdicts{"holds", "wider", "refused", "wrong", "no such case"};

std::size_t index_of(const Entry& e) { return e.asked == 0 ? 4 : static_cast<std::size_t>(e.worst); }

// Per cent, at least 1 of what is not 0. The picture's letters are small ones, without signs.
std::string percent(int part, int of) { return fmt::format("{}", std::max(1, (200 * part + of) / (2 * of))); }

void draw(const std::vector<Row>& rows, int count, const std::string& path) {
  using namespace dem::render;
  const auto& dimensions = extremes::dimensions();
  constexpr int line = 26, left = 520, head = 2 * line, labels = 8, top = head + (labels + 1) * line, cell = 60;
  Image image;
  image.width = left + cell * static_cast<int>(dimensions.size()) + 480;
  image.height = top + line * static_cast<int>(rows.size()) + 20;
  image.rgb.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3, 255);
  const shapes::Vec3<float> colors[] = {from_srgb(0.6, 0.85, 0.65), from_srgb(0.98, 0.8, 0.3),
                                        from_srgb(0.7, 0.75, 0.85), from_srgb(0.9, 0.25, 0.2),
                                        from_srgb(0.95, 0.95, 0.95)};
  const auto fill = [&](int x, int y, int width, int height, const Color& c) {
    for (int j = y; j < y + height; ++j)
      for (int i = x; i < x + width; ++i)
        for (int k = 0; k < 3; ++k)
          image.rgb[3 * static_cast<std::size_t>(j * image.width + i) + static_cast<std::size_t>(k)] = to_srgb(c[k]);
  };
  draw_words(image, 10, 10,
             fmt::format("worst of {} answers at each level of a dimension against a reference of 50 digits", count));
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    const int x = left + static_cast<int>(d) * cell, y = head + static_cast<int>(d % labels) * line;
    fill(x + 2, y + line - 4, 1, top - y - line, from_srgb(0.7, 0.7, 0.7));
    draw_words(image, x, y, dimensions[d].name);
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const int y = top + static_cast<int>(r) * line;
    draw_words(image, 10, y + 4, rows[r].pair);
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
      const Entry& e = rows[r].entries[d];
      const int x = left + static_cast<int>(d) * cell;
      fill(x, y, cell - 2, line - 2, colors[index_of(e)]);
      if (e.uncertified > 0) draw_words(image, x + 4, y + 4, percent(e.uncertified, e.asked));
    }
  }
  const std::string meaning[] = {"holds within 64 eps times extent",
                                 "farther with bounds that hold",
                                 "refused as is due",
                                 "wrong",
                                 "no such case",
                                 "per cent not certified"};
  for (std::size_t k = 0; k < std::size(meaning); ++k) {
    const int y = top + static_cast<int>(k) * 2 * line, x = image.width - 470;
    if (k < std::size(colors))
      fill(x, y, line, line - 2, colors[k]);
    else
      draw_words(image, x, y + 4, "7");
    draw_words(image, x + line + 10, y + 4, meaning[k]);
  }
  write_png(path, image);
}

// On a terminal: what is done, and about how long the rest will take if it costs what the rest did.
class Progress {
 public:
  explicit Progress(std::size_t steps) : steps_(static_cast<double>(steps)) {}
  void step(const std::string& what) {
    done_ += 1;
    if (!on_) return;
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    fmt::print(stderr, "\r\033[K{:3.0f} %  about {:.0f} s left  {}", 100 * done_ / steps_,
               passed * (steps_ / done_ - 1), what);
    if (done_ == steps_) clear();
    std::fflush(stderr);
  }
  void clear() const {
    if (on_) fmt::print(stderr, "\r\033[K");
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  bool on_ = isatty(2) != 0;
  double steps_, done_ = 0;
};

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
  std::vector<const contact::MethodInfo*> methods;
  for (const contact::MethodInfo* m = contact::methods_begin(); m != contact::methods_end(); ++m)
    if (m->b != shapes::Kind::mesh && m->exact) methods.push_back(m);
  Progress progress(methods.size() * extremes::dimensions().size());
  std::vector<Row> rows;
  std::string table = "pair,dimension,verdict,cases,share_inside_64_eps_L,widest_eps_L,share_uncertified\n";
  bool wrong = false;
  for (const contact::MethodInfo* m : methods) {
    Row row{fmt::format("{} {}", name_of(m->a), name_of(m->b)), {}};
    progress.clear();
    fmt::print("{} ({})\n", row.pair, m->name);
    for (const extremes::Dimension& dimension : extremes::dimensions()) {
      const Entry e = measure(*m, dimension, count);
      row.entries.push_back(e);
      progress.step(fmt::format("{}, {}", row.pair, dimension.name));
      if (e.asked == 0) continue;
      wrong = wrong || e.worst == Verdict::wrong;
      progress.clear();
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
  if (!png.empty()) draw(rows, count, png);
  return wrong ? 1 : 0;
}
