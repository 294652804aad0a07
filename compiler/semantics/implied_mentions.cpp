#include "semantics/implied_mentions.h"

#include <algorithm>
#include <string>

#include "semantics/component.h"
#include "semantics/implied_angle.h"

namespace texbrdf {
namespace {

class MentionSearch {
 public:
  MentionSearch(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names, NameTable& table,
                const KnownNames& known)
      : block_(block), definition_(definition), names_(names), table_(table), known_(known) {}

  std::vector<NameId> run() {
    for (uint32_t node = definition_.left.value + 1; node <= definition_.body.value; ++node) {
      const NameId name = names_.by_node[node];
      const bool is_bound = names_.bound_use(NodeId{node}) != nullptr;
      if (name.valid() && !is_bound && !hidden_.find(name)) read(NodeId{node}, name);
    }
    std::ranges::sort(found_);
    const auto repeated = std::ranges::unique(found_);
    found_.erase(repeated.begin(), repeated.end());
    return std::move(found_);
  }

 private:
  void read(NodeId node, NameId name) {
    switch (known_.kind(name)) {
      case NameKind::Value:
        return;
      case NameKind::Function:
        if (!is_callee(node)) add_arguments(name);
        return;
      case NameKind::Absent:
        return read_absent(name);
    }
  }

  bool is_callee(NodeId name) const {
    const uint32_t behind = block_.tree.node(name).end_token;
    return block_.opens_arguments(behind) || block_.is_power_of_call(behind);
  }

  void add_arguments(NameId function) {
    for (const NameId parameter : known_.parameters(function)) add(parameter);
  }

  void read_absent(NameId name) {
    if (table_.traits(name).convention) return;
    const std::string text(table_.text(name));
    if (const std::string_view whole = name_of_positive_part(text); !whole.empty()) add(table_.intern(whole));
    if (const std::optional<EntryName> entry = entry_name(text)) {
      for (const std::string& owner : entry->aggregates) add(table_.intern(owner));
    }
    const std::optional<ImpliedAngle> angle = implied_angle(text);
    if (!angle || angle->label.empty()) return;
    for (const std::string& direction : directions_called(angle->label)) add(table_.intern(direction));
  }

  void add(NameId name) {
    if (name.valid() && !hidden_.find(name)) found_.push_back(name);
  }

  const ParsedBlock& block_;
  const DefinitionSyntax& definition_;
  const BlockNames& names_;
  NameTable& table_;
  const KnownNames& known_;
  const SmallNameMap hidden_ = hidden_names(block_, definition_, names_);
  std::vector<NameId> found_;
};

}  // namespace

std::vector<NameId> implied_mentions(const ParsedBlock& block, const DefinitionSyntax& definition,
                                     const BlockNames& names, NameTable& table, const KnownNames& known) {
  return MentionSearch(block, definition, names, table, known).run();
}

std::vector<std::string> directions_called(std::string_view label) {
  const std::string name(label);
  const std::string subscript = label.size() == 1 ? "_" + name : "_{" + name + "}";
  std::vector<std::string> found;
  for (const std::string& spelling :
       {name, "\\vec{" + name + "}", "\\omega" + subscript, "\\vec{\\omega" + subscript + "}"}) {
    if (std::optional<std::string> canonical = canonical_name(spelling)) found.push_back(*std::move(canonical));
  }
  return found;
}

}  // namespace texbrdf
