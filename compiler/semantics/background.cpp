#include "semantics/background.h"

#include <algorithm>
#include <array>

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

  /// `L_o = \int_\Omega f_r L_i …`: a radiance made of a radiance that nobody knows. An integral of E is an average
  /// of albedos.
  bool is_integral_equation() const {
    if (!is_radiometric(definition_.name)) return false;
    bool has_quantity = false;
    for (NodeId id{body_begin()}; id <= definition_.body; ++id.value) {
      const bool is_quantity = kind(id) == NodeKind::Name && is_radiometric(id) && first_token_text(id) != "E";
      has_quantity = has_quantity || is_quantity;
    }
    return has_quantity && holds_integral();
  }

  /// A derivative of a radiance or flux, or by one, says what a quantity is.
  bool is_radiometric_derivative() const {
    if (kind(body_) != NodeKind::Derivative) return false;
    const NodeId variable = block_.tree.child(body_, 1);
    const bool is_by_solid_angle = block_.token_text(node(variable).first_token) == "\\omega";
    return is_by_solid_angle || is_radiometric(variable) || is_radiometric(block_.tree.child(body_, 0));
  }

  bool is_quotient_of_differentials() const {
    const bool is_quotient =
        kind(body_) == NodeKind::Fraction ||
        (kind(body_) == NodeKind::Infix && block_.tokens[node(body_).token].kind == TokenKind::Divide);
    return is_quotient && is_differential(block_.tree.child(body_, 0)) && is_differential(block_.tree.child(body_, 1));
  }

  /// `\cos\theta_i = \mathbf n \cdot \mathbf l`.
  bool gives_function_of_name() const {
    return kind(body_) == NodeKind::Inverse && node(body_).token < node(definition_.left).first_token;
  }

  bool holds_integral() const { return holds(NodeKind::Integral); }

  /// `\text{dot}(r, v) \approx \cos(2 \alpha)`: one of what it is given has to stand in the body of a function, and the
  /// function itself cannot.
  bool says_value_of_call() const {
    const bool has_parameters = definition_.left != definition_.name;
    return has_parameters && body_mentions(name(definition_.name));
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
  uint32_t body_begin() const { return definition_.left.value + 1; }

  bool holds(NodeKind wanted) const {
    for (uint32_t i = body_begin(); i <= definition_.body.value; ++i) {
      if (kind(NodeId{i}) == wanted) return true;
    }
    return false;
  }

  bool body_mentions(NameId wanted) const {
    const auto begin = names_.by_node.begin();
    return std::find(begin + body_begin(), begin + definition_.body.value + 1, wanted) !=
           begin + definition_.body.value + 1;
  }

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

  std::string_view first_token_text(NodeId id) const { return block_.token_text(node(id).first_token); }

  bool is_radiometric(NodeId id) const {
    constexpr auto kQuantities = std::to_array<std::string_view>({"L", "E", "I", "\\Phi"});
    return std::ranges::find(kQuantities, first_token_text(without_groups(id))) != kQuantities.end();
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
  if (statement.is_radiometric_derivative() || statement.is_integral_equation()) return true;
  const NameTraits& traits = table.traits(names.by_node[definition.name.value]);
  if (traits.builtin && is_inline(block.extent.region) && statement.says_value_of_call()) return true;
  if (!traits.convention) return false;
  if (statement.gives_function_of_name() && statement.holds_integral()) return true;
  return is_inline(block.extent.region) && (statement.gives_number() || statement.gives_function_of_name());
}

}  // namespace texbrdf
