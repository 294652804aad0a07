#include "semantics/factors.h"

#include <algorithm>

#include "semantics/implied_angle.h"
#include "syntax/brackets.h"

namespace texbrdf {
namespace {

/// By token: of a `(`, the commas between it and its `)`, outside of inner brackets.
std::vector<uint32_t> count_commas(std::span<const Token> tokens) {
  std::vector<uint32_t> commas(tokens.size());
  std::vector<uint32_t> open;
  for (uint32_t i = 0; i < tokens.size(); ++i) {
    if (is_opener(tokens[i].kind)) {
      open.push_back(i);
    } else if (is_closer(tokens[i].kind)) {
      if (!open.empty()) open.pop_back();
    } else if (tokens[i].kind == TokenKind::Comma && !open.empty()) {
      ++commas[open.back()];
    }
  }
  return commas;
}

class FactorSearch {
 public:
  FactorSearch(const ParsedBlock& block, const BlockNames& names, const NameTable& table,
               const std::function<NameKind(NameId)>& kind_of)
      : block_(block), names_(names), table_(table), kind_of_(kind_of) {}

  std::vector<uint32_t> run() {
    for (const DefinitionSyntax& definition : block_.definitions) {
      for (uint32_t node = definition.left.value + 1; node < definition.body.value + 1; ++node) {
        const NameId name = names_.by_node[node];
        if (name.valid()) read(definition, NodeId{node}, name);
      }
    }
    std::ranges::sort(found_);
    return std::move(found_);
  }

 private:
  void read(const DefinitionSyntax& definition, NodeId node, NameId name) {
    const uint32_t bracket = block_.tree.node(node).end_token;
    if (block_.tokens[bracket].kind != TokenKind::OpenParen) return;
    const bool is_factor = is_power_of_function(node) || (is_value(definition, name) && !is_list(bracket));
    if (is_factor) found_.push_back(bracket);
  }

  /// `\cos^n(x)`: what follows belongs to the function.
  bool is_power_of_function(NodeId node) const {
    const uint32_t caret = token_before(block_.tree.node(node).first_token);
    return block_.tokens[caret].kind == TokenKind::Caret &&
           block_.tokens[token_before(caret)].kind == TokenKind::Function;
  }

  /// Without `&`, which the parser does not see either.
  uint32_t token_before(uint32_t token) const {
    while (token > 0) {
      --token;
      if (!is_layout(block_.tokens[token].kind)) break;
    }
    return token;
  }

  bool is_value(const DefinitionSyntax& definition, NameId name) const {
    if (is_parameter(definition, name)) return true;
    const NameKind kind = kind_of_(name);
    if (kind != NameKind::Absent) return kind == NameKind::Value;
    return table_.traits(name).meaning() || is_angle_of_parameter(definition, name);
  }

  bool is_angle_of_parameter(const DefinitionSyntax& definition, NameId name) const {
    if (definition.left == definition.name) return false;
    const std::optional<ImpliedAngle> angle = implied_angle(table_.text(name));
    if (!angle) return false;
    if (angle->label.empty()) return true;
    const std::span<const NodeId> parameters = block_.tree.children(definition.left).subspan(1);
    return std::ranges::any_of(parameters, [&](NodeId node) {
      const NameId parameter = names_.by_node[node.value];
      return parameter.valid() && direction_label(table_.text(parameter)) == angle->label;
    });
  }

  bool is_parameter(const DefinitionSyntax& definition, NameId name) const {
    if (definition.left == definition.name) return false;
    const std::span<const NodeId> parameters = block_.tree.children(definition.left).subspan(1);
    return std::ranges::any_of(parameters, [&](NodeId node) { return names_.by_node[node.value] == name; });
  }

  /// Several arguments, which are no tuple.
  bool is_list(uint32_t bracket) {
    if (commas_.empty()) commas_ = count_commas(block_.tokens);
    return commas_[bracket] != 0 && commas_[bracket] != 2;
  }

  const ParsedBlock& block_;
  const BlockNames& names_;
  const NameTable& table_;
  const std::function<NameKind(NameId)>& kind_of_;
  std::vector<uint32_t> commas_;  // by token, when it is first asked for
  std::vector<uint32_t> found_;
};

}  // namespace

std::vector<uint32_t> find_factors(const ParsedBlock& block, const BlockNames& names, const NameTable& table,
                                   const std::function<NameKind(NameId)>& kind_of) {
  return FactorSearch(block, names, table, kind_of).run();
}

}  // namespace texbrdf
