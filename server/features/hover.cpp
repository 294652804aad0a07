#include "features/hover.h"

#include "features/places.h"

namespace texbrdf::features {

namespace {

std::optional<Hover> hover_definition(const Snapshot& snapshot, const Occurrence& occurrence, Markup markup) {
  const DefinitionId id = occurrence.target;
  for (const InstanceCall& call : snapshot.definition(occurrence.inside).checked->instance_calls) {
    if (call.callee == occurrence.node) {
      return Hover{describe_instance(snapshot, id, call, markup), occurrence.span};
    }
  }
  return Hover{describe_definition(snapshot, id, markup), occurrence.span, Expression{id, snapshot.syntax(id).body}};
}

std::optional<Hover> hover_expression(const Snapshot& snapshot, const Expression& expression, Markup markup) {
  if (type_of(snapshot, expression) == Type::Error) return std::nullopt;
  const BlockId block = snapshot.definition(expression.definition).block;
  return Hover{describe_expression(snapshot, expression, markup), node_span(snapshot, block, expression.node),
               expression};
}

std::optional<Hover> hover_name(const Snapshot& snapshot, const Occurrence& occurrence, Markup markup) {
  if (occurrence.target.valid()) return hover_definition(snapshot, occurrence, markup);
  if (const auto shown = stood_for(snapshot, occurrence)) {
    return Hover{describe_definition(snapshot, *shown, markup), occurrence.span};
  }
  switch (occurrence.referent.kind) {
    case Referent::Kind::Parameter:
      return Hover{describe_parameter(snapshot, occurrence.inside, occurrence.referent.index, markup), occurrence.span};
    case Referent::Kind::Convention:
      return Hover{describe_convention(snapshot, snapshot.names().text(occurrence.name),
                                       static_cast<Convention>(occurrence.referent.index), occurrence.inside, markup),
                   occurrence.span};
    case Referent::Kind::Angle:
      return Hover{describe_angle(snapshot, snapshot.names().text(occurrence.name),
                                  angle_of_parameter(occurrence.referent), occurrence.inside, markup),
                   occurrence.span};
    case Referent::Kind::Derived:
      return Hover{describe_derived(snapshot, occurrence, markup), occurrence.span};
    case Referent::Kind::Builtin:
      return Hover{describe_builtin(snapshot.names().text(occurrence.name),
                                    static_cast<Builtin>(occurrence.referent.index), markup),
                   occurrence.span};
    case Referent::Kind::Bound:
    case Referent::Kind::BoundAngle:
      return Hover{describe_bound(snapshot, occurrence, markup), occurrence.span};
    case Referent::Kind::None:
    case Referent::Kind::Definition:
    case Referent::Kind::Indexed:
    case Referent::Kind::Derivative:
    case Referent::Kind::Transposition:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Hover> hover(const Snapshot& snapshot, uint32_t offset, Markup markup) {
  const std::optional<Occurrence> name = snapshot.occurrence_at(offset);
  if (!name || offset >= name->span.end) {
    const auto macro = snapshot.macro_at(offset);
    if (macro && (!name || offset < macro->span.end))
      return Hover{describe_macro(snapshot, *macro, markup), macro->span};
  }
  const bool touches_only = !name || offset >= name->span.end;
  if (touches_only) {
    if (const auto expression = expression_at(snapshot, offset)) return hover_expression(snapshot, *expression, markup);
  }
  return name ? hover_name(snapshot, *name, markup) : std::nullopt;
}

}  // namespace texbrdf::features
