#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "analysis/snapshot_state.h"

namespace texbrdf {

/// Where the macros of a document are defined.
class MacroPlaces {
 public:
  explicit MacroPlaces(const Snapshot::State& state);

  /// Of the name in the definition that is in force.
  std::optional<Location> definition_of(std::string_view name) const;
  /// All of it.
  std::optional<Location> whole_definition_of(std::string_view name) const;
  /// All, by name.
  std::vector<DocumentMacro> all() const;
  /// The macro whose definition has its name at the offset, as it is seen.
  std::optional<MacroUse> defined_at(uint32_t offset) const;

 private:
  Location at(uint32_t macro, Span span) const;

  const Snapshot::State& state_;
  std::vector<PlacedMacro> all_;
  MacroTable table_;
};

}  // namespace texbrdf
