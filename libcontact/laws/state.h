// What a force law is. One struct per law, one header per law, in four families: normal, tangential, rolling (with
// twisting) and cohesion. All functions are static and free of branches per lane: T is double, a SIMD pack, or an
// extended-precision number. What a contact remembers is handed in.
//
//   static constexpr const char *name, *parameters, *remark, *source;
//       name: the word in scenes. parameters: members of PairOf that it reads beside those of the others, with units,
//       separated by ", "; "" for none.
//   template <class T> struct State { … };
//       what it remembers, T or Vec3<T> only, Vec3 first; all zero at first contact. Empty: nothing.
//   static constexpr int vectors;  how many leading Vec3 of the State lie in the tangent plane and turn with it; they
//       have been turned when update is called. (Left out: 0.)
//
//   normal      template <class T> static NormalForce<T> update(const PairOf<T>&, const Kinematics<T>&,
//                   const LawOptions&, State<T>&)
//               static constexpr Loss loss: what becomes of the work that its elastic part does not give back.
//               A law that holds on across a gap has `static constexpr bool adheres = true`, a State that begins with
//               `T bonded` (1 from the first touch until it lets go) and
//               static double range(const PairParameters&, double radius_eff): the widest gap, m.
//               static constexpr double damping_factor: c = factor · β sqrt(m* k); 0 without such a dashpot.
//   tangential  template <class T> static TangentialForce<T> update(const PairOf<T>&, const Kinematics<T>&,
//                   const NormalForce<T>&, const LawOptions&, State<T>&)
//               its State begins with `Vec3<T> force`, the elastic force on b, which the History of a record holds.
//   rolling     template <class T> static Moment<T> update(… the same …)
//   cohesion    template <class T> static Pull<T> update(… the same …)
//               static double range(const PairParameters&, const LawOptions&, double radius_eff)
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>

#include "libcontact/laws/kinematics.h"
#include "libcontact/laws/law.h"

namespace contact {

enum class Loss { none, plastic, adhesive };

template <class Law>
inline constexpr std::size_t state_words = std::is_empty_v<typename Law::template State<double>>
                                               ? 0
                                               : sizeof(typename Law::template State<double>) / 8;

template <class Law>
inline constexpr int state_vectors = [] {
  if constexpr (requires { Law::vectors; })
    return Law::vectors;
  else
    return 0;
}();

template <class Law>
inline constexpr bool law_adheres = [] {
  if constexpr (requires { Law::adheres; })
    return Law::adheres;
  else
    return false;
}();

template <class T>
struct NoState {};

// min over the step's contact radius of Hertz, a² = R* δ: sqrt(δ/δ_before) while unloading, else 1.
template <class T>
T root_shrink(const Kinematics<T>& k, bool rescale) {
  using std::sqrt;
  const auto unloading = k.overlap < k.overlap_before;
  if (!rescale) return T(1);
  return select(unloading, sqrt(k.overlap / select(unloading, k.overlap_before, T(1))), T(1));
}

// A coefficient times what it multiplies: not μ F where μ is infinite and F is not there.
template <class T>
T capped(const T& coefficient, const T& force) {
  return select(force > T(0), coefficient * force, T(0));
}
// v, where `longer` than the cap shortened to it.
template <class M, class T>
Vec3<T> shortened(const Vec3<T>& v, const M& longer, const T& square, const T& cap) {
  using std::sqrt;
  return v * select(longer, cap / sqrt(select(longer, square, T(1))), T(1));
}
// Of partial slip, what comes back of a force of this size when the slip reverses, J:
//   0.3 (Ft²/k) (2 + 4c + 6c² + 3c³)/(1 + c + c²)²
template <class T>
T partial_slip_energy(const T& size, const T& compliance, const T& c) {
  const T c1 = T(1) + c + c * c;
  return T(0.3) * size * size * compliance * (T(2) + c * (T(4) + c * (T(6) + T(3) * c))) / (c1 * c1);
}

}  // namespace contact
