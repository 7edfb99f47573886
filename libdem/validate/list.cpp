#include "libdem/validate/list.h"

namespace dem::validate {

extern const Validation two_bodies, box_stack, vibrated_bed, triaxial_fcc, biaxial_2d, silo, hopper_slot, drum,
    isotropic_periodic;

const std::vector<const Validation*>& validations() {
  static const std::vector<const Validation*> list{
      &two_bodies,          //
      &box_stack,           //
      &vibrated_bed,        //
      &triaxial_fcc,        //
      &biaxial_2d,          //
      &silo,                //
      &hopper_slot,         //
      &drum,                //
      &isotropic_periodic,  //
  };
  return list;
}

}  // namespace dem::validate
