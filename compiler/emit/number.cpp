#include "emit/number.h"

#include <array>
#include <charconv>
#include <cmath>

namespace texbrdf::emit {
namespace {

/// Numbers with more digits than this before the dot, or zeros behind it, are written with an exponent.
constexpr int kMostWholeDigits = 9;
constexpr int kMostLeadingZeros = 4;

std::string to_text(float number, std::chars_format format) {
  std::array<char, 128> buffer;
  auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, format);
  return std::string(buffer.data(), end);
}

}  // namespace

std::string plain_number(double number) {
  float single = static_cast<float>(number);
  std::string scientific = to_text(single, std::chars_format::scientific);
  std::size_t e = scientific.find('e');
  int exponent = 0;
  std::size_t digits = scientific[e + 1] == '+' ? e + 2 : e + 1;
  std::from_chars(scientific.data() + digits, scientific.data() + scientific.size(), exponent);
  if (exponent >= -kMostLeadingZeros - 1 && exponent < kMostWholeDigits)
    return to_text(single, std::chars_format::fixed);
  return scientific.substr(0, e) + "e" + std::to_string(exponent);
}

std::string float_literal(double number) {
  std::string text = plain_number(number);
  if (text.find('.') != std::string::npos) return text;
  std::size_t e = text.find('e');
  return e == std::string::npos ? text + ".0" : text.substr(0, e) + ".0" + text.substr(e);
}

}  // namespace texbrdf::emit
