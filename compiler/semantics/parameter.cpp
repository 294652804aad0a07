#include "semantics/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "source/characters.h"
#include "source/trimmed.h"

namespace texbrdf {
namespace {

// Without the percent signs.
std::string_view comment_text(const ParsedBlock& block, Span comment) {
  std::string_view text = block.slice(comment);
  while (text.starts_with('%')) text.remove_prefix(1);
  return trimmed(text);
}

// Takes a number with its sign off the front.
std::optional<double> take_number(std::string_view& text) {
  text = trimmed(text);
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  if (digits.starts_with('-') && digits.size() != text.size()) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text = digits.substr(static_cast<size_t>(end - digits.data()));
  return value;
}

bool take(std::string_view& text, char expected) {
  text = trimmed(text);
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(1);
  return true;
}

struct Range {
  double minimum, maximum;
};

// "[a, b]" and whatever else the comment says.
std::optional<Range> read_range(std::string_view text) {
  if (!take(text, '[')) return std::nullopt;
  const std::optional<double> minimum = take_number(text);
  if (!minimum || !take(text, ',')) return std::nullopt;
  const std::optional<double> maximum = take_number(text);
  if (!maximum || !take(text, ']') || !(*minimum < *maximum)) return std::nullopt;
  return Range{*minimum, *maximum};
}

// What stands behind `range` where the comment is meant for us and is no prose ("range of the lobe").
std::optional<std::string_view> range_words(std::string_view comment) {
  constexpr std::string_view kWord = "range";
  if (!comment.starts_with(kWord)) return std::nullopt;
  const std::string_view rest = trimmed(comment.substr(kWord.size()));
  if (rest.empty()) return std::nullopt;
  const char first = rest.front();
  const bool is_meant = first == '[' || first == '(' || first == '-' || first == '+' || first == '.' || is_digit(first);
  return is_meant ? std::optional(rest) : std::nullopt;
}

std::string number_text(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return error == std::errc{} ? std::string(buffer, end) : std::string("?");
}

// [0, 1] for what lies in it, else [0, 10], [0, 100] …; on both sides of zero for a negative value.
Range default_range(double value) {
  double maximum = 1;
  while (maximum < std::abs(value)) maximum *= 10;
  return {value < 0 ? -maximum : 0, maximum};
}

class LiteralReader {
 public:
  LiteralReader(const ParsedBlock& block, const DefinitionSyntax& definition)
      : block_(block), definition_(definition) {}

  std::optional<ParameterLiteral> read() const {
    if (block_.tree.node(definition_.left).kind != NodeKind::Name) return std::nullopt;
    ParameterLiteral literal;
    literal.literal = definition_.body;
    const Node& body = block_.tree.node(definition_.body);
    if (body.kind == NodeKind::VectorLiteral || body.kind == NodeKind::Tuple) return read_colour(literal);
    const std::optional<double> value = read_number(definition_.body);
    if (!value) return std::nullopt;
    literal.value = {*value, 0, 0};
    return literal;
  }

 private:
  std::optional<ParameterLiteral> read_colour(ParameterLiteral literal) const {
    const std::span<const NodeId> elements = block_.tree.children(definition_.body);
    if (elements.size() != literal.value.size()) return std::nullopt;
    literal.type = Type::Colour;
    for (size_t i = 0; i < elements.size(); ++i) {
      const std::optional<double> value = read_number(elements[i]);
      if (!value || *value < 0 || *value > 1) return std::nullopt;
      literal.value[i] = *value;
    }
    return literal;
  }

  std::optional<double> read_number(NodeId id) const {
    double sign = 1;
    while (block_.tree.node(id).kind == NodeKind::Prefix) {
      if (block_.tokens[block_.tree.node(id).token].kind == TokenKind::Minus) sign = -sign;
      id = block_.tree.child(id, 0);
    }
    if (block_.tree.node(id).kind != NodeKind::Number) return std::nullopt;
    std::string_view text = block_.node_text(id);
    const std::optional<double> value = take_number(text);
    if (!value) return std::nullopt;
    return sign * *value;
  }

  const ParsedBlock& block_;
  const DefinitionSyntax& definition_;
};

bool is_constant(const ParsedBlock& block, const DefinitionSyntax& definition) {
  return std::ranges::any_of(block.comments_of(definition),
                             [&](Span comment) { return comment_text(block, comment) == "constant"; });
}

size_t component_count(const ParameterLiteral& literal) {
  return literal.type == Type::Real ? 1 : literal.value.size();
}

// The first component that the range leaves out.
std::optional<double> value_outside(const ParameterLiteral& literal, Range range) {
  for (size_t i = 0; i < component_count(literal); ++i) {
    const double value = literal.value[i];
    if (value < range.minimum || value > range.maximum) return value;
  }
  return std::nullopt;
}

std::optional<Range> written_range(const ParsedBlock& block, const DefinitionSyntax& definition,
                                   const ParameterLiteral& literal, std::vector<Diagnostic>& diagnostics) {
  for (Span comment : block.comments_of(definition)) {
    const std::optional<std::string_view> words = range_words(comment_text(block, comment));
    if (!words) continue;
    const Location where{.file = {}, .block = {}, .span = comment};
    const std::optional<Range> range = read_range(*words);
    if (!range) {
      diagnostics.push_back(make_diagnostic(Code::RangeMalformed, where));
    } else if (const std::optional<double> outside = value_outside(literal, *range)) {
      diagnostics.push_back(
          make_diagnostic(Code::RangeWithoutValue, where,
                          {number_text(range->minimum), number_text(range->maximum), number_text(*outside)}));
    } else {
      return range;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<ParameterLiteral> parameter_literal(const ParsedBlock& block, const DefinitionSyntax& definition,
                                                  std::vector<Diagnostic>& diagnostics) {
  std::optional<ParameterLiteral> literal = LiteralReader(block, definition).read();
  if (!literal || is_constant(block, definition)) return std::nullopt;
  const std::optional<Range> written = written_range(block, definition, *literal, diagnostics);
  const Range range = written ? *written : literal->type == Type::Real ? default_range(literal->value[0]) : Range{0, 1};
  literal->minimum = range.minimum;
  literal->maximum = range.maximum;
  return literal;
}

}  // namespace texbrdf
