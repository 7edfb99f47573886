#include "libdem/scene/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <tuple>

namespace dem {

namespace {

constexpr std::size_t most_printed = 20;

std::string line_of(const std::string& path, int number) {
  std::ifstream file(path);
  std::string line;
  for (int i = 0; i < number; ++i)
    if (!std::getline(file, line)) return "";
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

}  // namespace

std::string located(const Where& where, const std::string& message) {
  if (where.line <= 0) return where.file + ": " + message;
  std::string text = fmt::format("{}:{}:{}: {}", where.file, where.line, where.column, message);
  std::string line = line_of(where.file, where.line);
  if (line.empty() || where.column <= 0) return text;
  std::size_t column = std::min(line.size(), static_cast<std::size_t>(where.column - 1));
  constexpr std::size_t widest = 120;
  if (line.size() > widest) {  // a long list: show the part around the column
    const std::size_t first = column > widest / 2 ? column - widest / 2 : 0;
    line = line.substr(first, widest);
    column -= first;
  }
  std::string blank = line.substr(0, column);
  for (char& c : blank)
    if (c != '\t') c = ' ';  // a tab stays, so that the caret stands below its letter
  return text + fmt::format("\n{:>5} | {}\n      | {}^", where.line, line, blank);
}

void input_error(const Where& where, const std::string& message) { throw InputError(located(where, message)); }

void Errors::add(const Position& position, std::string message) { found_.emplace_back(position, std::move(message)); }

Where Errors::where(const Position& position) const {
  if (position.line <= 0) return {"--set", 0, 0};
  return {file(position), position.line, position.column};
}

void Errors::throw_if_any() const {
  if (found_.empty()) return;
  auto sorted = found_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.first.file, a.first.line, a.first.column) <
           std::tuple(b.first.file, b.first.line, b.first.column);
  });
  std::string text;
  for (std::size_t i = 0; i < std::min(sorted.size(), most_printed); ++i)
    text += (i ? "\n" : "") + located(where(sorted[i].first), sorted[i].second);
  if (sorted.size() > most_printed) text += fmt::format("\nand {} more", sorted.size() - most_printed);
  throw InputError(text);
}

}  // namespace dem
