// The key of a picture's colours, drawn into its right margin.
#pragma once

#include <string>
#include <vector>

#include "libdem/render/render.h"

namespace dem::render {

// Width of the margin that a legend takes in a picture of this size, pixels. It depends on `label` and the range or the
// names alone, so the frames of a movie share it.
int bar_width(const Image& image, const std::string& label, const Range& range);
int categories_width(const Image& image, const std::string& label, const std::vector<std::string>& names);

// Bar from range.lower to range.upper; `clipped` when larger values exist and have the last colour.
void draw_bar(Image& image, const std::string& label, const Range& range, bool clipped);
// A square and a name for each category.
void draw_categories(Image& image, const std::string& label, const std::vector<std::string>& names);
// Words with their upper left corner at (x, y), in the letters of the legends; their width, pixels.
int draw_words(Image& image, int x, int y, const std::string& words);

}  // namespace dem::render
