// summary.json of a run as tables.
#pragma once

#include <string>

namespace dem::report {

// Empty text where the file is missing or damaged.
std::string counters_html(const std::string& summary_file);

}  // namespace dem::report
