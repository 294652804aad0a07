#include "features/definition.h"

#include "features/places.h"

namespace texbrdf::features {

std::optional<DefinitionLink> definition_at(const Snapshot& snapshot, uint32_t offset) {
  const auto occurrence = snapshot.occurrence_at(offset);
  if (!occurrence) {
    const auto macro = snapshot.macro_at(offset);
    return macro ? std::optional(DefinitionLink{macro->span, macro->definition, macro->definition_name}) : std::nullopt;
  }
  if (occurrence->target.valid()) {
    return DefinitionLink{occurrence->span, definition_span(snapshot, occurrence->target),
                          name_span(snapshot, occurrence->target)};
  }
  if (const auto shown = stood_for(snapshot, *occurrence)) {
    return DefinitionLink{occurrence->span, definition_span(snapshot, *shown), name_span(snapshot, *shown)};
  }
  if (occurrence->referent.kind == Referent::Kind::Bound) {
    const Definition& around = snapshot.definition(occurrence->inside);
    const BoundName& bound = around.checked->bound[occurrence->referent.index];
    return DefinitionLink{occurrence->span, definition_span(snapshot, occurrence->inside),
                          node_span(snapshot, around.block, bound.variable)};
  }
  if (occurrence->referent.kind != Referent::Kind::Parameter) return std::nullopt;
  const Definition& function = snapshot.definition(occurrence->inside);
  const CheckedParameter& parameter = function.checked->parameters[occurrence->referent.index];
  return DefinitionLink{occurrence->span, definition_span(snapshot, occurrence->inside),
                        node_span(snapshot, function.block, parameter.node)};
}

}  // namespace texbrdf::features
