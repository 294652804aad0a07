#include "features/signature_help.h"

#include <fmt/format.h>

#include <algorithm>

#include "features/caret.h"
#include "features/demand.h"
#include "features/places.h"

namespace texbrdf::features {
namespace {

using Role = OpenBracket::Role;

/// Writes a label piece by piece and notes where the parameters stand.
class Label {
 public:
  void text(std::string_view text) { help_.label += text; }
  void parameter(std::string_view text) {
    if (!help_.parameters.empty()) help_.label += ", ";
    const auto begin = static_cast<uint32_t>(help_.label.size());
    help_.label += text;
    help_.parameters.push_back({begin, static_cast<uint32_t>(help_.label.size())});
  }
  SignatureHelp take() { return std::move(help_); }

 private:
  SignatureHelp help_;
};

SignatureHelp help_of_function(const Snapshot& snapshot, DefinitionId id, Markup markup) {
  const Definition& function = snapshot.definition(id);
  Label label;
  label.text(snapshot.names().text(function.name));
  label.text("(");
  for (const CheckedParameter& parameter : function.checked->parameters) {
    const std::string name = parameter_text(snapshot, function.block, parameter);
    label.parameter(fmt::format("{}: {}", name, type_symbol(parameter.type)));
  }
  label.text(fmt::format("): {}", type_symbol(function.checked->signature.result)));
  SignatureHelp help = label.take();
  help.documentation = describe_definition(snapshot, id, markup);
  return help;
}

SignatureHelp help_of_builtin(std::string_view name, Builtin function, Markup markup) {
  const Signature& signature = builtin_entry(function).signature;
  Label label;
  label.text(name == kStepFunction ? "\\chi^+" : name);
  label.text("(");
  for (const Type type : signature.parameters) label.parameter(type_symbol(type));
  label.text(fmt::format("): {}", type_symbol(signature.result)));
  SignatureHelp help = label.take();
  help.documentation = describe_builtin(name, function, markup);
  return help;
}

/// \max and \min take any number of reals.
SignatureHelp help_of_extremum(std::string_view command, uint32_t commas) {
  Label label;
  label.text(command);
  label.text("(");
  for (uint32_t i = 0; i < std::clamp<uint32_t>(commas + 1, 2, 16); ++i) {
    label.parameter(fmt::format("x_{}: ℝ", i + 1));
  }
  label.text(", …): ℝ");
  return label.take();
}

std::optional<SignatureHelp> help_in(const Snapshot& snapshot, BlockId block, const OpenBracket& bracket,
                                     Markup markup) {
  std::optional<SignatureHelp> help;
  if (bracket.role == Role::Extremum) {
    help = help_of_extremum(snapshot.parsed(block).token_text(bracket.first_token), bracket.commas);
  } else if (const auto function = callee(snapshot, block, bracket)) {
    const Definition& definition = snapshot.definition(*function);
    if (definition.checked->signature.is_function) help = help_of_function(snapshot, *function, markup);
  } else {
    const std::string name = called_name(snapshot, block, bracket);
    if (const auto builtin = find_builtin(name)) help = help_of_builtin(name, *builtin, markup);
  }
  if (help) help->active = std::min(bracket.commas, static_cast<uint32_t>(help->parameters.size()));
  return help;
}

}  // namespace

std::optional<SignatureHelp> signature_help(const Snapshot& snapshot, uint32_t offset, Markup markup) {
  const auto place = math_place(snapshot, offset);
  if (!place) return std::nullopt;
  const ParsedBlock& parsed = snapshot.parsed(place->block);
  const std::vector<OpenBracket> brackets = open_brackets(parsed, place->token);
  const bool is_left_side = std::ranges::none_of(std::span(parsed.tokens).first(place->token),
                                                 [](const Token& token) { return token.kind == TokenKind::Equals; });
  if (is_left_side) return std::nullopt;
  for (auto bracket = brackets.rbegin(); bracket != brackets.rend(); ++bracket) {
    if (auto help = help_in(snapshot, place->block, *bracket, markup)) return help;
  }
  return std::nullopt;
}

}  // namespace texbrdf::features
