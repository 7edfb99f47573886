// The list of methods: the only place that names them all. The dispatch table, the catalogue and the property tests are
// derived from it; which pairs a method answers follows from its `query` overloads (methods/method.h).
#pragma once

#include <tuple>
#include <utility>

#include "libcontact/methods/analytic.h"
#include "libcontact/methods/ccd.h"
#include "libcontact/methods/clip.h"
#include "libcontact/methods/clip_volume.h"
#include "libcontact/methods/common_normal.h"
#include "libcontact/methods/constrained_minimisation.h"
#include "libcontact/methods/fcl.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/geometric_potential.h"
#include "libcontact/methods/gjk_epa.h"
#include "libcontact/methods/intersection_midpoint.h"
#include "libcontact/methods/mpr.h"
#include "libcontact/methods/nlopt.h"
#include "libcontact/methods/perram_wertheim.h"
#include "libcontact/methods/planar.h"
#include "libcontact/methods/polyhedron_plane.h"
#include "libcontact/methods/potential.h"
#include "libcontact/methods/rounded.h"
#include "libcontact/methods/sat.h"
#include "libcontact/methods/support_newton.h"
#include "libcontact/methods/vertex_triangle.h"

namespace contact {

// By other libraries, where the build has them.
#ifdef CONTACT_HAS_CCD
using CcdMethods = std::tuple<CcdMpr, CcdGjkEpa>;
#else
using CcdMethods = std::tuple<>;
#endif
#ifdef CONTACT_HAS_FCL
using FclMethods = std::tuple<Fcl>;
#else
using FclMethods = std::tuple<>;
#endif
#ifdef CONTACT_HAS_NLOPT
using NloptMethods = std::tuple<Nlopt>;
#else
using NloptMethods = std::tuple<>;
#endif

using OwnMethods = std::tuple<Analytic, PolyhedronPlane, SupportNewton, Sat, Features, Rounded, Potential, Planar,
                              PerramWertheim, GeometricPotential, CommonNormal, IntersectionMidpoint, Clip,
                              VertexTriangle, ClipVolume, ConstrainedMinimisation, Mpr, GjkEpa>;

using Methods = decltype(std::tuple_cat(std::declval<OwnMethods>(), std::declval<CcdMethods>(),
                                        std::declval<FclMethods>(), std::declval<NloptMethods>()));

}  // namespace contact
