// The report of a run: figures of an analysis, drawn by gnuplot from its files, and one page, report.html, that needs
// no other file and no network: scene, physics on and off, counters, scalars, figures, bodies in a view to turn.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libdem/analysis/frames.h"

namespace dem::report {

struct Input {
  std::string analysis;      // folder of a complete analysis
  std::string page;          // the file to write; figures and their scripts go to figures_folder(page)
  std::string run;           // folder of the run; empty: another code's output
  std::string title, scene;  // of the run: title and resolved text
  std::vector<std::pair<std::string, std::string>> model;  // what is on and off; name empty: the line before goes on
  std::string still;                                       // a PNG file, shown where the view is not; empty: none
  std::size_t max_bodies = 20000;                          // in the view; of more one in k
  std::size_t reference = 0;                               // frame that its bands and strain refer to
};

struct Outcome {
  std::size_t figures = 0, bodies = 0;  // bodies of the last frame
  std::vector<std::string> notes;       // what is left out, and why
};

// `frames`: the source of the analysis. Throws InputError where the analysis is not complete.
Outcome write_report(const Input& input, const analysis::Frames& frames);

std::string figures_folder(const std::string& page);  // PAGE without .html, then _figures

}  // namespace dem::report
