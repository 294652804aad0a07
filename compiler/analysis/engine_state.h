#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "analysis/directional_names.h"
#include "analysis/name_occurrences.h"
#include "analysis/project_text.h"
#include "analysis/segment.h"
#include "semantics/check.h"
#include "semantics/instance_facts.h"
#include "semantics/known_names.h"
#include "syntax/macro_table.h"

namespace texbrdf {

/// What the definition in force says of a name to all others, what it mentions, and where it stands in the order of
/// checking.
struct NameState {
  NameFact fact;
  InstancesOfFunction instances;  ///< that were asked for since the fact or one of them last changed
  NameKind kind = NameKind::Absent;
  std::vector<NameId> parameters;  ///< of a function, see KnownNames
  uint32_t uses_as_parameter = 0;  ///< how often the name stands in `parameters` of others
  std::vector<NameId> mentions;    ///< kept here too because walks over many definitions are quicker so
  /// Greater than that of every name that the definition mentions, unless it is in a knot; 0 where there is none.
  uint32_t height = 0;
  bool in_knot = false;  ///< its definition needs itself
};

/// Names whose definitions need each other, as a path from the first of them.
using Cycle = std::vector<NameId>;

/// Which definition is the BRDF.
struct RootChoice {
  std::string name;             ///< canonical; empty where no instruction names one and no definition looks like one
  bool has_directives = false;  ///< the document says something to texbrdf: it is one of ours

  std::string name_or_f() const { return name.empty() ? "f" : name; }
};

/// All that is known of a document between two edits.
struct EngineState {
  ProjectText text;
  SegmentSequence segments;
  MacroTable macros;
  std::shared_ptr<NameTable> names = std::make_shared<NameTable>();
  std::vector<NameState> name_states;        ///< by NameId
  std::vector<NameOccurrences> occurrences;  ///< by NameId
  bool lists_users = false;                  ///< who mentions a name is listed when it is first needed
  /// Blocks with runs of letters that are no names by themselves: how they are read may change with any definition.
  std::set<BlockLabel> open_words;
  uint64_t rereadings = 0;  ///< of blocks that were not edited
  DirectionalNames directional;
  RootChoice root;
  /// By NameId, the names that the root needs; nullptr where no report depends on it.
  std::shared_ptr<const std::vector<bool>> needed;
  std::shared_ptr<const std::vector<Cycle>> cycles = std::make_shared<const std::vector<Cycle>>();

  /// The first definition of a name among those of the best standing is in force; one of a constant of the convention
  /// never is.
  std::optional<DefinitionKey> in_force(NameId name) const {
    const Sequence<DefinitionKey>& definitions = occurrences[name.value].definitions;
    const NameTraits& traits = names->traits(name);
    const bool is_constant = traits.convention && convention_constant(*traits.convention);
    if (definitions.empty() || is_constant) return std::nullopt;
    return *definitions.at(0).item;
  }
};

/// Blocks that were scanned since the document was last checked.
struct TouchedBlocks {
  bool all = false;     ///< the document is new: `before` is empty, every block is touched
  bool macros = false;  ///< definitions of macros may be others
  std::unordered_map<BlockLabel, std::shared_ptr<const PlacedBlock>> before;  ///< what stood there then, or nullptr
};

}  // namespace texbrdf
