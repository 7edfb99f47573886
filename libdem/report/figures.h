// Figures of an analysis: a gnuplot script each, that reads the CSV files where they are and can be run again by hand.
#pragma once

#include <string>
#include <vector>

#include "libdem/report/listing.h"

namespace dem::report {

struct Figure {
  std::string name;    // NAME.gp and NAME.svg
  std::string title;   // one line for people
  std::string script;  // without the lines that open the terminal
  std::string group;   // heading that it stands under
  std::string svg;     // once drawn, to stand in a page
};

// What the analysis has files for: series of the main scalars, and of its last frame with rows distributions, profiles,
// roses, maps over the boxes, the force network, the free surface; of a run also what its outlets have taken.
// `data`, `run`: the folders of the analysis and the run as seen from that of the scripts; `run` empty: none.
struct Folders {
  std::string data, run;
  std::string run_here;  // the latter as seen from here
};
std::vector<Figure> figures_of(const Listing& listing, const Folders& folders);

// Writes the scripts into the folder and runs gnuplot on them. Those that gnuplot refuses are left out with a note, as
// are all of them where it is not installed (their scripts are written nevertheless).
std::vector<Figure> draw_figures(std::vector<Figure> figures, const std::string& folder,
                                 std::vector<std::string>& notes);

// Removes the scripts of an earlier report, and their drawings.
void remove_figures(const std::string& folder);

// A drawing of gnuplot's as part of a page: no prologue, names of its parts of its own.
std::string svg_in_page(const std::string& svg, const std::string& name);

}  // namespace dem::report
