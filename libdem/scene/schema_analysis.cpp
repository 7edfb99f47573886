// The keys of [analysis].
#include "libdem/analysis/group_words.h"
#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem {

using bind::value;

std::vector<Key> analysis_keys() {
  return {
      value<&AnalysisSpec::what>("what", "",
                                 "Quantities of dem list quantities, or all, whose numbers are written over time into "
                                 "analysis_<quantity>.csv; they leave the run as it is."),
      value<&AnalysisSpec::interval>("interval", "s", "Simulated time between rows; 0 = with the frames.").from(0),
      value<&AnalysisSpec::boxes>("boxes", "", "Boxes along x, y, z; 0 = about four mean diameters each.").from(0),
      value<&AnalysisSpec::region_lower>("region_lower", "m",
                                         "Lower corner of the region to look at; equal to region_upper = everything."),
      value<&AnalysisSpec::region_upper>("region_upper", "m", "Its upper corner."),
      value<&AnalysisSpec::bins>("bins", "", "Of histograms, and of roses over the full circle.").from(1).to(100000),
      value<&AnalysisSpec::rdf_range>("rdf_range", "m", "Of radial distributions; 0 = five mean diameters.").from(0),
      value<&AnalysisSpec::rdf_bins>("rdf_bins", "", "Their shells.").from(1).to(1000000),
      value<&AnalysisSpec::voronoi_points>("voronoi_points", "",
                                           "Surface points per body of set-Voronoi cells; 0 = chosen.")
          .from(0)
          .to(100000),
      value<&AnalysisSpec::split>("split", "", "What mixing and partial distributions compare.")
          .one_of(analysis::group_words()),
      value<&AnalysisSpec::strong_force>("strong_force", "",
                                         "From which part of the mean normal force on a contact is strong.")
          .above(0),
      value<&AnalysisSpec::base_wall>("base_wall", "", "Wall that a heap stands on, where it is not the lowest.")
          .refers("wall"),
  };
}

}  // namespace dem
