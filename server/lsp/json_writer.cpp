#include "lsp/json_writer.h"

#include <utf8.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace texbrdf::lsp {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

bool plain(char c) {
  return static_cast<unsigned char>(c) >= 0x20 && c != '"' && c != '\\';
}

bool plain_ascii(char c) {
  return plain(c) && static_cast<unsigned char>(c) < 0x80;
}

void append_escape(std::string& out, char c) {
  switch (c) {
    case '"':
      out += "\\\"";
      return;
    case '\\':
      out += "\\\\";
      return;
    case '\n':
      out += "\\n";
      return;
    case '\r':
      out += "\\r";
      return;
    case '\t':
      out += "\\t";
      return;
    default:
      break;  // the rest by number
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  out += "\\u00";
  out += kDigits[byte >> 4];
  out += kDigits[byte & 15];
}

void append_escaped(std::string& out, std::string_view text) {
  while (!text.empty()) {
    const auto end = std::find_if_not(text.begin(), text.end(), plain);
    const auto run = static_cast<std::size_t>(end - text.begin());
    out += text.substr(0, run);
    if (run == text.size()) return;
    append_escape(out, text[run]);
    text.remove_prefix(run + 1);
  }
}

template <typename Number>
void append_number(std::string& out, Number number) {
  std::array<char, 32> digits;
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  out.append(digits.data(), result.ptr);
}

}  // namespace

void JsonWriter::separate() {
  if (comma_) text_ += ',';
  comma_ = true;
}

void JsonWriter::open(char bracket) {
  separate();
  text_ += bracket;
  comma_ = false;
}

void JsonWriter::close(char bracket) {
  text_ += bracket;
  comma_ = true;
}

void JsonWriter::key(std::string_view name) {
  text_ += comma_ ? ",\"" : "\"";
  text_ += name;
  text_ += "\":";
  comma_ = false;
}

void JsonWriter::text_key(std::string_view name) {
  separate();
  quoted(name);
  text_ += ':';
  comma_ = false;
}

void JsonWriter::value(std::string_view text) {
  separate();
  quoted(text);
}

void JsonWriter::value(double number) {
  if (!std::isfinite(number)) return null();
  separate();
  append_number(text_, number);
}

void JsonWriter::raw(std::string_view json) {
  separate();
  text_ += json;
}

void JsonWriter::integer(int64_t number) {
  separate();
  append_number(text_, number);
}

void JsonWriter::natural(uint64_t number) {
  separate();
  append_number(text_, number);
}

void JsonWriter::quoted(std::string_view text) {
  text_ += '"';
  const auto ascii = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), plain_ascii) - text.begin());
  text_ += text.substr(0, ascii);
  text.remove_prefix(ascii);
  while (!text.empty()) {
    const auto valid = static_cast<std::size_t>(utf8::find_invalid(text.begin(), text.end()) - text.begin());
    append_escaped(text_, text.substr(0, valid));
    text.remove_prefix(valid);
    if (text.empty()) break;
    text_ += kReplacement;
    text.remove_prefix(1);
  }
  text_ += '"';
}

}  // namespace texbrdf::lsp
