#include "syntax/xml_text.h"

#include "source/utf8.h"

namespace texbrdf {

std::string xml_text(std::string_view text) {
  const std::string shown = printable(text);
  std::string escaped;
  escaped.reserve(shown.size());
  for (std::string_view rest = shown; !rest.empty();) {
    const std::string_view code_point = rest.substr(0, code_point_at_front(rest).size);
    if (code_point == "&") {
      escaped += "&amp;";
    } else if (code_point == "<") {
      escaped += "&lt;";
    } else if (code_point == ">") {
      escaped += "&gt;";
    } else if (code_point == "\"") {
      escaped += "&quot;";
    } else if (code_point == "\xEF\xBF\xBE" || code_point == "\xEF\xBF\xBF") {  // U+FFFE, U+FFFF
      escaped += "\uFFFD";
    } else {
      escaped += code_point;
    }
    rest.remove_prefix(code_point.size());
  }
  return escaped;
}

}  // namespace texbrdf
