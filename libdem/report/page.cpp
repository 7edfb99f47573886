// The page: its parts one after the other.
#include <fmt/format.h>

#include <filesystem>

#include "libdem/io/files.h"
#include "libdem/report/assets.h"
#include "libdem/report/base64.h"
#include "libdem/report/counters.h"
#include "libdem/report/figures.h"
#include "libdem/report/html.h"
#include "libdem/report/report.h"
#include "libdem/report/three.h"
#include "libdem/report/view_data.h"

namespace dem::report {

namespace fs = std::filesystem;

namespace {

std::string note(const std::string& text) { return "<p class=\"note\">" + escaped(text) + "</p>\n"; }

std::string section(const char* id, const std::string& title, const std::string& body) {
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, escaped(title), body);
}

std::string still_html(const std::string& file) {
  const std::string bytes = io::read_file(file);
  if (bytes.empty()) return note("there is no picture of the run either");
  return "<img class=\"still\" alt=\"the last state\" src=\"data:image/png;base64," +
         base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}) + "\">\n";
}

std::string view_html(const Three& three, const ViewData& view, const std::string& still) {
  std::string out;
  for (const std::string& n : view.notes) out += note(n);
  const std::string picture = still_html(still);
  if (!three.why.empty()) return out + note(three.why + ": a still picture instead of the view to turn") + picture;
  // The picture stands until the script has made the view.
  out += "<div id=\"instead\">" + note("no scripts or no WebGL in this browser: a still picture instead of the view") +
         picture + "</div>\n";
  out +=
      "<div id=\"view\" hidden><div id=\"canvas\"><div id=\"legend\"></div></div>\n<div id=\"controls\" hidden>"
      "<button id=\"play\" type=\"button\">play</button>"
      "<input id=\"time\" type=\"range\" min=\"0\" value=\"0\" aria-label=\"frame\"><span id=\"clock\"></span>"
      "<label>colour <select id=\"colour\"></select></label>"
      "<label><input id=\"walls\" type=\"checkbox\" checked> walls</label>"
      "<span class=\"faint\">drag turns, right button shifts, wheel goes nearer</span></div></div>\n";
  return out;
}

std::string scripts(const Three& three, const ViewData& view) {
  if (!three.why.empty()) return "";
  return "<script type=\"application/json\" id=\"data\">" + view.json + "</script>\n" +
         "<script class=\"library\">/* three.js, MIT licence, copyright three.js authors */\n" + three.library +
         "</script>\n<script class=\"library\">\n" + three.controls + "</script>\n<script>\n" + std::string(view_js) +
         "</script>\n";
}

std::string figures_html(const std::vector<Figure>& figures, const std::vector<std::string>& notes) {
  std::string out;
  for (const std::string& n : notes) out += note(n);
  if (figures.empty()) return out + (notes.empty() ? note("the analysis has nothing to draw") : "");
  const std::string* group = nullptr;
  for (const Figure& f : figures) {
    if (group == nullptr || *group != f.group)
      out +=
          fmt::format("{}<h3>{}</h3>\n<div class=\"figures\">\n", group == nullptr ? "" : "</div>\n", escaped(f.group));
    group = &f.group;
    std::string title = f.title;
    if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
    out +=
        fmt::format("<figure id=\"figure-{}\">{}<figcaption>{}</figcaption></figure>\n", f.name, f.svg, escaped(title));
  }
  return out + "</div>\n";
}

std::string model_html(const Input& input) {
  if (input.run.empty()) return note("output of another code: what it models is not known");
  std::vector<std::vector<std::string>> rows{{"part", "what is modelled, what is off and why"}};
  for (const auto& [name, text] : input.model) rows.push_back({name, text});
  return table_of(rows, false);
}

std::string number(const std::optional<double>& value, const char* format = "{:.6g}") {
  return value ? fmt::format(fmt::runtime(format), *value) : "";
}

std::string scalars_html(const Listing& listing) {
  const bool series = listing.frames.size() > 1;
  std::string out;
  if (series)
    out +=
        "<p class=\"faint\">Mean and standard error over the steady part, or over all frames where none is found; "
        "≥: the series is too short for its error.</p>\n";
  for (const ListedQuantity& q : listing.quantities) {
    std::vector<std::vector<std::string>> rows{{"scalar", "unit", series ? "last" : "value", "error"}};
    if (series) rows[0] = {"scalar", "unit", "last", "mean", "error", "steady from (s)", "frames"};
    for (const ListedScalar& s : q.scalars) {
      rows.push_back({s.name, s.unit, number(s.last)});
      if (series) rows.back().push_back(number(s.mean));
      rows.back().push_back((series && s.error && !s.settled ? "≥ " : "") + number(s.error, "{:.2g}"));
      if (series) rows.back().insert(rows.back().end(), {number(s.steady_from), fmt::format("{}", s.frames)});
    }
    std::string body = "<p>" + escaped(q.what) + (q.equation.empty() ? "" : " – " + escaped(q.equation)) + "</p>\n";
    if (q.scalars.empty())
      body += "<p>no scalars</p>\n";
    else
      body += table_of(rows);
    for (const std::string& n : q.notes) body += note(n);
    out += folded(q.name, body);
  }
  return out;
}

std::string files_html(const Input& input, const Listing& listing) {
  std::string out = fmt::format("<p>Analysis: <code>{}</code>; figures and their scripts: <code>{}</code></p>\n",
                                escaped(listing.folder), escaped(figures_folder(input.page)));
  std::vector<std::vector<std::string>> rows{{"frame", "step", "time (s)", "bodies", "contacts"}};
  for (const Frame& f : listing.frames)
    rows.push_back({fmt::format("{}", f.frame), fmt::format("{}", f.step), fmt::format("{:.8g}", f.time),
                    fmt::format("{}", f.bodies), fmt::format("{}", f.contacts)});
  return out + folded(fmt::format("{} frames", listing.frames.size()), table_of(rows));
}

}  // namespace

std::string figures_folder(const std::string& page) {
  return (page.ends_with(".html") ? page.substr(0, page.size() - 5) : page) + "_figures";
}

Outcome write_report(const Input& input, const analysis::Frames& frames) {
  const Listing listing = read_listing(input.analysis);
  const std::string folder = figures_folder(input.page);
  Outcome out;
  const ViewData view = view_data(frames, listing, input.max_bodies, input.reference);
  std::vector<std::string> figure_notes;
  const auto seen = [&](const std::string& path) {
    return path.empty() ? "" : fs::proximate(fs::absolute(path), fs::absolute(folder)).generic_string();
  };
  const Folders folders{seen(input.analysis), seen(input.run), input.run};
  const std::vector<Figure> figures = draw_figures(figures_of(listing, folders), folder, figure_notes);
  const Three three = find_three();
  const std::string title = input.title.empty() ? listing.source : input.title;
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + escaped(title) +
                     "</title>\n<style>\n" + std::string(page_css) + "</style>\n</head>\n";
  page += fmt::format("<body data-bodies=\"{}\" data-frames=\"{}\" data-figures=\"{}\" data-view=\"still\">\n",
                      view.bodies, view.frames, figures.size());
  page += "<header>\n<h1>" + escaped(title) + "</h1>\n<p class=\"faint\">" + escaped(listing.source) + ", " +
          fmt::format("{} frame{}, dem {}", listing.frames.size(), listing.frames.size() == 1 ? "" : "s",
                      escaped(listing.version)) +
          "</p>\n<nav><a href=\"#bodies\">view</a><a href=\"#figures\">figures</a><a href=\"#model\">model</a>"
          "<a href=\"#counters\">counters</a><a href=\"#scalars\">scalars</a><a href=\"#scene\">scene</a></nav>\n"
          "</header>\n<main>\n";
  for (const std::string& n : listing.notes) page += note(n);
  page += section("bodies", "Bodies", view_html(three, view, input.still));
  page += section("figures", "Figures", figures_html(figures, figure_notes));
  page += section("model", "Physics on and off", model_html(input));
  const std::string counters = input.run.empty() ? "" : counters_html((fs::path(input.run) / "summary.json").string());
  page += section("counters", "Counters", counters.empty() ? note("there is no summary.json of a run") : counters);
  page += section("scalars", "Scalars", scalars_html(listing));
  page += section("scene", "Scene",
                  input.scene.empty()
                      ? note("output of another code: there is no scene")
                      : folded("scene.toml, as resolved", "<pre>" + escaped(input.scene) + "</pre>\n", true));
  page += section("files", "Files", files_html(input, listing));
  page += "</main>\n" + scripts(three, view) + "</body>\n</html>\n";
  io::write_file(input.page, page);
  out.figures = figures.size();
  out.bodies = view.bodies;
  out.notes = view.notes;
  out.notes.insert(out.notes.end(), figure_notes.begin(), figure_notes.end());
  if (!three.why.empty()) out.notes.push_back(three.why + ": the page has a still picture instead of the view");
  return out;
}

}  // namespace dem::report
