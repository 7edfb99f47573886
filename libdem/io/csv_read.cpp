#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "libdem/io/io.h"

namespace dem::io {

namespace {

std::string read_all(const std::string& path) {
  gzFile file = gzopen(path.c_str(), "rb");  // reads plain files as they are
  if (file == nullptr) input_error({path, 0, 0}, "cannot open the file");
  std::string text;
  std::vector<char> chunk(1 << 16);
  int n = 0;
  while ((n = gzread(file, chunk.data(), static_cast<unsigned>(chunk.size()))) > 0)
    text.append(chunk.data(), static_cast<std::size_t>(n));
  int status = Z_OK;
  gzerror(file, &status);
  const int closed = gzclose_r(file);  // a file cut short is only told here
  if (n < 0 || (status != Z_OK && status != Z_STREAM_END) || closed != Z_OK)
    input_error({path, 0, 0}, "the file is damaged or cut short (gzip)");
  return text;
}

struct Cell {
  std::string text;
  int column;  // from 1
};

std::vector<Cell> split(std::string_view line) {
  std::vector<Cell> cells;
  std::size_t start = 0;
  while (true) {
    const std::size_t comma = std::min(line.find(',', start), line.size());
    std::size_t first = start, last = comma;
    const auto blank = [&](std::size_t i) { return line[i] == ' ' || line[i] == '\t'; };
    while (first < last && blank(first)) ++first;
    while (last > first && blank(last - 1)) --last;
    cells.push_back({std::string(line.substr(first, last - first)), static_cast<int>(first) + 1});
    if (comma == line.size()) return cells;
    start = comma + 1;
  }
}

void read_header(Table& table, const std::vector<Cell>& cells, int line) {
  table.header_line = line;
  for (const Cell& cell : cells) {
    if (cell.text.empty()) input_error({table.path, line, cell.column}, "a column of the header has no name");
    if (find_column(table, cell.text))
      input_error({table.path, line, cell.column}, fmt::format("column '{}' is named twice", cell.text));
    table.columns.push_back(cell.text);
  }
}

void read_row(Table& table, const std::vector<Cell>& cells, int line, std::size_t length) {
  if (cells.size() < table.columns.size())
    input_error({table.path, line, static_cast<int>(length) + 1},
                fmt::format("the row has {} cells, the header {}: '{}' is missing", cells.size(), table.columns.size(),
                            table.columns[cells.size()]));
  if (cells.size() > table.columns.size())
    input_error({table.path, line, cells[table.columns.size()].column},
                fmt::format("the row has {} cells, the header {}", cells.size(), table.columns.size()));
  auto& row = table.rows.emplace_back();
  auto& positions = table.positions.emplace_back();
  for (const Cell& cell : cells) {
    row.push_back(cell.text);
    positions.push_back(cell.column);
  }
  table.lines.push_back(line);
}

}  // namespace

Table read_csv(const std::string& path) {
  const std::string text = read_all(path);
  Table table;
  table.path = path;
  std::string_view rest = text;
  if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);  // byte order mark
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view content = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (content.ends_with('\r')) content.remove_suffix(1);
    const std::size_t first = content.find_first_not_of(" \t");
    if (first == std::string_view::npos || content[first] == '#') continue;
    if (const std::size_t quote = content.find('"'); quote != std::string_view::npos)
      input_error({path, line, static_cast<int>(quote) + 1},
                  "quoted cells are not read: write the value without quotes");
    const std::vector<Cell> cells = split(content);
    if (table.columns.empty())
      read_header(table, cells, line);
    else
      read_row(table, cells, line, content.size());
  }
  if (table.columns.empty()) input_error({path, 1, 1}, "the file has no header line with the names of its columns");
  return table;
}

std::optional<std::size_t> find_column(const Table& table, const std::string& name) {
  const auto at = std::find(table.columns.begin(), table.columns.end(), name);
  if (at == table.columns.end()) return {};
  return static_cast<std::size_t>(at - table.columns.begin());
}

std::size_t column(const Table& table, const std::string& name) {
  if (const auto at = find_column(table, name)) return *at;
  input_error({table.path, table.header_line, 1},
              fmt::format("column '{}' is missing; the file has {}", name, fmt::join(table.columns, ", ")));
}

double number(const Table& table, std::size_t row, std::size_t column) {
  const std::string& cell = table.rows[row][column];
  const char* first = cell.data();
  const char* last = first + cell.size();
  if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') ++first;
  double value = 0;
  const auto [stop, code] = std::from_chars(first, last, value);
  if (code == std::errc() && stop == last && std::isfinite(value)) return value;
  const std::string what = cell.empty() ? "is empty"
                           : code == std::errc::result_out_of_range
                               ? fmt::format("= {} is out of range", cell)
                               : fmt::format("= '{}' is not a finite number", cell);
  input_error({table.path, table.lines[row], table.positions[row][column]}, table.columns[column] + " " + what);
}

}  // namespace dem::io
