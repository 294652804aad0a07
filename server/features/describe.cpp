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

}  // namespace

std::string describe_definition(const Snapshot& snapshot, DefinitionId id, Markup markup) {
  Page page(markup);
  const Definition& definition = snapshot.definition(id);
  const std::string_view name = snapshot.names().text(definition.name);
  page.paragraph(fmt::format("{}: {}", page.code(name), page.code(signature_text(definition.checked->signature))));
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

std::string describe_parameter(const Snapshot& snapshot, DefinitionId id, uint32_t index, Markup markup) {
  Page page(markup);
  const Definition& function = snapshot.definition(id);
  const CheckedParameter& parameter = function.checked->parameters[index];
  page.paragraph(
      fmt::format("{}: {}", page.code(snapshot.names().text(parameter.name)), page.code(type_symbol(parameter.type))));
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

std::string describe_angle(const Snapshot& snapshot, std::string_view name, ParameterAngle angle, DefinitionId inside,
                           Markup markup) {
  Page page(markup);
  const CheckedParameter& parameter = snapshot.definition(inside).checked->parameters[angle.position];
  const std::string_view direction = snapshot.names().text(parameter.name);
  const bool is_azimuth = angle.kind == Convention::PhiI;
  const std::string formula =
      is_azimuth ? fmt::format("atan2({0}·Y, {0}·X)", direction) : fmt::format("arccos(N·{})", direction);
  page.paragraph(fmt::format("{}: {} = {}", page.code(name), page.code(type_symbol(Type::Real)), page.code(formula)));
  page.paragraph(fmt::format("{} of the parameter {}", is_azimuth ? "azimuth" : "polar angle", page.code(direction)));
  return page.take();
}

}  // namespace texbrdf::features
