#include "features/model_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "semantics/parameter.h"

namespace texbrdf::features {
namespace {

/// The digits that a number can usefully have, as a `double` has them.
constexpr int kMaxDecimals = 15;
constexpr double kStepsOfRange = 1000;
constexpr int kColourDecimals = 3;

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

int decimals_of(std::string_view number) {
  const size_t point = number.find('.');
  if (point == std::string_view::npos) return 0;
  const size_t end = number.find_first_not_of("0123456789", point + 1);
  return static_cast<int>(std::min(end, number.size()) - point - 1);
}

/// With zeros left out at the end, but for `least` decimals.
std::string without_zeros(std::string number, int least) {
  const size_t point = number.find('.');
  if (point == std::string::npos) return number;
  const size_t shortest = least == 0 ? point : point + 1 + static_cast<size_t>(least);
  const size_t last = std::max(number.find_last_not_of('0') + 1, shortest);
  number.resize(last);
  if (number.back() == '.') number.pop_back();
  return number;
}

/// A number in the place of `before`: with an exponent where that has one, else with as many decimals as needed.
std::string number_like(std::string_view before, double value, int decimals) {
  const size_t exponent = before.find_first_of("eE");
  if (exponent != std::string_view::npos) {
    const int digits = std::max(2, decimals_of(before.substr(0, exponent)));
    const std::string text = fmt::format("{:.{}e}", value, digits);
    const size_t mark = text.find('e');
    return fmt::format("{}e{}", without_zeros(text.substr(0, mark), 0), std::stoi(text.substr(mark + 1)));
  }
  const int own = decimals_of(before);
  std::string text = without_zeros(fmt::format("{:.{}f}", value, std::max(decimals, own)), own);
  if (before.starts_with('.') && text.starts_with("0.")) text.erase(0, 1);
  return text == "-0" ? "0" : text;
}

int decimals_for(double low, double high) {
  const double step = (high - low) / kStepsOfRange;
  if (!(step > 0) || !std::isfinite(step)) return 3;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, kMaxDecimals);
}

TextEdit replace(const Snapshot& snapshot, BlockId block, NodeId node, double value, int decimals) {
  const ParsedBlock& parsed = snapshot.parsed(block);
  return {snapshot.absolute(block, parsed.span(node)), number_like(parsed.node_text(node), value, decimals)};
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
  const ParameterLiteral& literal = place->literal;
  if (literal.type == Type::Real) {
    const int decimals = decimals_for(literal.minimum, literal.maximum);
    return std::vector{replace(snapshot, place->block, literal.literal, value[0], decimals)};
  }
  std::vector<TextEdit> edits;
  const std::span<const NodeId> components = snapshot.parsed(place->block).tree.children(literal.literal);
  for (size_t i = 0; i < value.size(); ++i) {
    if (value[i] == literal.value[i]) continue;
    edits.push_back(replace(snapshot, place->block, components[i], value[i], kColourDecimals));
  }
  return edits;
}

}  // namespace texbrdf::features
