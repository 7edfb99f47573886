// What the methods by other libraries have in common: the pairs that they answer, and where their cost ranks begin.
#pragma once

#include "libcontact/methods/convex_body.h"

namespace contact {

// Above those of all methods of our own.
inline constexpr int first_rank_of_other_libraries = 100;

// Two bodies of space: their searches need a difference that has an inside.
template <class A, class B>
concept ConvexSolids =
    ConvexKinds<A, B> && !shapes::is_wall(shapes::kind_of<B>()) && shapes::dimension_of(shapes::kind_of<A>()) == 3;

}  // namespace contact
