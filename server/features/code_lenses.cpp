#include "features/code_lenses.h"

#include <algorithm>
#include <optional>

#include "features/places.h"

namespace texbrdf::features {

std::vector<CodeLens> code_lenses(const Snapshot& snapshot, const CodeLensOptions& options) {
  std::vector<CodeLens> lenses;
  const std::optional<DefinitionId> root = snapshot.find(snapshot.root_name());
  DefinitionId id{0};
  for (const Definition& definition : snapshot.definitions()) {
    const CodeLens::Kind kind = id == root ? CodeLens::Kind::Preview : CodeLens::Kind::Uses;
    const bool is_wanted = kind == CodeLens::Kind::Preview ? options.preview : options.uses;
    if (is_wanted && definition.in_force) {
      lenses.push_back({kind, name_span(snapshot, id), snapshot.names().text(definition.name)});
    }
    ++id.value;
  }
  return lenses;
}

uint32_t count_uses(const Snapshot& snapshot, std::string_view name) {
  const std::optional<DefinitionId> id = snapshot.find(name);
  if (!id) return 0;
  const auto definition = snapshot.occurrence_at(name_span(snapshot, *id).begin);
  if (!definition) return 0;
  const std::vector<Occurrence> all = snapshot.occurrences_of(*definition);
  return static_cast<uint32_t>(std::ranges::count(all, false, &Occurrence::is_definition));
}

}  // namespace texbrdf::features
