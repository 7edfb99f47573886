// dem contact: answers the pair queries of a case file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "libdem/cli/cases.h"
#include "libdem/cli/commands.h"
#include "libdem/io/files.h"
#include "libdem/scene/nearest.h"
#include "libdem/scene/scene.h"

namespace dem::cli {

namespace {

using contact::Contact;
using contact::Status;

const char* name_of(Status status) {
  switch (status) {
    case Status::separated:
      return "separated";
    case Status::touching:
      return "touching";
    case Status::overlapping:
      return "overlapping";
    case Status::not_converged:
      return "not_converged";
    case Status::refused:
      break;
  }
  return "refused";
}

std::string answering_method(shapes::Kind a, shapes::Kind b, const ContactArguments& arguments) {
  const auto [low, high] = std::minmax(a, b);
  const contact::MethodInfo* m = contact::choose(low, high, arguments.method, arguments.tolerance.value_or(0));
  return m == nullptr ? "" : std::string(m->name);
}

struct Result {
  const Case* input;
  std::string method;
  Contact contact;  // in world coordinates
};

Result answer(const Case& input, const ContactArguments& arguments) {
  Result r{&input, "", {}};
  r.method = answering_method(input.a.kind, input.b.kind, arguments);
  Contact& c = r.contact;
  contact::Options wanted;
  wanted.tolerance = arguments.tolerance.value_or(0);
  c = contact::query(input.a, input.b, input.offset, wanted, arguments.method);
  if (c.status == Status::refused) return r;
  for (Vec3d* point : {&c.point_a, &c.point_b, &c.method_point}) *point += input.origin;
  if (arguments.tolerance && !((c.gap_upper - c.gap_lower) <= 2 * *arguments.tolerance * input.size))
    c.status = Status::not_converged;
  return r;
}

std::string number(double v) { return std::isfinite(v) ? fmt::format("{:.17g}", v) : "null"; }
std::string vector(const Vec3d& v) { return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z)); }

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

std::string to_json(const Result& r) {
  const Contact& c = r.contact;
  const std::string head = fmt::format("{{\"id\": {}, \"method\": {}, \"status\": \"{}\"", quoted(r.input->id),
                                       r.method.empty() ? "null" : quoted(r.method), name_of(c.status));
  if (c.status == Status::refused)
    return head +
           ", \"gap\": null, \"gap_lower\": null, \"gap_upper\": null, \"normal\": null, \"point_a\": null, "
           "\"point_b\": "
           "null, \"certified\": false, \"method_overlap\": null, \"method_normal\": null, \"method_point\": null, "
           "\"handed_over\": false, \"iterations\": 0}";
  return head +
         fmt::format(
             ", \"gap\": {}, \"gap_lower\": {}, \"gap_upper\": {}, \"normal\": {}, \"point_a\": {}, \"point_b\": {}, "
             "\"certified\": {}, \"method_overlap\": {}, \"method_normal\": {}, \"method_point\": {}, "
             "\"handed_over\": {}, \"iterations\": {}}}",
             number(c.gap), number(c.gap_lower), number(c.gap_upper), vector(c.normal), vector(c.point_a),
             vector(c.point_b), c.certified, number(c.method_overlap), vector(c.method_normal), vector(c.method_point),
             c.handed_over, c.iterations);
}

// How an answer compares with what is known.
struct Verdict {
  double error = 0, width = 0;  // over abs_tol
  bool gap = false, state = false, bounds = false, narrow = false;
  double angle = 0;  // to the nearest right normal, rad
  bool normal = true;
  bool right() const { return gap && state && bounds && narrow; }
  std::string text() const {
    if (right()) return normal ? "ok" : fmt::format("ok, normal off by {:.1e} rad", angle);
    std::string out;
    for (const auto& [good, word] : {std::pair{gap, "gap"}, {state, "state"}, {bounds, "bounds"}, {narrow, "width"}})
      if (!good) out += out.empty() ? word : std::string(", ") + word;
    return "wrong: " + out;
  }
};

Verdict judge(const Contact& c, const Expected& e) {
  Verdict v;
  v.error = std::abs(c.gap - e.gap) / e.abs_tol;
  v.width = (c.gap_upper - c.gap_lower) / e.abs_tol;
  v.gap = v.error <= 1;
  v.narrow = v.width <= 4;
  // The known value is the nearest double: the exact one lies within its neighbours.
  const double inf = std::numeric_limits<double>::infinity();
  v.bounds = c.gap_lower <= std::nextafter(e.gap, inf) && c.gap_upper >= std::nextafter(e.gap, -inf);
  const bool any = e.state == "touching" && c.status != Status::not_converged;  // either side is right
  v.state = any || e.state == name_of(c.status);
  if (!e.normals.empty()) {
    v.angle = inf;
    for (const Vec3d& n : e.normals)
      v.angle = std::min(v.angle, std::atan2(norm(cross(n, c.normal)), dot(n, c.normal)));
    v.normal = v.angle <= e.normal_tol;
  }
  return v;
}

void print_table(const std::vector<Result>& results) {
  std::size_t widest = 4, judged = 0, right = 0, normals = 0, normals_right = 0;
  double worst_error = 0, worst_width = 0;
  for (const Result& r : results) widest = std::max(widest, r.input->id.size());
  fmt::print("{:<{}}  {:<18}{:<14}{:>24}  {:>9}  {:>9}  verdict\n", "id", widest, "method", "status", "gap",
             "error/tol", "width/tol");
  for (const Result& r : results) {
    const Contact& c = r.contact;
    const bool refused = c.status == Status::refused;
    fmt::print("{:<{}}  {:<18}{:<14}{:>24}", r.input->id, widest, r.method.empty() ? "-" : r.method, name_of(c.status),
               refused ? "-" : fmt::format("{:.17g}", c.gap));
    if (!refused && r.input->expected) {
      const Verdict v = judge(c, *r.input->expected);
      fmt::print("  {:>9.3f}  {:>9.3f}  {}", v.error, v.width, v.text());
      worst_error = std::max(worst_error, v.error);
      worst_width = std::max(worst_width, v.width);
      right += v.right();
      if (!r.input->expected->normals.empty()) {
        ++normals;
        normals_right += v.normal;
      }
    }
    judged += r.input->expected.has_value();
    fmt::print("\n");
  }
  if (judged == 0) return;
  fmt::print(
      "{} of {} cases within tolerance, with the right state and bounds that hold within 4 tolerances; "
      "worst error {:.3f}, widest bounds {:.3f} tolerances\n",
      right, judged, worst_error, worst_width);
  fmt::print("{} of {} stated normals right\n", normals_right, normals);
}

}  // namespace

int contact_command(const ContactArguments& arguments) {
  std::vector<std::string> names{"auto"};
  for (const auto* m = contact::methods_begin(); m != contact::methods_end(); ++m)
    if (std::find(names.begin(), names.end(), m->name) == names.end()) names.emplace_back(m->name);
  if (std::find(names.begin(), names.end(), arguments.method) == names.end())
    throw InputError(fmt::format("--method {}: allowed {}{}", arguments.method, fmt::join(names, ", "),
                                 suggestion(arguments.method, names)));
  const std::vector<Case> cases = read_cases(arguments.cases);
  std::vector<Result> results;
  for (const Case& c : cases) results.push_back(answer(c, arguments));
  if (!arguments.json.empty()) {
    std::string text = "{\"results\": [\n";
    for (std::size_t i = 0; i < results.size(); ++i)
      text += to_json(results[i]) + (i + 1 < results.size() ? ",\n" : "\n");
    io::write_file(arguments.json, text + "]}\n");
  }
  print_table(results);
  const bool unanswered = std::any_of(results.begin(), results.end(),
                                      [](const Result& r) { return r.contact.status == Status::not_converged; });
  return unanswered ? failed_run : success;
}

}  // namespace dem::cli
