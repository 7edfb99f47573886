#include "libdem/analysis/quantities.h"

#include "libdem/analysis/density.h"
#include "libdem/analysis/energy.h"
#include "libdem/analysis/porosity.h"
#include "libdem/analysis/rdf.h"
#include "libdem/analysis/stress.h"
#include "libdem/analysis/velocity.h"
#include "libdem/analysis/voronoi.h"

namespace dem::analysis {

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> list{
      {"density", "packing density by exact shares of boxes, its envelope over box sizes; rotation and motion per box",
       "(9.39)", false, false, report_density},
      {"energy", "energy of motion and place; in a run also stored and lost in contacts", "", false, false,
       report_energy},
      {"porosity", "porosity along the axes and over the distance from walls, exact slabs", "", false, false,
       report_porosity},
      {"rdf", "radial distribution of the centres by exact shells, of species about species", "(9.40), (9.41)", false,
       false, report_rdf},
      {"set_voronoi",
       "cells nearest to each body's surface, for every shape, with their error and the radical cells' difference", "",
       false, true, report_set_voronoi},
      {"stress", "stress after Love and Weber with its kinetic part, total and per box", "Love, Weber", false, false,
       report_stress},
      {"velocity", "mean velocity and spin, granular temperature, distribution of speeds", "", false, false,
       report_velocity},
      {"voronoi", "radical Voronoi cells: volumes, local density and its distribution, faces for pictures", "", false,
       false, report_voronoi},
  };
  return list;
}

const Quantity* find_quantity(std::string_view name) {
  for (const Quantity& q : quantities())
    if (name == q.name) return &q;
  return nullptr;
}

}  // namespace dem::analysis
