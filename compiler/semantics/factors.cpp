#include "semantics/factors.h"

#include <algorithm>

#include "semantics/implied_angle.h"
#include "syntax/brackets.h"

namespace texbrdf {
namespace {

/// Of a bracket that opens.
struct BracketContent {
  uint32_t commas = 0;  ///< outside of inner brackets
  uint32_t closer = 0;  ///< the token; 0 where there is none
};

/// By token.
std::vector<BracketContent> read_brackets(std::span<const Token> tokens) {
  std::vector<BracketContent> brackets(tokens.size());
  std::vector<uint32_t> open;
  for (uint32_t i = 0; i < tokens.size(); ++i) {
    if (is_opener(tokens[i].kind)) {
      open.push_back(i);
    } else if (is_closer(tokens[i].kind)) {
      if (open.empty()) continue;
      brackets[open.back()].closer = i;
      open.pop_back();
    } else if (tokens[i].kind == TokenKind::Comma && !open.empty()) {
      ++brackets[open.back()].commas;
    }
  }
  return brackets;
}

class FactorSearch {
 public:
  FactorSearch(const ParsedBlock& block, const BlockNames& names, const NameTable& table, const KnownNames& known)
      : block_(block), names_(names), table_(table), known_(known) {}

  std::vector<uint32_t> run() {
    for (uint32_t i = 0; i < block_.definitions.size(); ++i) {
      const DefinitionSyntax& definition = block_.definitions[i];
      is_function_ = definition.left != definition.name;
      hidden_ = hidden_names(block_, definition, names_);
      for (uint32_t node = definition.left.value + 1; node <= block_.last_node(i).value; ++node) {
        const NameId name = names_.by_node[node];
        if (name.valid()) read(NodeId{node}, name);
      }
    }
    std::ranges::sort(found_);
    return std::move(found_);
  }

 private:
  void read(NodeId node, NameId name) {
    const uint32_t bracket = block_.tree.node(node).end_token;
    if (is_power_of_call(bracket, name)) return found_.push_back(bracket);
    if (block_.tokens[bracket].kind != TokenKind::OpenParen) return;
    const bool is_factor = is_power_of_function(node) || (is_value_at(node, name) && !is_list(bracket));
    if (is_factor) found_.push_back(bracket);
  }

  /// The `^` of `a^2(x)` and `a^{n+1}(x)`, where `a` is a function. The inverse of one is no power.
  bool is_power_of_call(uint32_t caret, NameId name) {
    if (block_.tokens[caret].kind != TokenKind::Caret) return false;
    uint32_t last = caret + 1;
    if (block_.tokens[last].kind == TokenKind::OpenBrace) {
      last = brackets()[last].closer;
      if (last == 0 || block_.tokens[caret + 2].kind == TokenKind::Minus) return false;
    } else if (block_.tokens[last].kind != TokenKind::Number) {
      return false;
    }
    return block_.tokens[last + 1].kind == TokenKind::OpenParen && !hidden_.find(name) &&
           known_.kind(name) == NameKind::Function;
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

  /// A bound name is a value, and one with an index what those are that it stands for.
  bool is_value_at(NodeId node, NameId name) const {
    if (names_.bound_use(node) != nullptr) return true;
    const StandIn* stand_in = names_.stand_in(node);
    const bool stands_for_others = stand_in != nullptr && !stand_in->binders.empty() &&
                                   known_.kind(name) == NameKind::Absent && !hidden_.find(name) &&
                                   known_.kind(stand_in->names[0]) != NameKind::Absent;
    return is_value(stands_for_others ? stand_in->names[0] : name);
  }

  bool is_value(NameId name) const {
    if (hidden_.find(name)) return true;
    const NameKind kind = known_.kind(name);
    if (kind != NameKind::Absent) return kind == NameKind::Value;
    return table_.traits(name).meaning() || is_angle_of_parameter(name);
  }

  bool is_angle_of_parameter(NameId name) const {
    if (!is_function_) return false;
    const std::optional<ImpliedAngle> angle = implied_angle(table_.text(name));
    if (!angle) return false;
    if (angle->label.empty()) return true;
    return std::ranges::any_of(
        hidden_.names(), [&](NameId parameter) { return direction_label(table_.text(parameter)) == angle->label; });
  }

  /// Several arguments, which are no tuple.
  bool is_list(uint32_t bracket) {
    const uint32_t commas = brackets()[bracket].commas;
    return commas != 0 && commas != 2;
  }

  const std::vector<BracketContent>& brackets() {
    if (brackets_.empty()) brackets_ = read_brackets(block_.tokens);
    return brackets_;
  }

  const ParsedBlock& block_;
  const BlockNames& names_;
  const NameTable& table_;
  const KnownNames& known_;
  bool is_function_ = false;              // the definition that is read
  SmallNameMap hidden_;                   // by its parameters
  std::vector<BracketContent> brackets_;  // by token, when it is first asked for
  std::vector<uint32_t> found_;
};

}  // namespace

std::vector<uint32_t> find_factors(const ParsedBlock& block, const BlockNames& names, const NameTable& table,
                                   const KnownNames& known) {
  return FactorSearch(block, names, table, known).run();
}

}  // namespace texbrdf
