#include "semantics/possible_names.h"

#include <algorithm>
#include <set>

namespace texbrdf {
namespace {

class PossibleNameReader {
 public:
  PossibleNameReader(const ParsedBlock& block, NameTable& table, BlockNames& names)
      : block_(block), table_(table), names_(names) {}

  void run() {
    find_hats_apart();
    for (uint32_t i = 0; i < block_.tree.size(); ++i) {
      const NodeId id{i};
      if (is_name_in_angles(id)) {
        Name name = read_name(block_, block_.tree.child(id, 0));
        name.is_in_angles = true;
        names_.possible.push_back({id, table_.intern(canonical_form(name))});
      } else if (is_hat(id)) {
        read_hat(id);
      }
    }
  }

 private:
  NameId& name(NodeId id) { return names_.by_node[id.value]; }

  bool is_name_in_angles(NodeId id) const {
    const Node& node = block_.tree.node(id);
    return node.kind == NodeKind::Angles && node.child_count == 1 &&
           block_.tokens[node.token].kind == TokenKind::OpenAngle &&
           block_.tree.node(block_.tree.child(id, 0)).kind == NodeKind::Name;
  }

  bool is_hat(NodeId id) const {
    const Node& node = block_.tree.node(id);
    if (node.kind != NodeKind::Name || !names_.by_node[id.value].valid()) return false;
    if (block_.tokens[node.first_token].kind != TokenKind::Vec) return false;
    const std::string_view decoration = block_.token_text(node.first_token);
    return decoration == "\\hat" || decoration == "\\widehat";
  }

  void read_hat(NodeId id) {
    Name hat = read_name(block_, id);
    hat.is_hat_apart = true;
    const NameId apart = table_.intern(canonical_form(hat));
    if (hats_apart_.contains(name(id)) || block_.begins_own_name(block_.tree.node(id).first_token)) {
      name(id) = apart;
    } else if (!is_defined(id)) {
      names_.possible.push_back({id, apart});
    }
  }

  bool is_defined(NodeId id) const {
    return std::ranges::binary_search(block_.definitions, id, {}, &DefinitionSyntax::name);
  }

  /// A definition of one that mentions the other would be circular if they were one name.
  void find_hats_apart() {
    std::set<NameId> hats;
    std::set<NameId> others;
    for (uint32_t i = 0; i < block_.definitions.size(); ++i) {
      const NodeId defined = block_.definitions[i].name;
      const bool defines_hat = is_hat(defined);
      (defines_hat ? hats : others).insert(name(defined));
      for (NodeId id{defined.value + 1}; id <= block_.last_node(i); ++id.value) {
        if (name(id) == name(defined) && is_hat(id) != defines_hat) hats_apart_.insert(name(id));
      }
    }
    std::ranges::set_intersection(hats, others, std::inserter(hats_apart_, hats_apart_.end()));
  }

  const ParsedBlock& block_;
  NameTable& table_;
  BlockNames& names_;
  std::set<NameId> hats_apart_;
};

/// Most blocks hold nothing of that kind.
bool may_hold_some(const ParsedBlock& block) {
  return std::ranges::any_of(block.tokens, [&](const Token& token) {
    return token.kind == TokenKind::OpenAngle ||
           (token.kind == TokenKind::Vec && block.slice(token.span).ends_with("hat"));
  });
}

}  // namespace

void read_possible_names(const ParsedBlock& block, NameTable& table, BlockNames& names) {
  if (may_hold_some(block)) PossibleNameReader(block, table, names).run();
}

std::vector<uint32_t> find_own_names(const ParsedBlock& block, const BlockNames& names, const KnownNames& known) {
  std::vector<uint32_t> tokens;
  for (const PossibleName& possible : names.possible) {
    if (known.kind(possible.name) != NameKind::Absent) tokens.push_back(block.tree.node(possible.node).first_token);
  }
  std::ranges::sort(tokens);
  return tokens;
}

}  // namespace texbrdf
