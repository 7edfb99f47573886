// Figures in place: fields over the boxes of an analysis, the force network, free surface, local densities, directions.
// Bodies in space show as one layer across x or y, whichever is shorter.
#pragma once

#include "libdem/report/figure_list.h"

namespace dem::report {

void add_flow_maps(FigureList& to);         // speed with arrows, granular temperature
void add_packing_maps(FigureList& to);      // packing density of boxes, local density of Voronoi cells
void add_stress_maps(FigureList& to);       // pressure, deviator
void add_deformation_maps(FigureList& to);  // bands of shear, change of volume, rotation
void add_force_network(FigureList& to);     // lines by force over mean
void add_free_surface(FigureList& to);
void add_directions(FigureList& to);  // of contact normals on the half sphere

}  // namespace dem::report
