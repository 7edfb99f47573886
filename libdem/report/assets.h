// The files page.css and view.js of this folder, as they were when the program was built.
#pragma once

#include <string_view>

namespace dem::report {

extern const std::string_view page_css;
extern const std::string_view view_js;

}  // namespace dem::report
