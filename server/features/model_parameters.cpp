#include "features/model_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "semantics/parameter.h"
#include "source/internal_error.h"

namespace texbrdf::features {
namespace {

/// The digits that a number can usefully have, as a `double` has them.
constexpr int kMaxDecimals = 15;
constexpr double kStepsOfRange = 1000;
constexpr int kColourDecimals = 3;
/// What a pane shows of a number, and what people type.
constexpr int kMeantDigits = 6;
constexpr int kDigitsBehindPoint = 2;

struct LiteralPlace {
  BlockId block;
  ParameterLiteral literal;
};

std::optional<LiteralPlace> find_literal(const Snapshot& snapshot, std::string_view name) {
  const std::optional<DefinitionId> id = snapshot.find(name);
  if (!id) return std::nullopt;
  const Definition definition = snapshot.definition(*id);
  std::vector<Diagnostic> reported_already;
  const auto literal = parameter_literal(snapshot.parsed(definition.block), snapshot.syntax(*id), reported_already);
  return literal ? std::optional(LiteralPlace{definition.block, *literal}) : std::nullopt;
}

/// The shortest decimal that reads as the value, as d.ddd and a power of ten.
struct Decimal {
  explicit Decimal(double value) {
    std::array<char, 32> text{};
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific);
    require(error == std::errc{}, "a number too long to be written");
    const std::string_view written(text.data(), end);
    const size_t mark = written.find('e');
    mantissa = written.substr(0, mark);
    exponent = std::stoi(std::string(written.substr(mark + 1)));
  }
  int digits() const {
    return static_cast<int>(std::ranges::count_if(mantissa, [](char c) { return c >= '0'; }));
  }

  std::string mantissa;
  int exponent = 0;
};

/// A number of more digits is what arithmetic left; nobody meant them all.
double as_meant(double value, bool has_exponent, int decimals) {
  if (Decimal(value).digits() <= kMeantDigits) return value;
  const std::string text =
      has_exponent ? fmt::format("{:.{}e}", value, kDigitsBehindPoint) : fmt::format("{:.{}f}", value, decimals);
  return std::strtod(text.c_str(), nullptr);
}

std::string plain(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr};
}

/// A number in the place of `before`: with an exponent or a leading point where that has one, with no digit more than
/// it needs.
std::string number_like(std::string_view before, double value, int decimals) {
  const bool has_exponent = before.find_first_of("eE") != std::string_view::npos;
  const double meant = as_meant(value, has_exponent, decimals) + 0.0;  // no negative zero
  const Decimal decimal(meant);
  if (has_exponent || std::abs(decimal.exponent) > kMaxDecimals) {
    return fmt::format("{}e{}", decimal.mantissa, decimal.exponent);
  }
  std::string text = plain(meant);
  if (before.starts_with('.') && text.starts_with("0.")) text.erase(0, 1);
  return text;
}

int decimals_for(double low, double high) {
  const double step = (high - low) / kStepsOfRange;
  if (!(step > 0) || !std::isfinite(step)) return 3;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, kMaxDecimals);
}

/// Where the digits of a literal stand, made of the expanded text of its block: in the block itself, or in the body of
/// the macro that is nothing but the literal and stands for it alone.
class LiteralText {
 public:
  static std::optional<LiteralText> find(const Snapshot& snapshot, BlockId block, Span literal) {
    const ParsedBlock& parsed = snapshot.parsed(block);
    if (parsed.is_replaceable(literal)) return LiteralText(snapshot, block, std::nullopt);
    const MacroUse* const use = parsed.expansion ? parsed.expansion->maker_of(literal) : nullptr;
    if (use == nullptr) return std::nullopt;
    const uint32_t offset = snapshot.absolute(block, literal).begin;
    const std::optional<MacroOccurrence> macro = snapshot.macro_at(offset);
    const bool stands_once = macro && macro->name == use->name && snapshot.places_of_macro(macro->name).size() == 2;
    if (!stands_once) return std::nullopt;
    const std::string body = fmt::format("{{{}}}", parsed.slice(literal));
    const FilePlace definition = snapshot.place(macro->definition);
    const bool is_nothing_else = snapshot.text(definition.file).slice(definition.span).ends_with(body);
    if (!is_nothing_else) return std::nullopt;
    const auto size = static_cast<uint32_t>(body.size());
    return LiteralText(snapshot, block, macro->definition.end - size + 1 - literal.begin);
  }

  Span place(Span in_block) const {
    if (!from_block_) return snapshot_.absolute(block_, in_block);
    return {in_block.begin + *from_block_, in_block.end + *from_block_};
  }

 private:
  LiteralText(const Snapshot& snapshot, BlockId block, std::optional<uint32_t> from_block)
      : snapshot_(snapshot), block_(block), from_block_(from_block) {}

  const Snapshot& snapshot_;
  BlockId block_;
  std::optional<uint32_t> from_block_;  ///< of a body: what is added to places of the block, modulo 2³²
};

TextEdit replace(const ParsedBlock& parsed, const LiteralText& text, NodeId node, double value, int decimals) {
  return {text.place(parsed.span(node)), number_like(parsed.node_text(node), value, decimals)};
}

}  // namespace

std::vector<ModelParameter> model_parameters(const Snapshot& snapshot, std::string_view root) {
  std::vector<ModelParameter> parameters;
  const Result<ir::Program> program = snapshot.program(root);
  if (!program) return parameters;
  for (const ir::Parameter& linked : program->parameters) {
    const std::optional<LiteralPlace> place = find_literal(snapshot, linked.canonical);
    if (!place) continue;
    const DefinitionSyntax& syntax = snapshot.syntax(*snapshot.find(linked.canonical));
    const ParsedBlock& parsed = snapshot.parsed(place->block);
    parameters.push_back({.name = linked.canonical,
                          .spelling = std::string(parsed.node_text(syntax.name)),
                          .type = linked.type,
                          .value = linked.value,
                          .low = linked.minimum,
                          .high = linked.maximum,
                          .literal = snapshot.absolute(place->block, parsed.span(place->literal.literal))});
  }
  return parameters;
}

std::vector<std::string> brdf_names(const Snapshot& snapshot) {
  std::vector<std::string> names;
  const std::string root = snapshot.root_name();
  for (const Definition& definition : snapshot.all_definitions()) {
    const std::string_view name = snapshot.names().text(definition.name);
    const bool may_be_brdf = snapshot.names().traits(definition.name).may_be_brdf || name == root;
    if (definition.in_force && may_be_brdf) names.emplace_back(name);
  }
  return names;
}

std::optional<std::vector<TextEdit>> parameter_edit(const Snapshot& snapshot, std::string_view name,
                                                    std::span<const double> value) {
  const std::optional<LiteralPlace> place = find_literal(snapshot, name);
  if (!place || value.size() != type_components(place->literal.type)) return std::nullopt;
  if (!std::ranges::all_of(value, [](double x) { return std::isfinite(x); })) return std::nullopt;
  const ParsedBlock& parsed = snapshot.parsed(place->block);
  const ParameterLiteral& literal = place->literal;
  const auto text = LiteralText::find(snapshot, place->block, parsed.span(literal.literal));
  if (!text) return std::nullopt;
  if (literal.type == Type::Real) {
    const int decimals = decimals_for(literal.minimum, literal.maximum);
    return std::vector{replace(parsed, *text, literal.literal, value[0], decimals)};
  }
  std::vector<TextEdit> edits;
  const std::span<const NodeId> components = snapshot.parsed(place->block).tree.children(literal.literal);
  for (size_t i = 0; i < value.size(); ++i) {
    if (value[i] == literal.value[i]) continue;
    edits.push_back(replace(parsed, *text, components[i], value[i], kColourDecimals));
  }
  return edits;
}

}  // namespace texbrdf::features
