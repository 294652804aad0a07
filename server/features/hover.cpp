#include "features/hover.h"

namespace texbrdf::features {

std::optional<Hover> hover(const Snapshot& snapshot, uint32_t offset, Markup markup) {
  const auto occurrence = snapshot.occurrence_at(offset);
  if (!occurrence) return std::nullopt;
  if (occurrence->target.valid()) {
    return Hover{describe_definition(snapshot, occurrence->target, markup), occurrence->span};
  }
  switch (occurrence->referent.kind) {
    case Referent::Kind::Parameter:
      return Hover{describe_parameter(snapshot, occurrence->inside, occurrence->referent.index, markup),
                   occurrence->span};
    case Referent::Kind::Convention:
      return Hover{describe_convention(snapshot, snapshot.names().text(occurrence->name),
                                       static_cast<Convention>(occurrence->referent.index), occurrence->inside, markup),
                   occurrence->span};
    case Referent::Kind::None:
    case Referent::Kind::Definition:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace texbrdf::features
