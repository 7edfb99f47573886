// What tests ask of a page of dem report.
#pragma once

#include <string>

namespace program {

// Text of an attribute of <body>; empty: none.
std::string body_attribute(const std::string& page, const std::string& name);
// The page without the text of its scripts that are other people's.
std::string without_libraries(const std::string& page);
// Empty where every element that is opened is closed, in order, and attributes are quoted; else what is wrong first.
std::string fault_of_markup(const std::string& page);
std::size_t occurrences(const std::string& text, const std::string& part);

}  // namespace program
