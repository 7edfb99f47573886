#include "libdem/validate/list.h"

namespace dem::validate {

extern const Validation two_bodies, box_stack, vibrated_bed, triaxial_fcc, biaxial_2d, silo, hopper_slot, drum, pile_2d,
    isotropic_periodic, direct_shear, compaction, v_mixer, die_filling_2d, law_extremes_entry;

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
      &pile_2d,             //
      &isotropic_periodic,  //
      &direct_shear,        //
      &compaction,          //
      &v_mixer,             //
      &die_filling_2d,      //
      &law_extremes_entry,  //
  };
  return list;
}

}  // namespace dem::validate
