// Other programs that may be there: what uses one says so and goes on without it.
#pragma once

#include <string>

namespace dem::io {

// Whether a folder of PATH holds it.
bool installed(const std::string& program);
// Runs gnuplot on these commands; RunError when it fails.
void run_gnuplot(const std::string& commands);
// Runs `program` on a file of `folder`, from there; what it says, and whether it succeeded.
struct Said {
  bool succeeded = false;
  std::string text;
};
Said run_in(const std::string& folder, const std::string& program, const std::string& file);
// Text as one word of a shell.
std::string shell_quoted(const std::string& text);
// Text as gnuplot takes it literally.
std::string gnuplot_quoted(const std::string& text);

}  // namespace dem::io
