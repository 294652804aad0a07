#include "render/shader_complaint.h"

#include <charconv>

namespace texbrdf::render {

namespace {

std::optional<uint32_t> take_number(std::string_view& text) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

bool take(std::string_view& text, char wanted) {
  if (!text.starts_with(wanted)) return false;
  text.remove_prefix(1);
  return true;
}

/// `1:12: …` of glslang, `1:12(5): error: …` of Mesa, or `1(12) : error …` of others.
std::optional<ShaderComplaint> read_complaint(std::string_view text) {
  const auto source = take_number(text);
  if (!source) return std::nullopt;
  const bool in_brackets = take(text, '(');
  if (!in_brackets && !take(text, ':')) return std::nullopt;
  const auto line = take_number(text);
  if (!line || (in_brackets && !take(text, ')'))) return std::nullopt;
  if (take(text, '(') && (!take_number(text) || !take(text, ')'))) return std::nullopt;
  while (take(text, ' ') || take(text, ':')) {
  }
  return ShaderComplaint{*source, *line, std::string(text)};
}

}  // namespace

std::optional<ShaderComplaint> find_complaint(std::string_view message) {
  constexpr std::string_view kBefore = "rejects the shader: ";
  const std::size_t at = message.find(kBefore);
  return read_complaint(at == std::string_view::npos ? message : message.substr(at + kBefore.size()));
}

}  // namespace texbrdf::render
