// The keys of [periodic].
#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem {

using bind::tables;
using bind::value;

namespace {

std::vector<Key> deform_keys() {
  return {
      value<&DeformSpec::start>("start", "s", "From this time on, until the start of the next entry.").from(0),
      value<&DeformSpec::strain_rates>("strain_rates", "1/s",
                                       "Rates of the box lengths, over the lengths; negative compresses."),
  };
}

}  // namespace

std::vector<Key> periodic_keys() {
  const std::vector<std::string> some{"x", "y", "z", "xy", "xz", "yz", "xyz"};
  std::vector<std::string> all{"none"};
  all.insert(all.end(), some.begin(), some.end());
  return {
      value<&PeriodicSpec::axes>("axes", "", "The axes along which what leaves the box enters it at the other side.")
          .one_of(all),
      value<&PeriodicSpec::lower>("lower", "m", "Lower corner of the box; its components along the axes count.")
          .when("axes", some)
          .must(),
      value<&PeriodicSpec::upper>("upper", "m", "Upper corner.").when("axes", some).must(),
      tables<&PeriodicSpec::deform>("deform", "How the box deforms, about its centre; it takes the bodies along.",
                                    deform_keys())
          .when("axes", some),
  };
}

}  // namespace dem
