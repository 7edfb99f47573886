#include "libdem/analysis/quantities.h"

#include "libdem/analysis/coordination.h"
#include "libdem/analysis/density.h"
#include "libdem/analysis/displacement.h"
#include "libdem/analysis/energy.h"
#include "libdem/analysis/fabric.h"
#include "libdem/analysis/flow.h"
#include "libdem/analysis/mixing.h"
#include "libdem/analysis/orientation.h"
#include "libdem/analysis/porosity.h"
#include "libdem/analysis/rdf.h"
#include "libdem/analysis/report_forces.h"
#include "libdem/analysis/repose.h"
#include "libdem/analysis/rose.h"
#include "libdem/analysis/stress.h"
#include "libdem/analysis/velocity.h"
#include "libdem/analysis/voronoi.h"
#include "libdem/analysis/walls.h"

namespace dem::analysis {

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> list{
      {"density", "packing density by exact shares of boxes, its envelope over box sizes; rotation and motion per box",
       "(9.39)", false, false, report_density},
      {"voronoi", "radical Voronoi cells: volumes, local density and its distribution, faces for pictures", "", false,
       false, report_voronoi},
      {"set_voronoi",
       "cells nearest to each body's surface, for every shape, with their error and the radical cells' difference", "",
       false, true, report_set_voronoi},
      {"porosity", "porosity along the axes and over the distance from walls, exact slabs", "", false, false,
       report_porosity},
      {"rdf", "radial distribution of the centres by exact shells, of species about species", "(9.40), (9.41)", false,
       false, report_rdf},
      {"coordination", "contacts per body, rattlers, constraints", "(9.42)-(9.45)", true, false, report_coordination},
      {"fabric", "tensors of contact normals and branch vectors", "(9.46), (9.47)", true, false, report_fabric},
      {"rose", "directions of contacts by number and by force", "(9.48), (9.49)", true, false, report_rose},
      {"forces", "distributions, strong network, clusters, percolation, chains", "", true, false, report_forces},
      {"stress", "stress after Love and Weber with its kinetic part, total and per box", "Love, Weber", false, false,
       report_stress},
      {"walls", "force, torque and maps of pressure on walls", "", true, false, report_walls},
      {"orientation", "nematic order, alignment along walls", "", false, false, report_orientation},
      {"mixing", "Lacey index, relative standard deviation, intensity of segregation", "", false, false, report_mixing},
      {"displacement", "displacement, strain and rotation since the reference; strain rate, vorticity; colour bands",
       "", false, false, report_displacement},
      {"velocity", "mean velocity and spin, granular temperature, distribution of speeds", "", false, false,
       report_velocity},
      {"flow", "profiles of mean velocity, discharge, inflow, residence", "", false, false, report_flow},
      {"repose", "angle of repose with its error, free surface", "", false, false, report_repose},
      {"energy", "energy of motion and place; in a run also stored and lost in contacts", "", false, false,
       report_energy},
  };
  return list;
}

const Quantity* find_quantity(std::string_view name) {
  for (const Quantity& q : quantities())
    if (name == q.name) return &q;
  return nullptr;
}

}  // namespace dem::analysis
