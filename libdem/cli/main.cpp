// The dem program: reads the command line and hands over to a command. The only source file that includes CLI11.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "libdem/analysis/body_colours.h"
#include "libdem/analysis/group_words.h"
#include "libdem/cli/commands.h"
#include "libdem/io/io.h"
#include "libdem/render/render.h"
#include "shapes/polyhedron_build.h"

namespace {

using namespace dem::cli;

CLI::App* command(CLI::App& app, const std::string& name, const std::string& what, const std::string& examples) {
  CLI::App* sub = app.add_subcommand(name, what);
  sub->footer("Examples:\n" + examples);
  return sub;
}

void add_overrides(CLI::App* sub, std::vector<std::string>& overrides) {
  sub->add_option("--set", overrides,
                  "Override a key of the scene: run.dt=1e-5, material[0].young=1e7, material.NAME.young=1e7")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_threads(CLI::App* sub, int& threads) {
  sub->add_option("--threads", threads,
                  "Number of threads (default: up to all cores); the result does not depend on it")
      ->check(CLI::Range(1, 4096));
}

void add_profile(CLI::App* sub, bool& profile) {
  sub->add_flag("--profile", profile, "Say at the end where the time went, and what became of the candidate pairs");
}

void add_run(CLI::App& app, RunArguments& a) {
  CLI::App* sub = command(app, "run", "Run a scene.",
                          "  dem run hopper.toml --out out/hopper\n"
                          "  dem run hopper.toml --out out/short --set run.time=0.1 --set material.glass.friction=0.3\n"
                          "Ctrl-C writes a checkpoint and exits with 130; dem resume DIR goes on.");
  sub->add_option("scene", a.scene, "Scene file (TOML)")->required()->type_name("SCENE");
  sub->add_option("--out", a.folder, "Folder for everything that the run writes")->required()->type_name("DIR");
  sub->add_flag("--force", a.force, "Replace the run that the folder holds (only files that a run writes)");
  sub->add_flag("--quiet", a.quiet, "No progress");
  add_profile(sub, a.profile);
  add_threads(sub, a.threads);
  add_overrides(sub, a.overrides);
}

void add_resume(CLI::App& app, ResumeArguments& a) {
  CLI::App* sub = command(app, "resume", "Continue a run from its last checkpoint, as if it had never stopped.",
                          "  dem resume out/hopper\n  dem resume out/hopper --threads 2");
  sub->add_option("folder", a.folder, "Folder of the run")->required()->type_name("DIR");
  sub->add_flag("--quiet", a.quiet, "No progress");
  add_profile(sub, a.profile);
  add_threads(sub, a.threads);
}

void add_check(CLI::App& app, CheckArguments& a) {
  CLI::App* sub = command(app, "check", "Say what a scene is and what running it would cost, without running it.",
                          "  dem check hopper.toml\n  dem check hopper.toml --set run.dt_fraction=0.05\n"
                          "  dem check hopper.toml --json");
  sub->add_option("scene", a.scene, "Scene file (TOML)")->required()->type_name("SCENE");
  sub->add_flag("--json", a.json, "Time step, cost and warnings as JSON");
  add_overrides(sub, a.overrides);
}

void add_list(CLI::App& app, ListArguments& a) {
  CLI::App* sub =
      command(app, "list", "Print the catalogues.", "  dem list pairs\n  dem list keys\n  dem list methods --json");
  sub->add_option("what", a.what, "One of them; everything when left out")->check(CLI::IsMember(list_topics()));
  sub->add_flag("--json", a.json, "As JSON");
}

void add_contact(CLI::App& app, ContactArguments& a) {
  CLI::App* sub = command(app, "contact", "Answer pair queries from a file of cases.",
                          "  dem contact cases.json\n"
                          "  dem contact cases.json --method analytic --json results.json\n"
                          "Exit code 0: every case answered or refused; 1: one did not converge; 2: bad input.");
  sub->add_option("cases", a.cases, "Case file (JSON)")->required()->type_name("CASES.json");
  sub->add_option("--method", a.method, "A method of dem list methods, or auto")
      ->type_name("NAME")
      ->capture_default_str();
  sub->add_option(
         "--tolerance", a.tolerance,
         "Largest half-width of the bounds, relative to centre distance plus circumradii; a wider answer counts as "
         "not converged")
      ->check(CLI::PositiveNumber);
  sub->add_option("--json", a.json, "Write the results to this file")->type_name("OUT");
}

void add_law(CLI::App& app, LawArguments& a) {
  CLI::App* sub =
      command(app, "law", "Lead one contact through a force law: along a path, or through an impact.",
              "  dem law impact.toml\n"
              "  dem law path.toml --out loop.csv --plot loop.png\n"
              "  dem law impact.toml --fit measured.csv\n"
              "A spec has [law], one or two [[material]], [a] and [b] with radius (b without: a plane), and\n"
              "  [path] file = \"path.csv\" (columns t, overlap, slip_x, slip_y [, rotation]) or rows, "
              "substeps\n"
              "  [impact] speed and angle_deg, or normal_speed and tangential_speed; spin, dt, "
              "steps_per_contact\n"
              "  [fit] parameters = [\"friction\", \"restitution\"] for --fit, whose file has columns "
              "speed or\n"
              "  normal_speed, angle_deg, and what was measured of restitution, rebound_angle_deg, duration");
  sub->add_option("spec", a.spec, "What to drive (TOML)")->required()->type_name("SPEC");
  auto* out = sub->add_option("--out", a.out, "Write every step to this CSV file")->type_name("CSV");
  auto* plot = sub->add_option("--plot", a.plot, "Draw the loops, by gnuplot")->type_name("PNG");
  sub->add_option("--fit", a.fit, "Find the parameters of [fit] from measured impacts")
      ->type_name("CSV")
      ->excludes(out)
      ->excludes(plot);
}

std::string colours_text() {
  const auto joined = [](const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); };
  return joined(dem::render::color_names()) +
         ";\nbands fixed at the reference frame, deformation since then, and rates: " +
         joined(dem::analysis::body_colour_words()) + ".";
}

void add_render(CLI::App& app, RenderArguments& a, std::string& size) {
  CLI::App* sub = command(app, "render", "Draw a run, without a display.",
                          "  dem render out/hopper\n"
                          "  dem render out/hopper --frame 10 --color-by shape --size 1920x1080\n"
                          "  dem render out/hopper --movie --colour layers --reference 12\n"
                          "Colours: " +
                              colours_text());
  sub->add_option("folder", a.folder, "Folder of the run")->required()->type_name("DIR");
  auto* frame = sub->add_option("--frame", a.frame, "A frame of the record, from 0 (default: the last state)");
  sub->add_option("--color-by,--colour", a.color_by, "What colours show, see below")
      ->type_name("WORD")
      ->capture_default_str();
  sub->add_option("--reference", a.reference,
                  "Frame that bands and deformation refer to; negative from the end (default: 0)")
      ->type_name("FRAME");
  sub->add_flag("--movie", a.movie, "All frames as a movie (ffmpeg), or as numbered pictures")->excludes(frame);
  sub->add_option("--size", size, "Width x height in pixels")->capture_default_str()->type_name("WxH");
}

// A list with commas in one argument: what comes after it is not taken for more of it.
CLI::Option* one_list(CLI::Option* option) {
  return option->delimiter(',')->expected(1)->allow_extra_args(false)->multi_option_policy(
      CLI::MultiOptionPolicy::TakeAll);
}

// What an analysis is asked for.
void add_analyse_options(CLI::App* sub, AnalyseOptions& a) {
  sub->add_option("--frames", a.frames,
                  "From frame A up to, not including, B, each S-th; negative from the end; A alone: one frame "
                  "(default: all)")
      ->type_name("A:B:S");
  one_list(sub->add_option("--what", a.what,
                           "Quantities, with commas; all: costly ones too (default: all that are not costly)"))
      ->type_name("LIST|all");
  one_list(sub->add_option("--boxes", a.boxes, "Boxes along x, y, z; 0: about four mean diameters each (the default)"))
      ->type_name("NX,NY,NZ");
  one_list(sub->add_option("--region", a.region, "Where to look (default: the cell, or what bodies and walls span), m"))
      ->type_name("X0,Y0,Z0,X1,Y1,Z1");
  sub->add_option("--bins", a.bins, "Of histograms, and of roses over the full circle")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  sub->add_option("--rdf-range", a.rdf_range, "Of radial distributions, m; 0: five mean diameters")
      ->check(CLI::NonNegativeNumber);
  sub->add_option("--rdf-bins", a.rdf_bins, "Their shells")->check(CLI::Range(1, 1000000))->capture_default_str();
  sub->add_option("--voronoi-points", a.voronoi_points, "Surface points per body of set-Voronoi cells; 0: chosen")
      ->check(CLI::NonNegativeNumber);
  sub->add_option("--split", a.split, "What mixing and partial distributions compare")
      ->check(CLI::IsMember(dem::analysis::group_words()))
      ->capture_default_str();
  sub->add_option("--strong-force", a.strong_force, "From which part of the mean normal force on a contact is strong")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  sub->add_option("--base-wall", a.base_wall, "Wall that a heap stands on (default: the lowest)")->type_name("NAME");
  sub->add_option("--reference", a.reference,
                  "Frame that displacements, bands and mixing refer to; negative from the end (default: 0)")
      ->type_name("FRAME");
}

void add_foreign_options(CLI::App* sub, AnalyseArguments& a) {
  sub->add_option("--density", a.density, "Of other codes' bodies without mass, kg/m^3")->check(CLI::PositiveNumber);
  sub->add_option("--time-step", a.time_step, "Of other codes' dumps that count steps, s")->check(CLI::PositiveNumber);
  sub->add_option("--contact-gap", a.contact_gap,
                  "Spheres of other codes touch up to a gap of this share of the sum of their radii (default: 0)")
      ->check(CLI::Range(0.0, 1.0));
}

void add_analyse(CLI::App& app, AnalyseArguments& a) {
  CLI::App* sub = command(
      app, "analyse", "What the bodies of a run, or of another code, do together: packing, contacts, stress, flow, …",
      "  dem analyse out/hopper\n"
      "  dem analyse out/hopper --frames 10:: --what coordination,stress --boxes 8,8,12\n"
      "  dem analyse out/hopper --frames -1 --what all --out out/last\n"
      "  dem analyse dump.granular --time-step 1e-6 --density 2500\n"
      "dem list quantities shows what there is. Results are CSV files and analysis.json, units first.\n"
      "Exit code 2: bad input.");
  sub->add_option("source", a.source,
                  "Folder of a run, its record.h5, a LAMMPS or LIGGGHTS text dump, or a .csv file of bodies")
      ->required()
      ->type_name("DIR|FILE");
  add_analyse_options(sub, a.options);
  sub->add_option("--out", a.out, "Folder for the results (default: DIR/analysis, or FILE_analysis)")->type_name("DIR");
  add_foreign_options(sub, a);
  sub->add_flag("--quiet", a.quiet, "No progress, no table of results");
  add_threads(sub, a.threads);
}

void add_report(CLI::App& app, ReportArguments& a) {
  CLI::App* sub = command(
      app, "report", "One page of a run: figures, numbers, and its bodies to turn.",
      "  dem report out/hopper\n"
      "  dem report out/hopper --frames ::5 --what density,coordination --out hopper.html\n"
      "The analysis is used as it is, and made anew where it is missing, older than "
      "the run, or\n"
      "an option of it (--frames to --reference) is given. The page needs no other file and no network. Figures need "
      "gnuplot, the view libjs-three.");
  sub->add_option("source", a.analyse.source, "As of dem analyse")->required()->type_name("DIR|FILE");
  sub->add_option("--out", a.page,
                  "The page (default: DIR/report.html, or FILE_report.html); its figures go beside it into "
                  "FILE_figures")
      ->type_name("FILE.html");
  sub->add_option("--analysis", a.analyse.out, "Folder of the analysis (default: DIR/analysis, or FILE_analysis)")
      ->type_name("DIR");
  add_analyse_options(sub, a.analyse.options);
  sub->add_option("--bodies", a.max_bodies,
                  "About as many in the view at most; of more one in k, spread over their ids")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  add_foreign_options(sub, a.analyse);
  sub->add_flag("--quiet", a.analyse.quiet, "No progress");
  add_threads(sub, a.analyse.threads);
}

void add_validate(CLI::App& app, ValidateArguments& a) {
  CLI::App* sub =
      command(app, "validate", "Run shipped scenes and compare them with exact answers and published numbers.",
              "  dem validate --list\n"
              "  dem validate two_bodies box_stack --out out/validate\n"
              "  dem validate --csv validate.csv\n"
              "Exit code 0: every criterion holds; 1: one does not.");
  sub->add_option("names", a.names, "Validations of --list; all when left out")->type_name("NAME");
  sub->add_option("--out", a.folder, "Each scene writes its run into DIR/NAME (default: nothing is written)")
      ->type_name("DIR");
  sub->add_option("--csv", a.csv, "Write the table to this file")->type_name("FILE");
  sub->add_flag("--list", a.list, "Say what there is, and run nothing");
  sub->add_flag("--force", a.force, "Replace the runs that DIR/NAME holds (only files that a run writes)");
  add_threads(sub, a.threads);
}

void add_new(CLI::App& app, NewArguments& a) {
  CLI::App* sub = command(app, "new", "Begin a scene as a copy of a shipped one.",
                          "  dem new mine.toml\n  dem new silo/mine.toml --from hopper_grains\n"
                          "dem list scenes shows what there is.");
  sub->add_option("name", a.name, "File to write; .toml is added when it is missing")->required()->type_name("NAME");
  sub->add_option("--from", a.from, "The shipped scene")->capture_default_str()->type_name("SCENE");
}

void parse_size(const std::string& text, RenderArguments& a) {
  int used = 0;
  const bool ok = std::sscanf(text.c_str(), "%dx%d%n", &a.width, &a.height, &used) == 2 &&
                  static_cast<std::size_t>(used) == text.size();
  constexpr int smallest = 16, largest = 16384;
  if (!ok || std::min(a.width, a.height) < smallest || std::max(a.width, a.height) > largest)
    throw dem::InputError(fmt::format("--size {}: allowed WxH with {} <= W, H <= {}", text, smallest, largest));
}

int run_program(int argc, char** argv) {
  CLI::App app("Discrete element simulation of bodies of any convex shape.", "dem");
  app.set_version_flag("--version", std::string("dem ") + dem::io::version);
  app.require_subcommand(1);
  app.footer(
      "dem COMMAND --help shows a command with examples.\nExit codes: 0 ok, 1 failed run, 2 bad input, 130 "
      "interrupted.");
  RunArguments run;
  ResumeArguments resume;
  CheckArguments check;
  ListArguments list;
  ContactArguments contact;
  LawArguments law;
  RenderArguments render;
  AnalyseArguments analyse;
  ReportArguments report;
  ValidateArguments validate;
  NewArguments new_scene;
  std::string size = "1200x900", key;
  add_run(app, run);
  add_resume(app, resume);
  add_check(app, check);
  add_list(app, list);
  add_contact(app, contact);
  add_law(app, law);
  add_render(app, render, size);
  add_analyse(app, analyse);
  add_report(app, report);
  add_validate(app, validate);
  add_new(app, new_scene);
  command(app, "schema", "Print the scene format as JSON Schema (draft 2020-12), for editors.",
          "  dem schema > dem.schema.json\n"
          "In a scene's first line, for editors that use Taplo: #:schema ./dem.schema.json");
  command(app, "explain", "Explain a key of the scene format.", "  dem explain run.dt\n  dem explain wall")
      ->add_option("key", key, "Path of the key")
      ->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? success : bad_input;
  }
  if (app.got_subcommand("run")) return run_command(run);
  if (app.got_subcommand("resume")) return resume_command(resume);
  if (app.got_subcommand("check")) return check_command(check);
  if (app.got_subcommand("list")) return list_command(list);
  if (app.got_subcommand("contact")) return contact_command(contact);
  if (app.got_subcommand("law")) return law_command(law);
  if (app.got_subcommand("analyse")) return analyse_command(analyse);
  if (app.got_subcommand("report")) return report_command(report);
  if (app.got_subcommand("validate")) return validate_command(validate);
  if (app.got_subcommand("new")) return new_command(new_scene);
  if (app.got_subcommand("schema")) return schema_command();
  if (app.got_subcommand("explain")) return explain_command(key);
  parse_size(size, render);
  return render_command(render);
}

}  // namespace

// Threads that wait should give way soon: on a machine with other work, waiting by spinning makes two threads slower
// than one. OpenMP reads this before main begins, so the program starts itself once more with it; a caller's own choice
// stands.
static void wait_politely(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
  setenv("GOMP_SPINCOUNT", "2000", 1);
  execv("/proc/self/exe", argv);  // on failure: go on as we are
}

int main(int argc, char** argv) {
  wait_politely(argv);
  try {
    return run_program(argc, argv);
  } catch (const dem::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return bad_input;
  } catch (const shapes::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return bad_input;
  } catch (const dem::RunError& error) {
    fmt::print(stderr, "the run failed: {}\n", error.what());
    return failed_run;
  } catch (const std::exception& error) {
    fmt::print(stderr, "failed: {}\n", error.what());
    return failed_run;
  }
}
