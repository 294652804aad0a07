#include "semantics/background.h"

#include <algorithm>

namespace texbrdf {
namespace {

class Statement {
 public:
  Statement(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names)
      : block_(block), definition_(definition), names_(names), body_(without_groups(definition.body)) {}

  bool says_symmetric() const {
    const bool has_parameters = definition_.left != definition_.name;
    if (!has_parameters || kind(body_) != NodeKind::Apply) return false;
    return std::ranges::is_permutation(names_in(definition_.left), names_in(body_)) &&
           name(block_.tree.child(body_, 0)) == name(definition_.name);
  }

  bool is_quotient_of_differentials() const {
    const bool is_quotient =
        kind(body_) == NodeKind::Fraction ||
        (kind(body_) == NodeKind::Infix && block_.tokens[node(body_).token].kind == TokenKind::Divide);
    return is_quotient && is_differential(block_.tree.child(body_, 0)) && is_differential(block_.tree.child(body_, 1));
  }

  bool gives_number() const {
    NodeId value = body_;
    while (kind(value) == NodeKind::Prefix) value = block_.tree.child(value, 0);
    return kind(value) == NodeKind::Number;
  }

 private:
  const Node& node(NodeId id) const { return block_.tree.node(id); }
  NodeKind kind(NodeId id) const { return node(id).kind; }
  NameId name(NodeId id) const { return names_.by_node[id.value]; }

  NodeId without_groups(NodeId id) const {
    while (kind(id) == NodeKind::Group) id = block_.tree.child(id, 0);
    return id;
  }

  /// Of a call or a signature; an invalid one stands for what is no name.
  std::vector<NameId> names_in(NodeId call) const {
    std::vector<NameId> found;
    for (NodeId child : block_.tree.children(call)) found.push_back(name(child));
    return found;
  }

  /// `dL_o`, `\mathrm{d}L_o`, `\partial L`, with what stands behind.
  bool is_differential(NodeId id) const {
    const uint32_t first = node(without_groups(id)).first_token;
    const std::string_view text = block_.token_text(first);
    const bool is_word = text.size() == 2 && text[0] == 'd' && text[1] >= 'A' && text[1] <= 'Z';
    const bool is_sign = text == "d" || text == "\\partial" || text == "\\mathrm{d}" || text == "\\text{d}";
    return is_word || (is_sign && kind(without_groups(id)) == NodeKind::Juxtaposition);
  }

  const ParsedBlock& block_;
  const DefinitionSyntax& definition_;
  const BlockNames& names_;
  const NodeId body_;
};

}  // namespace

bool is_background(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names,
                   const NameTable& table) {
  const Statement statement(block, definition, names);
  if (statement.says_symmetric() || statement.is_quotient_of_differentials()) return true;
  const NameId name = names.by_node[definition.name.value];
  return is_inline(block.extent.region) && table.traits(name).convention && statement.gives_number();
}

}  // namespace texbrdf
