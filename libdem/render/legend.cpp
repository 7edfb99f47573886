#include "libdem/render/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "libdem/render/color.h"

namespace dem::render {

namespace {

// Letters of 5 × 9 dots: nine rows from the top, five bits each, the left dot highest. Letters have one case.
struct Glyph {
  char letter;
  std::uint8_t row[9];  // the last two hang below the line
};
constexpr Glyph font[] = {
    {'0', {14, 17, 17, 17, 17, 17, 14}},
    {'1', {4, 12, 4, 4, 4, 4, 14}},
    {'2', {14, 17, 1, 6, 8, 16, 31}},
    {'3', {14, 17, 1, 6, 1, 17, 14}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},
    {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},
    {'7', {31, 1, 2, 4, 4, 8, 8}},
    {'8', {14, 17, 17, 14, 17, 17, 14}},
    {'9', {14, 17, 17, 15, 1, 2, 12}},
    {'.', {0, 0, 0, 0, 0, 12, 12}},
    {'-', {0, 0, 0, 14, 0, 0, 0}},
    {'+', {0, 4, 4, 31, 4, 4, 0}},
    {'/', {1, 1, 2, 4, 8, 16, 16}},
    {'(', {2, 4, 8, 8, 8, 4, 2}},
    {')', {8, 4, 2, 2, 2, 4, 8}},
    {'>', {8, 4, 2, 1, 2, 4, 8}},
    {'_', {0, 0, 0, 0, 0, 0, 0, 31}},
    {'a', {0, 0, 14, 1, 15, 17, 15}},
    {'b', {16, 16, 30, 17, 17, 17, 30}},
    {'c', {0, 0, 15, 16, 16, 16, 15}},
    {'d', {1, 1, 15, 17, 17, 17, 15}},
    {'e', {0, 0, 14, 17, 31, 16, 14}},
    {'f', {6, 9, 8, 28, 8, 8, 8}},
    {'g', {0, 0, 15, 17, 17, 17, 15, 1, 14}},
    {'h', {16, 16, 30, 17, 17, 17, 17}},
    {'i', {4, 0, 12, 4, 4, 4, 14}},
    {'j', {2, 0, 6, 2, 2, 2, 2, 18, 12}},
    {'k', {16, 16, 18, 20, 24, 20, 18}},
    {'l', {12, 4, 4, 4, 4, 4, 14}},
    {'m', {0, 0, 26, 21, 21, 21, 21}},
    {'n', {0, 0, 30, 17, 17, 17, 17}},
    {'o', {0, 0, 14, 17, 17, 17, 14}},
    {'p', {0, 0, 30, 17, 17, 17, 30, 16, 16}},
    {'q', {0, 0, 15, 17, 17, 17, 15, 1, 1}},
    {'r', {0, 0, 22, 25, 16, 16, 16}},
    {'s', {0, 0, 15, 16, 14, 1, 30}},
    {'t', {8, 8, 28, 8, 8, 9, 6}},
    {'u', {0, 0, 17, 17, 17, 19, 13}},
    {'v', {0, 0, 17, 17, 17, 10, 4}},
    {'w', {0, 0, 17, 21, 21, 21, 10}},
    {'x', {0, 0, 17, 10, 4, 10, 17}},
    {'y', {0, 0, 17, 17, 17, 17, 15, 1, 14}},
    {'z', {0, 0, 31, 2, 4, 8, 31}},
    {'N', {17, 25, 25, 21, 19, 19, 17}},
};

const Glyph* glyph_of(char letter) {
  const auto find = [](char c) {
    return std::find_if(std::begin(font), std::end(font), [c](const Glyph& g) { return g.letter == c; });
  };
  const Glyph* g = find(letter);
  if (g == std::end(font) && letter >= 'A' && letter <= 'Z') g = find(static_cast<char>(letter - 'A' + 'a'));
  return g == std::end(font) ? nullptr : g;  // an unknown one leaves a space
}

// Size of a letter's dot, pixels.
int dot_of(const Image& image) { return std::max(1, std::min(image.width, image.height) / 400); }

int letters(std::size_t count, int dot) { return static_cast<int>(count) * 6 * dot; }

struct Marks {
  std::string top, middle, bottom;
};
Marks marks_of(const Range& range, bool clipped) {
  return {fmt::format("{}{:.3g}", clipped ? ">" : "", range.upper),
          fmt::format("{:.3g}", 0.5 * (range.lower + range.upper)), fmt::format("{:.3g}", range.lower)};
}

constexpr int edge = 6;  // dots on both sides of a legend

class Canvas {
 public:
  explicit Canvas(Image& image) : image_(image), dot_(dot_of(image)) {}
  int dot() const { return dot_; }
  int letter() const { return 6 * dot_; }

  void fill(int x, int y, int width, int height, const Color& c) {
    for (int j = std::max(y, 0); j < std::min(y + height, image_.height); ++j)
      for (int i = std::max(x, 0); i < std::min(x + width, image_.width); ++i) {
        const auto at =
            3 * (static_cast<std::size_t>(j) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(i));
        image_.rgb[at] = to_srgb(c.x);
        image_.rgb[at + 1] = to_srgb(c.y);
        image_.rgb[at + 2] = to_srgb(c.z);
      }
  }
  void text(int x, int y, std::string_view words) {
    for (const char c : words) {
      if (const Glyph* g = glyph_of(c))
        for (int r = 0; r < 9; ++r)
          for (int k = 0; k < 5; ++k)
            if (g->row[r] >> (4 - k) & 1) fill(x + k * dot_, y + r * dot_, dot_, dot_, ink);
      x += letter();
    }
  }

 private:
  static constexpr Color ink{0.05f, 0.05f, 0.06f};
  Image& image_;
  int dot_;
};

}  // namespace

int bar_width(const Image& image, const std::string& label, const Range& range) {
  const Marks marks = marks_of(range, true);
  const std::size_t longest = std::max({marks.top.size(), marks.middle.size(), marks.bottom.size()});
  const int d = dot_of(image);
  return std::max(17 * d + letters(longest, d), letters(label.size(), d)) + 2 * edge * d;
}

int categories_width(const Image& image, const std::string& label, const std::vector<std::string>& names) {
  const int d = dot_of(image);
  int block = letters(label.size(), d);
  for (const std::string& name : names) block = std::max(block, 12 * d + letters(name.size(), d));
  return block + 2 * edge * d;
}

void draw_bar(Image& image, const std::string& label, const Range& range, bool clipped) {
  Canvas canvas(image);
  const int d = canvas.dot(), width = 12 * d, height = image.height * 2 / 5;
  const auto [top, middle, bottom] = marks_of(range, clipped);
  const int x = image.width - bar_width(image, label, range) + edge * d, y = (image.height - height) / 2;
  canvas.text(x, y - 16 * d, label);
  for (int j = 0; j < height; ++j)
    canvas.fill(x, y + j, width, 1, sequential(1 - (static_cast<double>(j) + 0.5) / height));
  const std::string* marks[] = {&top, &middle, &bottom};
  for (int k = 0; k < 3; ++k) canvas.text(x + width + 4 * d, y + k * (height - 7 * d) / 2, *marks[k]);
}

void draw_categories(Image& image, const std::string& label, const std::vector<std::string>& names) {
  Canvas canvas(image);
  const int d = canvas.dot(), line = 14 * d, most = (image.height - 40 * d) / line;
  const auto count = std::min(static_cast<int>(names.size()), std::max(most, 0));
  const int x = image.width - categories_width(image, label, names) + edge * d;
  int y = (image.height - (count + 1) * line) / 2;
  canvas.text(x, y, label);
  for (int k = 0; k < count; ++k) {
    y += line;
    canvas.fill(x, y - d, 9 * d, 9 * d, categorical(static_cast<std::size_t>(k)));
    canvas.text(x + 12 * d, y, names[static_cast<std::size_t>(k)]);
  }
}

int draw_words(Image& image, int x, int y, const std::string& words) {
  Canvas canvas(image);
  canvas.text(x, y, words);
  return letters(words.size(), canvas.dot());
}

}  // namespace dem::render
