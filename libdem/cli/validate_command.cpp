// dem validate: runs shipped scenes and compares what they show with what is known.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <filesystem>

#include "libdem/cli/commands.h"
#include "libdem/cli/folder.h"
#include "libdem/cli/progress.h"
#include "libdem/io/files.h"
#include "libdem/scene/nearest.h"
#include "libdem/validate/list.h"

namespace dem::cli {

namespace {

namespace fs = std::filesystem;
using validate::Result;
using validate::Row;
using validate::Validation;

std::vector<const Validation*> chosen(const std::vector<std::string>& names) {
  if (names.empty()) return validate::validations();
  std::vector<const Validation*> out;
  for (const std::string& name : names) {
    const auto& all = validate::validations();
    const auto it = std::find_if(all.begin(), all.end(), [&](const Validation* v) { return v->name == name; });
    if (it == all.end()) {
      std::vector<std::string> known;
      for (const Validation* v : all) known.emplace_back(v->name);
      throw InputError(fmt::format("no validation is named \"{}\"{}", name, suggestion(name, known)));
    }
    out.push_back(*it);
  }
  return out;
}

// The folder of one validation: refused when it holds something, unless `force`, which removes what runs write.
std::string prepared_folder(const std::string& parent, const char* name, bool force) {
  if (parent.empty()) return "";
  const fs::path folder = fs::path(parent) / name;
  if (!fs::exists(folder)) return folder.string();
  if (!fs::is_directory(folder)) throw InputError(folder.string() + ": is not a folder");
  if (fs::is_empty(folder)) return folder.string();
  if (!force)
    throw InputError(fmt::format("{}: is not empty; choose another --out, or --force to replace what runs wrote there",
                                 folder.string()));
  std::vector<std::string> folders{folder.string()};
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) folders.push_back(entry.path().string());
  for (const std::string& f : folders) clear_folder(f);
  return folder.string();
}

constexpr const char* columns[] = {"scene", "criterion", "expected", "got", "pass", "time"};

// Letters as a terminal counts them: bytes that do not continue a UTF-8 character.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

using Cells = std::vector<std::string>;

const char* verdict(const Row& row, const char* no) { return !row.judged ? "-" : row.pass ? "yes" : no; }

std::vector<Cells> cells_of(const Validation& v, const Result& r) {
  std::vector<Cells> out;
  for (const Row& row : r.rows)
    out.push_back({out.empty() ? v.name : "", row.criterion, row.expected, row.got, verdict(row, "NO"),
                   out.empty() ? duration_text(r.seconds) : ""});
  return out;
}

void print_table(const std::vector<Cells>& lines) {
  std::vector<std::size_t> widths;
  for (const char* c : columns) widths.push_back(std::string_view(c).size());
  for (const Cells& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], std::min<std::size_t>(width_of(line[i]), 60));
  const auto print = [&](const Cells& line) {
    std::string out;
    for (std::size_t i = 0; i < line.size(); ++i) {
      out += line[i];
      const std::size_t used = width_of(line[i]);
      if (i + 1 < line.size()) out += std::string(used < widths[i] ? widths[i] - used : 0, ' ') + "  ";
    }
    fmt::print("{}\n", out);
  };
  print(Cells(std::begin(columns), std::end(columns)));
  for (const Cells& line : lines) print(line);
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) (out += c) += c == '"' ? "\"" : "";
  return out + '"';
}

std::string csv(const std::vector<const Validation*>& list, const std::vector<Result>& results) {
  std::string out = "scene,criterion,expected,got,pass,seconds\n";
  for (std::size_t i = 0; i < results.size(); ++i)
    for (const Row& row : results[i].rows)
      out += fmt::format("{},{},{},{},{},{:.2f}\n", list[i]->name, csv_field(row.criterion), csv_field(row.expected),
                         csv_field(row.got), verdict(row, "no"), results[i].seconds);
  return out;
}

}  // namespace

int validate_command(const ValidateArguments& arguments) {
  const std::vector<const Validation*> list = chosen(arguments.names);
  if (arguments.list) {
    for (const Validation* v : list) fmt::print("{:<20} {:<24} {}\n", v->name, v->scene, v->criterion);
    return success;
  }
  std::vector<std::string> folders;
  for (const Validation* v : list) folders.push_back(prepared_folder(arguments.folder, v->name, arguments.force));
  const int threads = arguments.threads > 0 ? arguments.threads : omp_get_num_procs();
  std::vector<Result> results;
  std::vector<Cells> lines;
  std::size_t passed = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    fmt::print(stderr, "{}: {}\n", list[i]->name, list[i]->criterion);
    results.push_back(validate::carry_out(*list[i], folders[i], threads));
    for (Cells& line : cells_of(*list[i], results[i])) lines.push_back(std::move(line));
    passed += results[i].pass() ? 1 : 0;
    if (!arguments.csv.empty()) io::write_file(arguments.csv, csv(list, results));  // whole after each scene
  }
  print_table(lines);
  fmt::print("{} of {} scenes pass\n", passed, list.size());
  return passed == list.size() ? success : failed_run;
}

}  // namespace dem::cli
