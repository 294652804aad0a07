#include "emit/comment.h"

#include <algorithm>

namespace texbrdf::emit {
namespace {

constexpr std::size_t kLineWidth = 99;

/// On one line, with single spaces, and a question mark for each code point outside ASCII.
std::string ascii(std::string_view text) {
  std::string out;
  for (char c : text) {
    unsigned char byte = static_cast<unsigned char>(c);
    bool continuation_byte = (byte & 0xC0u) == 0x80u;
    if (byte > 0x20 && byte < 0x7F) {
      out += c;
    } else if (byte <= 0x20 || byte == 0x7F) {
      if (!out.ends_with(' ')) out += ' ';
    } else if (!continuation_byte) {
      out += '?';
    }
  }
  return out;
}

/// How much of `rest` goes on a line of `room` characters: up to a space outside of as many braces and parentheses as
/// may be, but not so early that the line looks empty.
std::size_t line_length(std::string_view rest, std::size_t room) {
  if (rest.size() <= room) return rest.size();
  std::size_t best = 0;
  int depth = 0;
  int best_depth = 0;
  for (std::size_t i = 0; i <= room; ++i) {
    if (rest[i] == '{' || rest[i] == '(') ++depth;
    if (rest[i] == '}' || rest[i] == ')') --depth;
    bool early = best < room / 2;
    if (rest[i] == ' ' && (early || depth <= best_depth)) {
      best = i;
      best_depth = depth;
    }
  }
  std::size_t length = best > 0 ? best : room;
  while (length > 1 && rest[length - 1] == '\\') --length;
  return length;
}

}  // namespace

std::string equation_comment(std::string_view equation, uint32_t indent) {
  std::string text = ascii(equation);
  std::string_view rest = text;
  std::string out;
  std::string start = std::string(indent, ' ') + "// ";
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    if (rest.empty()) return out;
    std::size_t length = line_length(rest, kLineWidth - start.size());
    std::string_view line = rest.substr(0, length);
    rest.remove_prefix(length);
    line = line.substr(0, line.find_last_not_of(' ') + 1);
    out += start;
    out += line;
    if (line.ends_with('\\')) out += " .";
    out += '\n';
    start = std::string(indent, ' ') + "//     ";
  }
}

}  // namespace texbrdf::emit
