// Files of a run's folder. Every writer takes the world as it is and never changes it: asking for output never changes
// a run.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/version.h"
#include "libdem/io/time_series.h"
#include "libdem/world.h"

namespace dem::io {

inline constexpr const char* version = CONTACT_VERSION;  // as written into records and summaries

// final.csv: id, shape, material, x, y, z, qw, qx, qy, qz, vx, vy, vz, wx, wy, wz, and species when the scene has any;
// 17 digits.
void write_final_csv(const std::string& path, const World& world);
// summary.json: see libdem/io/summary.cpp for the keys. world.times, and with it particle_steps_per_s, covers the steps
// of this process (a resume does not begin at 0).
void write_summary(const std::string& path, const World& world, const std::string& end, int threads);
// discharge.csv, a row for each body that left: time, count and mass by all outlets; outlet, its count and mass;
// species.
void write_discharge_csv(const std::string& path, const World& world);

// cell.csv, of a box that is periodic along every axis: time, length_x … length_z, stress_xx … stress_zz, stress_xy …
// stress_yz (mean of both halves; Pa, compression positive), solid_fraction, coordination, rattlers (their share),
// coordination_backbone (see Coordination), translational and elastic energy, work (of the deformation), J; 17 digits.
class CellSeries {
 public:
  CellSeries(std::string path, const World& world, bool append);
  void write(const World& world);  // one row, unless the file ends with a row of this time

 private:
  TimeSeries file_;
};

// walls.csv, a row for each wall that is present: time, wall; x, y, z of its point that the motion moves (m); now:
// force of the bodies on it (N), torque about that point (N m), power of both (W, of the bodies on the wall); since the
// start: impulse ∫ force dt (N s) and work ∫ power dt (J), so that means over any span follow from differences; area
// (m²: of a mesh's triangles, or `area` of a servo) and mean_pressure (Pa: the normal parts of its contacts over the
// area), empty where there is no area; 17 digits.
class WallSeries {
 public:
  WallSeries(std::string path, const World& world, bool append);
  void write(const World& world);  // its rows, unless the file ends with rows of this time

 private:
  TimeSeries file_;
};

// frames.pvd and frames/*.vtp: spheres and ellipsoids as points (radius, tensor), polyhedra as polygons, contacts as
// lines, walls as polygons. File names carry the step; empty pieces are left out. Coordinates of points and tensors are
// double, everything else single precision: the exact numbers are in the record.
class VtkSeries {
 public:
  explicit VtkSeries(std::string folder);   // goes on with the frames.pvd that the folder holds, if any
  void write(const World& world);           // one frame at world.time(); replaces a frame of the same step
  void truncate_after(std::uint64_t step);  // a resume drops later frames

 private:
  struct Frame {
    std::uint64_t step;
    std::string time;                // s, 17 digits
    std::vector<std::size_t> parts;  // which pieces it has
  };
  void write_index() const;
  std::string file_of(std::size_t part, std::uint64_t step) const;
  std::string folder_;
  std::vector<Frame> frames_;  // in order of steps
};

// record.h5: one group per frame, /frames/<step>: id, shape, material, size, position, orientation, velocity, spin,
// rotation; walls; contacts with force and history. Root attributes: scene text, version, seed. append never rewrites
// earlier frames. The file is closed after each frame, so a killed run leaves a readable record.
class Record {
 public:
  Record(const std::string& path, const World& world, bool append);
  void write(const World& world);
  void truncate_after(std::uint64_t step);

 private:
  std::string path_;
};

// Frames of a record, in order of steps; RunError when the file is not a record.
int frame_count(const std::string& record_path);
// Puts frame 0 … frame_count − 1 into a world built from the same scene: step, particles (as many as the frame has),
// poses of walls (at rest), touching contacts (key, force, centre, history). A picture or an analysis may follow; a run
// goes on from a checkpoint only.
void load_frame(const std::string& record_path, World& world, int frame);

// checkpoint files: written aside, synced, renamed; two kept (checkpoint-<step>.bin); magic, version, length, checksum.
// `state` gives its bytes piece by piece to what it is called with, as save_state does.
using Pieces = std::function<void(const Sink&)>;
void write_checkpoint(const std::string& folder, std::uint64_t step, const Pieces& state);
void write_checkpoint(const std::string& folder, const World& world);
// The newest intact checkpoint of a folder, if any; damaged ones are passed over.
struct Checkpoint {
  std::uint64_t step;
  std::vector<std::uint8_t> state;
};
std::optional<Checkpoint> read_last_checkpoint(const std::string& folder);

// CSV or CSV.gz: `#` comment lines, a header line, rows; cells are trimmed, quotes are refused. Throws InputError with
// file:line:column for a row of the wrong length, an empty or repeated column name, a file that cannot be read.
struct Table {
  std::string path;
  std::vector<std::string> columns;
  int header_line = 0;
  std::vector<int> lines;  // line number of each row
  std::size_t row_count() const { return lines.size(); }
  std::string cell(std::size_t row, std::size_t column) const {
    const Cell& c = cells[row * columns.size() + column];
    return text.substr(c.first, c.size);
  }
  Where where(std::size_t row, std::size_t column) const {
    return {path, lines[row], cells[row * columns.size() + column].position};
  }
  // Of a large table: the text once, and where its cells are.
  struct Cell {
    std::size_t first;
    std::uint32_t size;
    int position;  // column in its line, from 1
  };
  std::string text;         // of the file
  std::vector<Cell> cells;  // row by row
};
Table read_csv(const std::string& path);
// Index of a named column; InputError that lists the columns there are when it is missing.
std::size_t column(const Table& table, const std::string& name);
std::optional<std::size_t> find_column(const Table& table, const std::string& name);
// The cell as a finite number; InputError with file:line:column for anything else (`0.01x`, nan, inf, nothing).
double number(const Table& table, std::size_t row, std::size_t column);

}  // namespace dem::io
