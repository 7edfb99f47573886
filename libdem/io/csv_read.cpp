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

// The cells of the line of `text` that begins at `begin`, in place of what `cells` holds.
void split(std::string_view text, std::size_t begin, std::size_t length, std::vector<Table::Cell>& cells) {
  const std::string_view line = text.substr(begin, length);
  const auto blank = [&](std::size_t i) { return line[i] == ' ' || line[i] == '\t'; };
  cells.clear();
  for (std::size_t start = 0;;) {
    const std::size_t comma = std::min(line.find(',', start), line.size());
    std::size_t first = start, last = comma;
    while (first < last && blank(first)) ++first;
    while (last > first && blank(last - 1)) --last;
    cells.push_back({begin + first, static_cast<std::uint32_t>(last - first), static_cast<int>(first) + 1});
    if (comma == line.size()) return;
    start = comma + 1;
  }
}

void read_header(Table& table, const std::vector<Table::Cell>& cells, int line) {
  table.header_line = line;
  for (const Table::Cell& cell : cells) {
    const std::string name = table.text.substr(cell.first, cell.size);
    if (name.empty()) input_error({table.path, line, cell.position}, "a column of the header has no name");
    if (find_column(table, name))
      input_error({table.path, line, cell.position}, fmt::format("column '{}' is named twice", name));
    table.columns.push_back(name);
  }
}

void read_row(Table& table, const std::vector<Table::Cell>& cells, int line, std::size_t length) {
  if (cells.size() < table.columns.size())
    input_error({table.path, line, static_cast<int>(length) + 1},
                fmt::format("the row has {} cells, the header {}: '{}' is missing", cells.size(), table.columns.size(),
                            table.columns[cells.size()]));
  if (cells.size() > table.columns.size())
    input_error({table.path, line, cells[table.columns.size()].position},
                fmt::format("the row has {} cells, the header {}", cells.size(), table.columns.size()));
  table.cells.insert(table.cells.end(), cells.begin(), cells.end());
  table.lines.push_back(line);
}

}  // namespace

Table read_csv(const std::string& path) {
  Table table;
  table.path = path;
  table.text = read_all(path);
  std::vector<Table::Cell> cells;
  std::string_view rest = table.text;
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
    split(table.text, static_cast<std::size_t>(content.data() - table.text.data()), content.size(), cells);
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
  const Table::Cell& at = table.cells[row * table.columns.size() + column];
  const std::string_view cell = std::string_view(table.text).substr(at.first, at.size);
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
  input_error(table.where(row, column), table.columns[column] + " " + what);
}

}  // namespace dem::io
