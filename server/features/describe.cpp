#include "features/describe.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "analysis/equation_text.h"
#include "features/places.h"
#include "features/value_text.h"
#include "source/utf8.h"

namespace texbrdf::features {
namespace {

/// A longer equation is cut off: nobody reads it in a tooltip.
constexpr std::size_t kMaxEquationBytes = 1000;

/// Paragraphs in the markup that the client understands.
class Page {
 public:
  explicit Page(Markup markup) : markup_(markup) {}

  void paragraph(std::string_view text) {
    if (!text_.empty()) text_ += "\n\n";
    text_ += text;
  }
  void equation(std::string_view latex) {
    const std::string shown = shortened(latex);
    paragraph(markup_ == Markup::Markdown ? fmt::format("```latex\n{}\n```", shown) : shown);
  }
  std::string code(std::string_view text) const {
    if (markup_ == Markup::PlainText) return std::string(text);
    return text.find('`') == std::string_view::npos ? fmt::format("`{}`", text) : fmt::format("`` {} ``", text);
  }
  std::string take() { return std::move(text_); }

 private:
  static std::string shortened(std::string_view text) {
    if (text.size() <= kMaxEquationBytes) return std::string(text);
    std::size_t end = 0;
    while (end < kMaxEquationBytes) end += code_point_at_front(text.substr(end)).size;
    return fmt::format("{} …", text.substr(0, end));
  }

  Markup markup_;
  std::string text_;
};

/// The parameters of a function that the convention follows inside it, as in g(\omega_i) = \cos\theta_i.
std::vector<std::string_view> followed_parameters(const Snapshot& snapshot, DefinitionId inside,
                                                  Convention convention) {
  std::vector<std::string_view> names;
  if (!inside.valid()) return names;
  const Definition& function = snapshot.definition(inside);
  for (const CheckedParameter& parameter : function.checked->parameters) {
    if (depends_on(convention, parameter.shadowed)) names.push_back(snapshot.names().text(parameter.name));
  }
  return names;
}

/// What a definition, parameter or convention is called.
std::string referent_text(const Snapshot& snapshot, const CheckedDefinition& inside, const Referent& referent) {
  switch (referent.kind) {
    case Referent::Kind::Definition:
      return shown_name(snapshot.names().text(NameId{referent.index}));
    case Referent::Kind::Parameter:
      return shown_name(snapshot.names().text(inside.parameters[referent.index].name));
    case Referent::Kind::Convention:
      return std::string(convention_entry(static_cast<Convention>(referent.index)).symbol);
    case Referent::Kind::None:
    case Referent::Kind::Angle:
    case Referent::Kind::Builtin:
    case Referent::Kind::Derived:
    case Referent::Kind::Bound:
    case Referent::Kind::BoundAngle:
    case Referent::Kind::Indexed:
    case Referent::Kind::Derivative:
    case Referent::Kind::Transposition:
      return {};
  }
  return {};
}

std::string angle_formula(ParameterAngle angle, std::string_view direction) {
  if (angle.kind == Convention::PhiI) return fmt::format("atan2({0}·Y, {0}·X)", direction);
  return fmt::format("arccos(N·{})", direction);
}

std::string_view binder_role(const ParsedBlock& block, const BoundName& bound) {
  const NodeKind kind = block.tree.node(bound.node).kind;
  return kind == NodeKind::BigOperator ? "index" : "variable";
}

std::string describe_as(const Snapshot& snapshot, DefinitionId id, const Signature& signature, Markup markup) {
  Page page(markup);
  const Definition& definition = snapshot.definition(id);
  const std::string_view name = snapshot.names().text(definition.name);
  page.paragraph(fmt::format("{}: {}", page.code(name), page.code(signature_text(signature))));
  page.equation(snapshot.equation(id));

  std::string facts;
  if (const auto value = snapshot.constant_value(id)) facts = fmt::format("value {} · ", value_text(*value));
  facts += fmt::format("defined on {}", line_name(snapshot, name_span(snapshot, id).begin));
  page.paragraph(facts);

  const auto in_force = snapshot.find(definition.name);
  if (!definition.in_force && in_force) {
    page.paragraph(
        fmt::format("the definition on {} is in force", line_name(snapshot, name_span(snapshot, *in_force).begin)));
  }
  if (find_convention(name)) page.paragraph("hides the convention of the same name");
  return page.take();
}

}  // namespace

std::string describe_definition(const Snapshot& snapshot, DefinitionId id, Markup markup) {
  return describe_as(snapshot, id, snapshot.definition(id).checked->signature, markup);
}

std::string describe_instance(const Snapshot& snapshot, DefinitionId id, const InstanceCall& call, Markup markup) {
  Signature signature;
  signature.is_function = true;
  signature.parameters = call.instance.parameters;
  signature.result = call.result;
  return describe_as(snapshot, id, signature, markup);
}

std::string describe_parameter(const Snapshot& snapshot, DefinitionId id, uint32_t index, Markup markup) {
  Page page(markup);
  const Definition& function = snapshot.definition(id);
  const CheckedParameter& parameter = function.checked->parameters[index];
  page.paragraph(fmt::format("{}: {}", page.code(parameter_text(snapshot, function.block, parameter)),
                             page.code(type_symbol(parameter.type))));
  const bool surprising = parameter.inferred && is_triple(parameter.type);
  page.paragraph(fmt::format("parameter of {}{}", page.code(snapshot.names().text(function.name)),
                             surprising ? ", a vector because of how it is used" : ""));
  return page.take();
}

std::string describe_expression(const Snapshot& snapshot, const Expression& expression, Markup markup) {
  Page page(markup);
  const BlockId block = snapshot.definition(expression.definition).block;
  page.paragraph(page.code(type_symbol(type_of(snapshot, expression))));
  page.equation(one_line(snapshot.parsed(block), expression.node));
  return page.take();
}

std::string describe_convention(const Snapshot& snapshot, std::string_view name, Convention convention,
                                DefinitionId inside, Markup markup) {
  Page page(markup);
  const ConventionEntry& entry = convention_entry(convention);
  page.paragraph(
      fmt::format("{}: {} = {}", page.code(name), page.code(type_symbol(entry.type)), page.code(entry.formula)));
  page.paragraph(entry.meaning);
  for (const std::string_view parameter : followed_parameters(snapshot, inside, entry.id)) {
    page.paragraph(fmt::format("here of the parameter {}", page.code(parameter)));
  }
  page.paragraph(find_convention(name) ? "a convention of the language"
                                       : "what the name usually means: nothing defines it");
  return page.take();
}

std::string describe_macro(const Snapshot& snapshot, const MacroOccurrence& macro, Markup markup) {
  Page page(markup);
  const FilePlace place = snapshot.place(macro.definition);
  page.equation(snapshot.text(place.file).slice(place.span));
  page.paragraph(fmt::format("macro, defined on {}", line_name(snapshot, macro.definition_name.begin)));
  return page.take();
}

std::string describe_angle(const Snapshot& snapshot, std::string_view name, ParameterAngle angle, DefinitionId inside,
                           Markup markup) {
  Page page(markup);
  const CheckedParameter& parameter = snapshot.definition(inside).checked->parameters[angle.position];
  const std::string_view direction = snapshot.names().text(parameter.name);
  const bool is_azimuth = angle.kind == Convention::PhiI;
  const std::string formula = angle_formula(angle, direction);
  page.paragraph(fmt::format("{}: {} = {}", page.code(name), page.code(type_symbol(Type::Real)), page.code(formula)));
  page.paragraph(fmt::format("{} of the parameter {}", is_azimuth ? "azimuth" : "polar angle", page.code(direction)));
  return page.take();
}

std::string describe_bound(const Snapshot& snapshot, const Occurrence& occurrence, Markup markup) {
  const Definition around = snapshot.definition(occurrence.inside);
  const bool is_angle = occurrence.referent.kind == Referent::Kind::BoundAngle;
  const ParameterAngle angle = angle_of_parameter(occurrence.referent);
  const BoundName& bound = around.checked->bound[is_angle ? angle.position : occurrence.referent.index];
  const ParsedBlock& block = snapshot.parsed(around.block);
  const std::string variable(block.node_text(bound.variable));
  Page page(markup);
  const std::string_view name = snapshot.names().text(occurrence.name);
  if (is_angle) {
    const std::string formula = angle_formula(angle, variable);
    page.paragraph(fmt::format("{}: {} = {}", page.code(name), page.code(type_symbol(Type::Real)), page.code(formula)));
  } else {
    page.paragraph(fmt::format("{}: {}", page.code(name), page.code(type_symbol(bound.type))));
  }
  page.paragraph(fmt::format("{}{} of {}", is_angle ? "angle of the " : "", binder_role(block, bound),
                             page.code(one_line(block, bound.node))));
  return page.take();
}

static Type derived_type(const DerivedNumber& number) {
  return number.kind == DerivedNumber::Kind::PositivePart ? number.vector.type : Type::Real;
}

std::string describe_derived(const Snapshot& snapshot, const Occurrence& occurrence, Markup markup) {
  Page page(markup);
  const CheckedDefinition& inside = *snapshot.definition(occurrence.inside).checked;
  const DerivedNumber& number = inside.derived[occurrence.referent.index];
  const std::string vector = referent_text(snapshot, inside, number.vector.referent);
  std::string formula, meaning;
  switch (number.kind) {
    case DerivedNumber::Kind::PolarAngle:
      formula = fmt::format("arccos(N·{})", vector);
      meaning = "polar angle of";
      break;
    case DerivedNumber::Kind::Azimuth:
      formula = fmt::format("atan2({0}·Y, {0}·X)", vector);
      meaning = "azimuth of";
      break;
    case DerivedNumber::Kind::Component:
      formula = fmt::format("{}·{}", vector, "XYN"[number.axis]);
      meaning = "component of";
      break;
    case DerivedNumber::Kind::PositivePart:
      formula = fmt::format("max(0, {})", vector);
      meaning = "positive part of";
      break;
    case DerivedNumber::Kind::Entry: {
      const Shape shape = type_shape(number.vector.type);
      const uint32_t row = number.axis / shape.columns + 1, column = number.axis % shape.columns + 1;
      formula = shape.is_vector() ? fmt::format("{}[{}]", vector, number.axis + 1)
                                  : fmt::format("{}[{}, {}]", vector, row, column);
      meaning = "entry of";
      break;
    }
  }
  const std::string_view name = snapshot.names().text(occurrence.name);
  page.paragraph(
      fmt::format("{}: {} = {}", page.code(name), page.code(type_symbol(derived_type(number))), page.code(formula)));
  page.paragraph(fmt::format("{} {}", meaning, page.code(vector)));
  return page.take();
}

std::string describe_builtin(std::string_view name, Builtin function, Markup markup) {
  Page page(markup);
  const BuiltinEntry& entry = builtin_entry(function);
  const std::string_view shown = name == kStepFunction ? "\\chi^+" : name;
  page.paragraph(fmt::format("{}: {}", page.code(shown), page.code(signature_text(entry.signature))));
  page.paragraph(entry.meaning);
  page.paragraph("a function that needs no definition");
  return page.take();
}

}  // namespace texbrdf::features
