// Numbers in which the expected values are computed: 50 digits where Boost is installed, else long double.
#pragma once

#ifdef BENCH_HAS_BOOST
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
namespace laws {
using Digits = boost::multiprecision::cpp_bin_float_50;
inline Digits pi() { return boost::math::constants::pi<Digits>(); }
inline Digits gamma_function(const Digits& x) { return boost::math::tgamma(x); }
inline double as_double(const Digits& x) { return x.convert_to<double>(); }
}  // namespace laws
#else
#include <cmath>
#include <numbers>
namespace laws {
using Digits = long double;
inline Digits pi() { return std::numbers::pi_v<long double>; }
inline Digits gamma_function(const Digits& x) { return std::tgamma(x); }
inline double as_double(const Digits& x) { return static_cast<double>(x); }
}  // namespace laws
#endif
