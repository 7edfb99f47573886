#include <cmath>

#include "libcontact/laws/mix.h"
#include "libdem/law_driver/spec.h"
#include "libdem/laws_of_scene.h"
#include "libdem/reference_stiffness.h"

namespace dem::law_driver {

Setup setup_of(const LawTest& test) {
  const auto& materials = test.scene.materials;
  const auto index = [&](const std::string& name, std::size_t otherwise) {
    for (std::size_t i = 0; i < materials.size(); ++i)
      if (materials[i].name == name) return i;
    return otherwise;
  };
  const std::size_t i = index(test.a.material, 0), j = index(test.b.material, materials.size() - 1);
  const LawSpec& law = test.scene.law;
  Setup s{{law_model_of(law), contact::mix(material_of(materials[i], law), material_of(materials[j], law), law.clip),
           law_options_of(law)},
          solid_ball(test.a.radius, test.a.mass),
          test.b.radius > 0 ? solid_ball(test.b.radius, test.b.mass) : Ball{}};
  bool stiffness_given = false;
  const std::string &one = materials[i].name, &other = materials[j].name;
  for (const MaterialPairSpec& p : test.scene.pairs) {
    if (!((p.a == one && p.b == other) || (p.a == other && p.b == one))) continue;
    override_pair(s.contact.pair, p, law.clip);
    stiffness_given = !std::isnan(p.stiffness);
  }
  set_bodies(s.contact, s.a, s.b);
  if (law.reference_speed > 0 && !stiffness_given)
    set_reference_stiffness(s.contact.pair, s.contact.radius_eff, s.contact.mass_eff, law.reference_speed);
  return s;
}

double contact_duration(const Setup& s, double normal_speed) {
  const Rebound r =
      impact(s.contact, s.a, s.b, {.normal_speed = normal_speed, .dt = automatic_step(s.contact, s.a, s.b)});
  return r.ended ? r.duration : 2 * r.peak_time;
}

Approach approach_of(const LawTest& test, const Setup& setup) {
  const ImpactOfTest& i = test.impact;
  Approach a{i.normal(), i.tangential(), i.spin, i.spin_b, i.dt, i.phase};
  if (i.steps_per_contact > 0)
    a.dt = contact_duration(setup, a.normal_speed) / i.steps_per_contact;
  else if (!(a.dt > 0))
    a.dt = automatic_step(setup.contact, setup.a, setup.b);
  return a;
}

}  // namespace dem::law_driver
