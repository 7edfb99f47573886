// Force laws at their extremes: cases that any law must answer rightly, or stop at with a message, from closed forms
// that do not depend on the law. Every law of libcontact/laws/list.h goes through all of them.
#pragma once

#include <string>
#include <vector>

#include "libdem/validate/validation.h"

namespace dem::validate {

struct LawExtreme {
  const char* name;
  std::vector<Row> (*check)(const std::string& law);
};

const std::vector<LawExtreme>& law_extremes();
std::vector<std::string> law_names();  // of the list

}  // namespace dem::validate
