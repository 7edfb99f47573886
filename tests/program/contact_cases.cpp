// dem contact on the case file: every case within its tolerance, right state, bounds that hold and are narrow.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "libcontact/dispatch.h"
#include "tests/program/program.h"

namespace {

using nlohmann::json;
using program::Folder;
using program::Outcome;

const std::string cases_file = TEST_DATA_DIR "/cases.json";

TEST(ContactCases, EveryCaseIsAnsweredWithinItsTolerance) {
  const Folder folder;
  const Outcome o = program::dem({"contact", cases_file, "--json", folder.path("out.json")});
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  const json cases = json::parse(program::read(cases_file))["cases"];
  const json results = json::parse(program::read(folder.path("out.json")))["results"];
  ASSERT_EQ(results.size(), cases.size());
  const double inf = std::numeric_limits<double>::infinity();
  int answered = 0, unproven = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const json &c = cases[i], &r = results[i], &e = c["expect"];
    SCOPED_TRACE(c["id"].get<std::string>());
    EXPECT_EQ(r["id"], c["id"]);
    const std::size_t dim = c["dim"];
    ++answered;
    ASSERT_TRUE(r["gap"].is_number());
    const double gap = r["gap"], lower = r["gap_lower"], upper = r["gap_upper"];
    const double known = e["signed_gap"], tolerance = e["abs_tol"];
    EXPECT_LE(std::abs(gap - known), tolerance);
    // `known` is the double nearest to the exact value.
    EXPECT_LE(lower, std::nextafter(known, inf));
    EXPECT_GE(upper, std::nextafter(known, -inf));
    EXPECT_LE(upper - lower, 4 * tolerance);
    EXPECT_TRUE(lower <= gap && gap <= upper);
    if (e["state"] != "touching") {
      EXPECT_EQ(r["status"], e["state"]);
    } else {
      EXPECT_NE(r["status"], "not_converged");
    }
    EXPECT_TRUE(r["method"].is_string());
    // Two ellipses that overlap deeply may have several maxima: best of many starts, said to be uncertified.
    const bool ellipses = c["shape_a"]["type"] == "ellipse" && c["shape_b"]["type"] == "ellipse";
    EXPECT_TRUE(r["certified"].get<bool>() || ellipses);
    unproven += !r["certified"].get<bool>();
    // The witness points are a gap apart.
    double square = 0;
    for (std::size_t k = 0; k < dim; ++k) {
      const double d = r["point_b"][k].get<double>() - r["point_a"][k].get<double>();
      square += d * d;
    }
    double far = 0;
    for (std::size_t k = 0; k < dim; ++k) far = std::max(far, std::abs(c["pose_a"]["position"][k].get<double>()));
    EXPECT_NEAR(std::sqrt(square), std::abs(gap), 4 * tolerance + 8 * far * 0x1p-52);
    if (e["normals"].is_null()) continue;
    double best = inf;
    for (const json& n : e["normals"]) {
      double difference = 0;
      for (std::size_t k = 0; k < dim; ++k) {
        const double d = n[k].get<double>() - r["normal"][k].get<double>();
        difference += d * d;
      }
      best = std::min(best, 2 * std::asin(std::min(1.0, std::sqrt(difference) / 2)));
    }
    EXPECT_LE(best, e["normal_tol"].get<double>());
  }
  EXPECT_EQ(answered, 77);
  EXPECT_LE(unproven, 3);
  EXPECT_NE(o.out.find("77 of 77 cases within tolerance"), std::string::npos) << o.out;
}

// Whatever the method: the bounds of an answer hold the known gap, the lower one always, the upper one when certified.
// An exact method is within the tolerance as well; how many answers of an approximate one are is printed.
TEST(ContactCases, BoundsOfEveryMethodHold) {
  const json cases = json::parse(program::read(cases_file))["cases"];
  const double inf = std::numeric_limits<double>::infinity();
  std::map<std::string, bool> methods;
  for (const auto* m = contact::methods_begin(); m != contact::methods_end(); ++m)
    methods[std::string(m->name)] = m->exact;
  for (const auto& [method, exact] : methods) {
    SCOPED_TRACE(method);
    const Folder folder;
    program::dem({"contact", cases_file, "--method", method, "--json", folder.path("out.json")});
    const json results = json::parse(program::read(folder.path("out.json")))["results"];
    ASSERT_EQ(results.size(), cases.size());
    int asked = 0, within = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const json &r = results[i], &e = cases[i]["expect"];
      if (r["status"] == "refused") continue;  // not its pair
      SCOPED_TRACE(cases[i]["id"].get<std::string>());
      ++asked;
      const double known = e["signed_gap"], tolerance = e["abs_tol"];
      EXPECT_LE(r["gap_lower"].get<double>(), std::nextafter(known, inf));
      if (r["certified"]) {
        EXPECT_GE(r["gap_upper"].get<double>(), std::nextafter(known, -inf));
      }
      const bool right = std::abs(r["gap"].get<double>() - known) <= tolerance;
      EXPECT_TRUE(right || !exact);
      within += right;
    }
    std::printf("%-25s %2d of %2d within tolerance\n", method.c_str(), within, asked);
  }
}

std::string sphere_case(const std::string& id, const std::string& x) {
  const std::string shape = R"({"type": "sphere", "radius": 1})";
  const auto pose = [](const std::string& at) {
    return "{\"position\": [" + at + ", 0, 0], \"quaternion\": [1, 0, 0, 0]}";
  };
  return "{\"id\": \"" + id + "\", \"shape_a\": " + shape + ", \"shape_b\": " + shape + ", \"pose_a\": " + pose("10") +
         ", \"pose_b\": " + pose(x) + "}";
}

TEST(ContactCases, AnswersAreInWorldCoordinates) {
  const Folder folder;
  const std::string file = folder.write("cases.json", "{\"cases\": [" + sphere_case("apart", "13") + "]}");
  ASSERT_EQ(program::dem({"contact", file, "--json", folder.path("out.json")}).exit_code, 0);
  const json r = json::parse(program::read(folder.path("out.json")))["results"][0];
  EXPECT_EQ(r["status"], "separated");
  EXPECT_EQ(r["gap"], 1.0);
  EXPECT_EQ(r["normal"], json({1.0, 0.0, 0.0}));
  EXPECT_EQ(r["point_a"], json({11.0, 0.0, 0.0}));
  EXPECT_EQ(r["point_b"], json({12.0, 0.0, 0.0}));
  EXPECT_EQ(r["method"], "analytic");
}

TEST(ContactCases, MethodAndTolerance) {
  const Folder folder;
  const std::string file = folder.write("cases.json", "{\"cases\": [" + sphere_case("apart", "13.1") + "]}");
  const Outcome wrong = program::dem({"contact", file, "--method", "analitic"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("did you mean analytic?"), std::string::npos) << wrong.err;
  // A method that does not answer this pair refuses it: that is an answer.
  EXPECT_EQ(program::dem({"contact", file, "--method", "support_newton"}).exit_code, 0);
  // No bounds are as narrow as this.
  EXPECT_EQ(program::dem({"contact", file, "--tolerance", "1e-30"}).exit_code, 1);
  EXPECT_EQ(program::dem({"contact", file, "--tolerance", "1e-12"}).exit_code, 0);
}

}  // namespace
