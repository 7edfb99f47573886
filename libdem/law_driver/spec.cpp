#include "libdem/law_driver/spec.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "libdem/scene/reader.h"
#include "libdem/scene/rules.h"
#include "libdem/scene/schema_bind.h"
#include "libdem/scene/schema_tables.h"

namespace dem::law_driver {
namespace {

using bind::table;
using bind::value;

// A table of the scene that stands inside the test.
template <auto M>
Key scene_table(Key key) {
  key.append = [](void* spec) -> void* {
    auto& member = static_cast<LawTest*>(spec)->scene.*M;
    if constexpr (requires { member.emplace_back(); })
      return &member.emplace_back();
    else
      return &member;
  };
  key.count = nullptr;  // a test is read, never written
  key.at = nullptr;
  return key;
}

std::vector<Key> body_keys(bool first) {
  Key radius = value<&BodyOfTest::radius>("radius", "m", first ? "Radius of the ball." : "Left out: a plane.").above(0);
  if (first) radius.must();
  return {radius, value<&BodyOfTest::mass>("mass", "kg", "In place of radius and density.").above(0),
          value<&BodyOfTest::density>("density", "kg/m^3", "In place of the material's.").above(0),
          value<&BodyOfTest::material>("material", "", "Its material; left out: a has the first one, b the last.")
              .refers("material")};
}

std::shared_ptr<const Section> whole() {
  return bind::section<LawTest>({
      value<&LawTest::title>("title", "", "One line about the test."),
      scene_table<&Scene::law>(table<&Scene::law>("law", "The force law.", law_keys())).must(),
      scene_table<&Scene::materials>(bind::tables<&Scene::materials>("material", "A material.", material_keys()))
          .must(),
      scene_table<&Scene::pairs>(
          bind::tables<&Scene::pairs>("material_pair", "What two materials do together.", pair_keys())),
      table<&LawTest::a>("a", "The ball.", body_keys(true)).must(),
      table<&LawTest::b>("b", "Another ball, or a plane that is held.", body_keys(false)),
      table<&LawTest::path>(
          "path", "A path to follow.",
          {value<&PathOfTest::file>("file", "", "CSV with columns t, overlap, slip_x, slip_y [, rotation].").as_file(),
           value<&PathOfTest::rows>("rows", "", "The same inline: [t, overlap, slip_x, slip_y], ..."),
           value<&PathOfTest::substeps>("substeps", "", "Steps between two rows.").from(1).to(1e9)}),
      table<&LawTest::impact>(
          "impact", "An impact.",
          {value<&ImpactOfTest::speed>("speed", "m/s", "Of a relative to b.").above(0),
           value<&ImpactOfTest::angle_deg>("angle_deg", "", "Of the velocity from the normal, degrees.")
               .from(0)
               .to(89.9),
           value<&ImpactOfTest::normal_speed>("normal_speed", "m/s", "In place of speed and angle_deg.").above(0),
           value<&ImpactOfTest::tangential_speed>("tangential_speed", "m/s", "Beside normal_speed."),
           value<&ImpactOfTest::spin>("spin", "rad/s",
                                      "Of a; with a positive one its point at the contact moves forwards."),
           value<&ImpactOfTest::spin_b>("spin_b", "rad/s", "Of b."),
           value<&ImpactOfTest::dt>("dt", "s", "Step; left out: that of run.dt = \"auto\".").above(0),
           value<&ImpactOfTest::steps_per_contact>("steps_per_contact", "", "In place of dt.").from(1).to(1e9),
           value<&ImpactOfTest::phase>("phase", "", "Share of its first step that is over when the two touch.")
               .from(0)
               .to(0.999)}),
      table<&LawTest::fit>(
          "fit", "What --fit looks for.",
          {value<&FitOfTest::parameters>("parameters", "", "Any of friction, restitution, young, stiffness.")
               .one_of({"friction", "restitution", "young", "stiffness"})
               .must()}),
  });
}

class TestRules {
 public:
  TestRules(const RuleContext& context, LawTest& test) : c_(context), t_(test) {}

  void check() {
    if (t_.scene.materials.size() > 2) c_.wrong("material", 2, nullptr, "two bodies have two materials at the most");
    const MaterialSpec &m = material(t_.a, 0), &w = material(t_.b, t_.scene.materials.size() - 1);
    if (m.rigid && w.rigid) c_.wrong("a", 0, nullptr, "two rigid materials never meet");
    body("a", t_.a, m);
    if (t_.b.radius > 0)
      body("b", t_.b, w);
    else
      for (const char* key : {"mass", "density"})
        if (c_.node("b", 0, key)) c_.wrong("b", 0, key, "a plane (b without a radius) is held");
    if (t_.has_path && t_.has_impact) c_.wrong("path", 0, nullptr, "give [path] or [impact], not both");
    if (t_.has_path) path();
    if (t_.has_impact) impact();
  }

  const MaterialSpec& material(const BodyOfTest& body, std::size_t otherwise) const {
    for (const MaterialSpec& m : t_.scene.materials)
      if (m.name == body.material) return m;
    return t_.scene.materials[otherwise];
  }

 private:
  void body(const char* name, BodyOfTest& body, const MaterialSpec& material) {
    if (c_.node(name, 0, "mass") && c_.node(name, 0, "density"))
      c_.wrong(name, 0, "density", "give mass or density, not both");
    const double density = body.density > 0 ? body.density : material.density;
    if (!(body.mass > 0))
      body.mass = density * (4.0 / 3.0) * std::numbers::pi * body.radius * body.radius * body.radius;
    if (!(body.mass > 0)) c_.wrong(name, 0, nullptr, "needs mass, density, or a material with one");
  }

  void path() {
    if (t_.path.file.empty() == t_.path.rows.empty()) return c_.wrong("path", 0, nullptr, "needs file or rows");
    const std::vector<std::array<double, 4>>& rows = t_.path.rows;
    if (rows.size() == 1) c_.wrong("path", 0, "rows", "a path needs two rows at least");
    for (std::size_t i = 1; i < rows.size(); ++i)
      if (!(rows[i][0] > rows[i - 1][0]))
        return c_.errors.add(c_.node("path", 0, "rows")->items[i].position,
                             fmt::format("path.rows: t = {} must be larger than that of the row before, {}", rows[i][0],
                                         rows[i - 1][0]));
  }

  void impact() {
    const auto given = [&](const char* key) { return c_.node("impact", 0, key) != nullptr; };
    if (given("speed") == given("normal_speed"))
      return c_.wrong("impact", 0, nullptr, "needs speed (with angle_deg) or normal_speed (with tangential_speed)");
    if (given("normal_speed") && given("angle_deg")) c_.wrong("impact", 0, "angle_deg", "goes with speed");
    if (given("speed") && given("tangential_speed"))
      c_.wrong("impact", 0, "tangential_speed", "goes with normal_speed");
    if (given("dt") && given("steps_per_contact"))
      c_.wrong("impact", 0, "dt", "give dt or steps_per_contact, not both");
  }

  RuleContext c_;
  LawTest& t_;
};

}  // namespace

double ImpactOfTest::normal() const {
  return normal_speed > 0 ? normal_speed : speed * std::cos(angle_deg * std::numbers::pi / 180);
}
double ImpactOfTest::tangential() const {
  return normal_speed > 0 ? tangential_speed : speed * std::sin(angle_deg * std::numbers::pi / 180);
}

LawTest load_law_test(const std::string& file) {
  if (!std::filesystem::is_regular_file(file)) input_error({file, 0, 0}, "no such file");
  const Node root = read_toml_file(file);
  static const std::shared_ptr<const Section> section = whole();
  LawTest test;
  test.scene.path = file;
  Errors errors({file});
  read_table(*section, root, &test, errors);
  errors.throw_if_any();
  apply_libraries(root, test.scene, errors);
  errors.throw_if_any();
  test.has_path = root.get("path") != nullptr;
  test.has_impact = root.get("impact") != nullptr;
  const RuleContext context{root, test.scene, errors};
  check_law_rules(context);
  TestRules(context, test).check();
  errors.throw_if_any();
  return test;
}

}  // namespace dem::law_driver
