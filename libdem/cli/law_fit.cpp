#include "libdem/cli/law_fit.h"

#include <fmt/format.h>

#ifdef CONTACT_HAS_NLOPT
#include <nlopt.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "libdem/cli/commands.h"
#include "libdem/io/io.h"

namespace dem::cli {

#ifndef CONTACT_HAS_NLOPT

int fit_law(const law_driver::LawTest&, const std::string&) {
  throw InputError("--fit needs NLopt, which this program was built without (libnlopt-dev, then build again)");
}

#else

namespace {

using namespace law_driver;

// What a measurement can hold of an impact.
struct Quantity {
  const char* name;
  const char* unit;
  double (*of)(const Rebound&);
  double scale;  // of its residual; 0: the measured value
};
constexpr double degree = std::numbers::pi / 180;
constexpr Quantity quantities[] = {
    {"restitution", "", [](const Rebound& r) { return r.restitution; }, 1},
    {"tangential_restitution", "", [](const Rebound& r) { return r.tangential_restitution; }, 1},
    {"rebound_angle_deg", " deg",
     [](const Rebound& r) { return std::atan2(r.tangential_speed, -r.normal_speed) / degree; }, 1 / degree},
    {"duration", " s", [](const Rebound& r) { return r.duration; }, 0},
};
constexpr std::size_t quantity_count = std::size(quantities);

struct Measured {
  Approach how;
  std::optional<double> value[quantity_count];
};

std::vector<Measured> read_measured(const std::string& file, const LawTest& test) {
  const io::Table t = io::read_csv(file);
  for (const std::string& c : t.columns) {
    static const std::vector<std::string> motion{"speed",        "angle_deg",        "impact_angle_deg",
                                                 "normal_speed", "tangential_speed", "spin"};
    const bool known =
        std::find(motion.begin(), motion.end(), c) != motion.end() ||
        std::any_of(std::begin(quantities), std::end(quantities), [&](const Quantity& q) { return c == q.name; });
    if (!known)
      input_error({file, t.header_line, 0},
                  fmt::format("column {} is none of {}, restitution, tangential_restitution, rebound_angle_deg, "
                              "duration",
                              c, fmt::join(motion, ", ")));
  }
  std::vector<Measured> list;
  for (std::size_t r = 0; r < t.row_count(); ++r) {
    ImpactOfTest i = test.impact;
    const auto take = [&](const char* name, double& into) {
      const auto c = io::find_column(t, name);
      if (c) into = io::number(t, r, *c);
      return c.has_value();
    };
    if (take("speed", i.speed)) i.normal_speed = 0;
    if (take("normal_speed", i.normal_speed)) i.speed = i.angle_deg = 0;
    take("angle_deg", i.angle_deg);
    take("impact_angle_deg", i.angle_deg);
    take("tangential_speed", i.tangential_speed);
    take("spin", i.spin);
    if (!(i.normal() > 0) || std::abs(i.angle_deg) >= 90)
      input_error({file, t.lines[r], 0}, "needs an impact: speed > 0 with |angle_deg| < 90, or normal_speed > 0");
    Measured m{{i.normal(), i.tangential(), i.spin, i.spin_b, 0, i.phase}, {}};
    bool any = false;
    for (std::size_t q = 0; q < quantity_count; ++q) {
      const auto c = io::find_column(t, quantities[q].name);
      if (!c || t.cell(r, *c).empty()) continue;
      const double value = io::number(t, r, *c);
      m.value[q] = value;
      if (quantities[q].scale == 0 && !(value > 0))
        input_error(t.where(r, *c), fmt::format("{} must be > 0", quantities[q].name));
      any = true;
    }
    if (any) list.push_back(m);
  }
  if (list.empty()) input_error({file, t.header_line, 0}, "no row holds anything that was measured");
  return list;
}

// One number of a material that is looked for, on a scale of its own.
struct Unknown {
  const char* name;
  const char* unit;
  double MaterialSpec::*value;
  double MaterialPairSpec::*override_by;  // null: none
  bool of_pair;                           // both materials get it, else that of a
  bool logarithmic;                       // three decades either way
  double lower, upper;
};
constexpr Unknown unknowns[] = {
    {"friction", "", &MaterialSpec::friction, &MaterialPairSpec::friction, true, false, 0, 2},
    {"restitution", "", &MaterialSpec::restitution, &MaterialPairSpec::restitution, true, false, 0.01, 1},
    {"young", " Pa", &MaterialSpec::young, nullptr, false, true, 0, 0},
    {"stiffness", " N/m", &MaterialSpec::stiffness, &MaterialPairSpec::stiffness, false, true, 0, 0},
};

class Fit {
 public:
  Fit(const LawTest& test, std::vector<Measured> measured) : test_(test), measured_(std::move(measured)) {
    for (const std::string& name : test.fit.parameters)
      for (const Unknown& u : unknowns)
        if (name == u.name) add(u);
  }

  std::size_t size() const { return unknown_.size(); }
  const Unknown& unknown(std::size_t i) const { return *unknown_[i]; }
  double value(std::size_t i, double x) const { return unknown_[i]->logarithmic ? std::exp(x) : x; }

  double sum(const std::vector<double>& x, double (*squares)[quantity_count] = nullptr) const {
    const Setup setup = setup_of(with(x));
    LawTest step = test_;
    double total = 0;
    for (const Measured& m : measured_) {
      Approach how = m.how;
      step.impact.normal_speed = how.normal_speed;
      how.dt = approach_of(step, setup).dt;
      const Rebound r = impact(setup.contact, setup.a, setup.b, how);
      for (std::size_t q = 0; q < quantity_count; ++q) {
        const std::optional<double>& value = m.value[q];
        if (!value) continue;
        const double miss = quantities[q].of(r) - *value;
        const double part = miss / (quantities[q].scale > 0 ? quantities[q].scale : *value);
        total += part * part;
        if (squares) (*squares)[q] += miss * miss;
      }
    }
    return total;
  }

  std::vector<double> find() const {
    std::vector<double> x = start_;
    const auto objective = [](unsigned, const double* at, double*, void* self) {
      const Fit& fit = *static_cast<const Fit*>(self);
      return fit.sum({at, at + fit.size()});
    };
    for (const auto& [algorithm, evaluations] :
         {std::pair{NLOPT_GN_DIRECT_L, 40 * static_cast<int>(size())}, std::pair{NLOPT_LN_SBPLX, 400}}) {
      const std::unique_ptr<std::remove_pointer_t<nlopt_opt>, decltype(&nlopt_destroy)> search(
          nlopt_create(algorithm, static_cast<unsigned>(size())), nlopt_destroy);
      nlopt_set_lower_bounds(search.get(), lower_.data());
      nlopt_set_upper_bounds(search.get(), upper_.data());
      nlopt_set_min_objective(search.get(), objective, const_cast<Fit*>(this));
      nlopt_set_maxeval(search.get(), evaluations);
      nlopt_set_xtol_rel(search.get(), 1e-7);
      double least = 0;
      const nlopt_result end = nlopt_optimize(search.get(), x.data(), &least);
      if (end < 0 && end != NLOPT_ROUNDOFF_LIMITED) throw RunError("NLopt gave up on the fit");
    }
    return x;
  }

  bool at_an_end(const std::vector<double>& x, std::size_t i) const {
    return std::min(x[i] - lower_[i], upper_[i] - x[i]) < 1e-6 * (upper_[i] - lower_[i]);
  }
  // Whether the sum cares about it: by a hundredth of its range either way.
  bool matters(const std::vector<double>& x, std::size_t i) const {
    const double h = 0.01 * (upper_[i] - lower_[i]);
    double change = 0;
    for (const double to : {std::min(x[i] + h, upper_[i]), std::max(x[i] - h, lower_[i])}) {
      std::vector<double> y = x;
      y[i] = to;
      change = std::max(change, std::abs(sum(y) - sum(x)));
    }
    return change > 1e-10 * static_cast<double>(measured_.size());
  }

 private:
  void add(const Unknown& u) {
    const double now = material_of_a(test_).*u.value;
    if (u.logarithmic && !(now > 0))
      throw InputError(
          fmt::format("{}: fit.parameters names {}, which the material of a does not state: it is where "
                      "the search begins",
                      test_.scene.path, u.name));
    unknown_.push_back(&u);
    constexpr double decades = 6.907755278982137;  // ln 1000
    lower_.push_back(u.logarithmic ? std::log(now) - decades : u.lower);
    upper_.push_back(u.logarithmic ? std::log(now) + decades : u.upper);
    start_.push_back(std::clamp(u.logarithmic ? std::log(now) : now, lower_.back(), upper_.back()));
  }

  static MaterialSpec& material_of_a(LawTest& t) {
    for (MaterialSpec& m : t.scene.materials)
      if (m.name == t.a.material) return m;
    return t.scene.materials.front();
  }
  static const MaterialSpec& material_of_a(const LawTest& t) { return material_of_a(const_cast<LawTest&>(t)); }

  LawTest with(const std::vector<double>& x) const {
    LawTest t = test_;
    for (std::size_t i = 0; i < size(); ++i) {
      const Unknown& u = *unknown_[i];
      material_of_a(t).*u.value = value(i, x[i]);
      for (MaterialSpec& m : t.scene.materials)
        if (u.of_pair) m.*u.value = value(i, x[i]);
      for (MaterialPairSpec& p : t.scene.pairs)
        if (u.override_by) p.*u.override_by = std::numeric_limits<double>::quiet_NaN();
    }
    return t;
  }

  LawTest test_;
  std::vector<Measured> measured_;
  std::vector<const Unknown*> unknown_;
  std::vector<double> lower_, upper_, start_;
};

}  // namespace

int fit_law(const LawTest& test, const std::string& file) {
  if (test.fit.parameters.empty())
    throw InputError(test.scene.path + ": --fit needs [fit] parameters = [\"friction\", …]");
  const std::vector<Measured> measured = read_measured(file, test);
  const Fit fit(test, measured);
  const std::vector<double> x = fit.find();
  for (std::size_t i = 0; i < fit.size(); ++i)
    fmt::print("{:<26} {:.6g}{}{}\n", fit.unknown(i).name, fit.value(i, x[i]), fit.unknown(i).unit,
               !fit.matters(x, i)    ? "   (these measurements do not depend on it here)"
               : fit.at_an_end(x, i) ? "   (the end of its range)"
                                     : "");
  double squares[quantity_count] = {};
  fit.sum(x, &squares);
  for (std::size_t q = 0; q < quantity_count; ++q) {
    const auto count =
        std::count_if(measured.begin(), measured.end(), [q](const Measured& m) { return m.value[q].has_value(); });
    if (count > 0)
      fmt::print("rms of {:<19} {:.4g}{} over {} values\n", quantities[q].name,
                 std::sqrt(squares[q] / static_cast<double>(count)), quantities[q].unit, count);
  }
  fmt::print("impacts                    {}\n", measured.size());
  return success;
}

#endif

}  // namespace dem::cli
