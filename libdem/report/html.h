// Pieces of a page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dem::report {

std::string escaped(std::string_view text);
// Rows of cells, which are escaped here; the first row is the head. Cells after the first are numbers: to the right.
std::string table_of(const std::vector<std::vector<std::string>>& rows, bool numbers = true);
// Closed until it is clicked, unless `open`.
std::string folded(const std::string& title, const std::string& body, bool open = false);

}  // namespace dem::report
