// Other programs that may be there: what uses one says so and goes on without it.
#pragma once

#include <string>

namespace dem::io {

// Whether a folder of PATH holds it.
bool installed(const std::string& program);
// Runs gnuplot on these commands; RunError when it fails.
void run_gnuplot(const std::string& commands);
// Text as gnuplot takes it literally.
std::string gnuplot_quoted(const std::string& text);

}  // namespace dem::io
