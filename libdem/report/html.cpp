#include "libdem/report/html.h"

namespace dem::report {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

std::string table_of(const std::vector<std::vector<std::string>>& rows, bool numbers) {
  std::string out = numbers ? "<table class=\"numbers\">\n" : "<table>\n";
  for (const auto& row : rows) {
    const char* cell = &row == rows.data() ? "th" : "td";
    out += "<tr>";
    for (const std::string& text : row) {
      out += '<';
      out += cell;
      out += '>' + escaped(text) + "</";
      out += cell;
      out += '>';
    }
    out += "</tr>\n";
  }
  return out + "</table>\n";
}

std::string folded(const std::string& title, const std::string& body, bool open) {
  return std::string("<details") + (open ? " open" : "") + "><summary>" + escaped(title) + "</summary>\n" + body +
         "</details>\n";
}

}  // namespace dem::report
