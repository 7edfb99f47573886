// Positions in a scene file, and the exception of bad input.
#pragma once

#include <stdexcept>
#include <string>

namespace dem {

// Where a value stands in its file: errors found after parsing (an initial overlap, a bad mesh) still name the line.
struct Where {
  std::string file;
  int line = 0, column = 0;
};

// Bad input of any kind; the message is complete: what, value, allowed range, file:line:column.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
[[noreturn]] void input_error(const Where& where, const std::string& message);

}  // namespace dem
