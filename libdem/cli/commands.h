// The commands of the program: arguments in, exit code out. Results go to stdout, everything else to stderr.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace dem::cli {

// 130 is what a shell reports for a program that Ctrl-C ended.
enum ExitCode : int { success = 0, failed_run = 1, bad_input = 2, interrupted = 130 };

struct RunArguments {
  std::string scene, folder;
  bool force = false, quiet = false, profile = false;
  int threads = 0;  // 0: all cores that the scene can keep busy
  std::vector<std::string> overrides;
};
int run_command(const RunArguments& arguments);

struct ResumeArguments {
  std::string folder;
  int threads = 0;
  bool quiet = false, profile = false;
};
int resume_command(const ResumeArguments& arguments);

struct CheckArguments {
  std::string scene;
  bool json = false;
  std::vector<std::string> overrides;
};
int check_command(const CheckArguments& arguments);

struct ListArguments {
  std::string what;  // empty: everything
  bool json = false;
};
int list_command(const ListArguments& arguments);
const std::vector<std::string>& list_topics();

struct ContactArguments {
  std::string cases, method = "auto", json;
  std::optional<double> tolerance;  // relative: largest half-width of the bounds over offset plus circumradii
};
int contact_command(const ContactArguments& arguments);

struct LawArguments {
  std::string spec, out, plot, fit;  // empty: not wanted
};
int law_command(const LawArguments& arguments);

struct RenderArguments {
  std::string folder, color_by = "speed";
  std::optional<int> frame, reference;
  bool movie = false;
  int width = 1200, height = 900;
};
int render_command(const RenderArguments& arguments);

struct AnalyseOptions {
  std::string frames;
  std::vector<std::string> what;  // names, "all"; empty: all that are not costly
  std::vector<int> boxes;         // two or three
  std::vector<double> region;     // lower and upper corner, four or six numbers
  std::string split = "species", base_wall;
  int bins = 36, rdf_bins = 200, voronoi_points = 0;
  double rdf_range = 0, strong_force = 1;
  std::optional<long> reference;
  friend bool operator==(const AnalyseOptions&, const AnalyseOptions&) = default;
};
struct AnalyseArguments {
  std::string source, out;
  AnalyseOptions options;
  double density = 0, time_step = 0, contact_gap = 0;  // of files of other codes
  int threads = 0;
  bool quiet = false;   // no progress, no table of results
  bool silent = false;  // nothing at all on stdout
};
int analyse_command(const AnalyseArguments& arguments);
std::string folder_of(const AnalyseArguments& arguments);  // where its results go

struct ReportArguments {
  AnalyseArguments analyse;
  std::string page;  // empty: report.html in the folder of the run
  int max_bodies = 20000;
};
int report_command(const ReportArguments& arguments);

struct NewArguments {
  std::string name, from = "two_bodies";
};
int new_command(const NewArguments& arguments);
int schema_command();

struct ValidateArguments {
  std::vector<std::string> names;  // empty: all
  std::string folder, csv;         // empty: not written
  bool list = false, force = false;
  int threads = 0;
};
int validate_command(const ValidateArguments& arguments);

int explain_command(const std::string& key);

}  // namespace dem::cli
