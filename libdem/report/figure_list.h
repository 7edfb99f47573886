// Building the list of figures: what most of them have in common.
#pragma once

#include <string>
#include <vector>

#include "libdem/io/io.h"
#include "libdem/report/figures.h"
#include "libdem/report/listing.h"

namespace dem::report {

struct Line {
  std::string column, with, title;
};

class FigureList {
 public:
  // `data`: the folder of the analysis as seen from that of the scripts.
  FigureList(const Listing& listing, std::string data) : listing_(listing), data_(std::move(data)) {}

  void begin_group(std::string title) { group_ = std::move(title); }  // what is added from here on stands under it
  void add(const std::string& name, const std::string& title, const std::string& script);
  // Scalars of one unit over time: those that there are and that are not zero throughout.
  void add_series(const std::string& quantity, const std::vector<std::string>& names, const std::string& title,
                  const std::string& y);
  // Columns of a table over another of its columns, of the last frame that has rows; one row makes bars alone.
  void add_table(const std::string& quantity, const std::string& table, const std::string& x,
                 const std::vector<Line>& lines, const std::string& y, const std::string& settings = "");

  const Listing& listing() const { return listing_; }
  const ListedTable* table(const std::string& quantity, const std::string& name) const;  // null: none
  std::string last_file(const ListedTable& table) const;  // the last that has rows; empty: none
  std::string when(const std::string& file) const;        // ", at t = …" where it is not of the last frame
  std::string quoted(const std::string& file) const;      // its path, as scripts take it
  io::Table rows(const std::string& file) const;
  std::vector<Figure> take() { return std::move(list_); }

 private:
  std::string plot(const std::string& file, const std::string& x, const Line& line) const;

  const Listing& listing_;
  std::string data_, group_;
  std::vector<Figure> list_;
};

// Words for an axis: name (unit).
std::string axis_label(const std::string& name, const std::string& unit);
bool has_rows(const std::string& path, int least = 1);
// The plots as one command.
std::string joined_plots(const std::vector<std::string>& plots);
// Column of numbers; an empty cell is not a number, a column that is not there (z of the plane) zero.
std::vector<double> numbers(const io::Table& table, const std::string& column);

}  // namespace dem::report
