#include "semantics/ambiguities.h"

#include <algorithm>

#include "semantics/implied_angle.h"

namespace texbrdf {
namespace {

class Ambiguities {
 public:
  Ambiguities(const DefinitionView& view, CheckedDefinition& checked) : view_(view), checked_(checked) {}

  void tell() {
    if (is_cosine_called_angle()) tell_angle();
    for (uint32_t i = view_.body_begin(); i < view_.body_end(); ++i) read(NodeId{i});
  }

 private:
  void read(NodeId id) {
    const Node& node = view_.node(id);
    if (node.kind == NodeKind::Infix && text(node.token) == "\\cdot") read_product(id);
    if (node.kind == NodeKind::Angles && node.child_count == 2) tell_inner_product(id);
    if (node.kind == NodeKind::Function && node.child_count == 1 && text(node.token) == "\\log")
      tell_logarithm(node.token);
  }

  Type type(NodeId id) const { return checked_.types[view_.slot(id)]; }
  std::string_view text(uint32_t token) const { return view_.block.token_text(token); }

  Diagnostic& report(Code code, Location where, std::vector<std::string> arguments = {}) {
    return checked_.diagnostics.emplace_back(make_diagnostic(code, where, std::move(arguments)));
  }

  void read_product(NodeId product) {
    const NodeId left = view_.block.tree.child(product, 0);
    const NodeId right = view_.block.tree.child(product, 1);
    const auto is_colour = [this](NodeId operand) {
      return is_triple(type(operand)) && is_componentwise(type(operand));
    };
    if (is_colour(left) && is_colour(right)) return tell_colour_product(view_.node(product).token);
    if (type(right) == Type::Vector) tell_letter(left, view_.node(product).token);
    if (type(left) == Type::Vector) tell_letter(right, view_.node(product).token);
  }

  void tell_colour_product(uint32_t dot) {
    const Location where = view_.at_token(dot);
    report(Code::ColourProduct, where)
        .fixes.push_back({.title = "write `*`, a product by component", .edits = {{where, "*"}}});
  }

  /// `(n \cdot l)^n` where n is the exponent.
  void tell_letter(NodeId operand, uint32_t dot) {
    const NodeId name = view_.without_groups(operand);
    if (view_.node(name).kind != NodeKind::Name || !view_.name(name).valid()) return;
    const std::optional<Convention> usual = view_.table.traits(view_.name(name)).usual_meaning;
    if (!usual || convention_entry(*usual).type != Type::Vector) return;
    const bool is_number = type(name) == Type::Real;
    const bool is_number_elsewhere = checked_.referents[view_.slot(name)].kind == Referent::Kind::Convention &&
                                     view_.facts.fact(view_.name(name)).kind == NameFact::Kind::Defined;
    if (!is_number && !is_number_elsewhere) return;
    const std::string letter = view_.name_text(name);
    const std::string bold = "\\mathbf{" + letter + "}";
    const std::string meaning(convention_entry(*usual).meaning);
    Diagnostic& told = report(is_number ? Code::NumberAsDirection : Code::DirectionDespiteNumber, view_.at(name),
                              {letter, meaning, bold});
    told.fixes.push_back({.title = "write `" + bold + "`", .edits = {{view_.at(name), bold}}});
    told.fixes.push_back({.title = "write `*`, a multiple of the vector", .edits = {{view_.at_token(dot), "*"}}});
  }

  void tell_inner_product(NodeId angles) {
    const Node& node = view_.node(angles);
    const NodeId second = view_.block.tree.child(angles, 1);
    if (type(second) != Type::Vector || type(view_.block.tree.child(angles, 0)) != Type::Vector) return;
    const uint32_t first_of_second = view_.node(second).first_token;
    uint32_t comma = first_of_second;
    while (comma > node.token && view_.token(comma).kind != TokenKind::Comma) --comma;
    const Edit dot{view_.at_token(comma), " \\cdot"};
    Diagnostic& told = report(Code::InnerProduct, view_.at(angles));
    told.fixes.push_back({.title = "write the positive part, `\\langle a \\cdot b \\rangle`", .edits = {dot}});
    told.fixes.push_back(
        {.title = "write the dot product, `(a \\cdot b)`",
         .edits = {{view_.at_token(node.token), "("}, dot, {view_.at_token(node.end_token - 1), ")"}}});
  }

  void tell_logarithm(uint32_t log) {
    if (has_told_logarithm_) return;
    has_told_logarithm_ = true;
    const Location where = view_.at_token(log);
    Diagnostic& told = report(Code::NaturalLogarithm, where);
    told.fixes.push_back({.title = "write `\\ln`", .edits = {{where, "\\ln"}}});
    told.fixes.push_back({.title = "write `\\lg`, to the base 10", .edits = {{where, "\\lg"}}});
  }

  /// `\theta_i = |\omega_i \cdot \omega_g|`.
  bool is_cosine_called_angle() const {
    if (checked_.signature.is_function) return false;
    const std::optional<ImpliedAngle> angle = implied_angle(view_.table.text(checked_.name));
    if (!angle || angle->kind != Convention::ThetaI) return false;
    NodeId body = view_.without_groups(view_.syntax.body);
    while (is_around_one(body)) body = view_.without_groups(view_.block.tree.child(body, 0));
    if (view_.node(body).kind != NodeKind::Infix || type(body) != Type::Real) return false;
    return std::ranges::all_of(view_.block.tree.children(body),
                               [this](NodeId operand) { return type(operand) == Type::Vector; });
  }

  bool is_around_one(NodeId id) const {
    const Node& node = view_.node(id);
    return (node.kind == NodeKind::Bars || node.kind == NodeKind::Angles) && node.child_count == 1;
  }

  void tell_angle() {
    const std::string name = view_.defined_text();
    const Location where = view_.at(view_.syntax.name);
    Location before = where;
    before.span.end = before.span.begin;
    report(Code::CosineAsAngle, where, {name})
        .fixes.push_back({.title = "write `\\cos" + name + "`", .edits = {{before, "\\cos"}}});
  }

  const DefinitionView& view_;
  CheckedDefinition& checked_;
  bool has_told_logarithm_ = false;
};

}  // namespace

void tell_ambiguities(const DefinitionView& view, CheckedDefinition& checked) {
  Ambiguities(view, checked).tell();
}

}  // namespace texbrdf
