// What bench/laws prints: item, expected, got, error, pass; and where its curves and figures go.
#pragma once

#include <string>
#include <vector>

namespace laws {

class Report {
 public:
  explicit Report(std::string folder) : folder_(std::move(folder)) {}

  void topic(const std::string& name, const std::string& what);
  void heading(const std::string& text);
  // |got − expected| <= tolerance.
  void near(const std::string& item, double expected, double got, double tolerance);
  // |got − expected| <= tolerance |expected|; the error is printed relative.
  void close(const std::string& item, double expected, double got, double tolerance);
  void at_most(const std::string& item, double bound, double got);
  void at_least(const std::string& item, double bound, double got);
  void is_true(const std::string& item, bool ok, const std::string& expected, const std::string& got);
  // Told, not judged.
  void note(const std::string& item, const std::string& text);
  void note(const std::string& item, double got);

  int failed() const { return failed_; }
  int passed() const { return passed_; }

  // Curves: NAME.csv in the folder of --out, nothing without one.
  bool draws() const { return !folder_.empty(); }
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  void csv(const std::string& name, const std::string& header, const std::vector<std::vector<double>>& rows) const;
  // NAME.png by these commands of gnuplot, where it is installed. `$f(x)` style names of CSV files are relative to the
  // folder.
  void figure(const std::string& name, const std::string& commands) const;

 private:
  void row(const std::string& item, const std::string& expected, const std::string& got, const std::string& error,
           bool ok);

  std::string folder_;
  int failed_ = 0, passed_ = 0;
};

using Topic = void (*)(Report&);

void closed_forms(Report&);
void restitution(Report&);
void tangential(Report&);
void adhesion(Report&);
void plastic(Report&);
void chung_ooi(Report&);
void thornton(Report&);
void kharaz(Report&);
void bodies(Report&);
void stability(Report&);
void assemblies(Report&);
void energy(Report&);
void loops(Report&);
void shape_loops(Report&);
void cost(Report&);

}  // namespace laws
