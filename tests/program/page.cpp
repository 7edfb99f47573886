#include "tests/program/page.h"

#include <set>
#include <vector>

namespace program {

std::string body_attribute(const std::string& page, const std::string& name) {
  const std::size_t body = page.find("<body"), end = page.find('>', body), at = page.find(" " + name + "=\"", body);
  if (body == std::string::npos || at == std::string::npos || at > end) return "";
  const std::size_t begin = at + name.size() + 3;
  return page.substr(begin, page.find('"', begin) - begin);
}

std::string without_libraries(const std::string& page) {
  std::string text = page;
  const std::string open = "<script class=\"library\">";
  for (std::size_t at = 0; (at = text.find(open, at)) != std::string::npos; at += open.size())
    text.erase(at + open.size(), text.find("</script>", at) - at - open.size());
  return text;
}

std::string fault_of_markup(const std::string& page) {
  static const std::set<std::string> empty{"meta", "input", "img", "br"}, raw{"script", "style"};
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = page.find('<', at)) != std::string::npos;) {
    if (page.compare(at, 2, "<!") == 0) {
      at = page.find('>', at);
      continue;
    }
    // To the end of the tag; quotes may hold anything.
    std::size_t end = at + 1;
    for (char quote = 0; end < page.size() && (quote != 0 || page[end] != '>'); ++end)
      if (quote != 0)
        quote = page[end] == quote ? '\0' : quote;
      else if (page[end] == '"' || page[end] == '\'')
        quote = page[end];
    if (end >= page.size()) return "a tag does not end: " + page.substr(at, 60);
    const bool closes = page[at + 1] == '/', itself = page[end - 1] == '/';
    const std::size_t begin = at + (closes ? 2 : 1);
    const std::string name = page.substr(begin, page.find_first_of(" \t\n/>", begin) - begin);
    if (closes) {
      if (open.empty() || open.back() != name)
        return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    } else if (!itself && empty.count(name) == 0) {
      open.push_back(name);
    }
    at = end + 1;
    if (!closes && raw.count(name) > 0) at = page.find("</" + name + ">", at);
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

}  // namespace program
