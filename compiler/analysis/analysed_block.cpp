#include "analysis/analysed_block.h"

#include <algorithm>
#include <utility>

#include "semantics/background.h"
#include "semantics/check.h"
#include "syntax/math_regions.h"

namespace texbrdf {

bool AnalysedBlock::is_same(std::string_view text, const BlockExtent& extent, const MacroExpansion* expansion) const {
  BlockExtent own = parsed.source_extent();
  own.whole = extent.whole;
  if (parsed.source() != text || own != extent) return false;
  const MacroExpansion* const known = parsed.expansion.get();
  if (known == nullptr || expansion == nullptr) return known == expansion;
  return known->stands_for_same(*expansion);
}

namespace {

bool is_number(const ParsedBlock& block, NodeId value) {
  while (block.tree.node(value).kind == NodeKind::Prefix) value = block.tree.child(value, 0);
  return block.tree.node(value).kind == NodeKind::Number;
}

/// A number, or a colour or vector of numbers.
bool is_value(const ParsedBlock& block, NodeId value) {
  const NodeKind kind = block.tree.node(value).kind;
  if (kind != NodeKind::Tuple && kind != NodeKind::VectorLiteral) return is_number(block, value);
  return std::ranges::all_of(block.tree.children(value), [&](NodeId part) { return is_number(block, part); });
}

}  // namespace

Standing AnalysedBlock::standing(uint32_t definition) const {
  const DefinitionSyntax& syntax = parsed.definitions[definition];
  if (!is_inline(parsed.extent.region)) return syntax.gives_way ? Standing::Prose : Standing::Display;
  const std::string_view value = parsed.node_text(syntax.body);
  if (value == "0" || value == "1") return Standing::Limit;
  return is_value(parsed, syntax.body) ? Standing::Value : Standing::Prose;
}

namespace {

bool is_ignored(const std::vector<Directive>& directives) {
  return std::ranges::any_of(directives, [](const Directive& d) { return d.kind == Directive::Kind::Ignore; });
}

void leave_out_background(ParsedBlock& block, const BlockNames& names, const NameTable& table) {
  const auto is_left_out = [&](const DefinitionSyntax& definition) {
    return is_background(block, definition, names, table);
  };
  if (std::ranges::none_of(block.definitions, is_left_out)) return;
  const std::vector<DefinitionSyntax> all(block.definitions.begin(), block.definitions.end());
  std::vector<Diagnostic> reported = std::exchange(block.diagnostics, {});
  block.definitions.clear();
  uint32_t next = 0;
  const auto take_up_to = [&](uint32_t end) {
    for (; next < end; ++next) block.diagnostics.push_back(std::move(reported[next]));
  };
  for (DefinitionSyntax definition : all) {
    take_up_to(definition.first_diagnostic);
    if (is_left_out(definition)) {
      next = definition.end_diagnostic;
      continue;
    }
    const uint32_t count = definition.end_diagnostic - definition.first_diagnostic;
    definition.first_diagnostic = static_cast<uint32_t>(block.diagnostics.size());
    take_up_to(definition.end_diagnostic);
    definition.end_diagnostic = definition.first_diagnostic + count;
    block.definitions.push_back(definition);
  }
  take_up_to(static_cast<uint32_t>(reported.size()));
  const auto goes = [&](const Restatement& restatement) { return is_left_out(all[restatement.definition]); };
  std::erase_if(block.restatements, goes);
  for (Restatement& restatement : block.restatements) {
    const auto before = std::span(all).first(restatement.definition);
    restatement.definition -= static_cast<uint32_t>(std::ranges::count_if(before, is_left_out));
  }
}

void add_definition(const DefinitionSyntax& syntax, AnalysedBlock& block) {
  SmallNameMap mentioned = mentioned_names(block.parsed, syntax, block.names);
  if (!block.implied.empty()) {
    for (const NameId name : block.implied[block.definitions.size()]) mentioned.insert(name);
  }
  block.mentions.insert(block.mentions.end(), mentioned.names().begin(), mentioned.names().end());
  for (uint32_t node = syntax.first_node; node < syntax.node.value; ++node) {
    const NameId name = block.names.by_node[node];
    if (name.valid()) block.places.push_back({name, NodeId{node}, block.parsed.span(NodeId{node})});
  }
  block.definitions.push_back({.name = block.names.by_node[syntax.name.value],
                               .name_node = syntax.name,
                               .left = syntax.left,
                               .mentions_end = static_cast<uint32_t>(block.mentions.size()),
                               .places_end = static_cast<uint32_t>(block.places.size())});
}

/// How the other sides of chains are read depends on their names, but no definition depends on those.
void add_restatements(AnalysedBlock& block) {
  for (uint32_t i = 0; i < block.parsed.definitions.size(); ++i) {
    const uint32_t last = block.parsed.last_node(i).value;
    for (uint32_t node = block.parsed.definitions[i].node.value + 1; node <= last; ++node) {
      const NameId name = block.names.by_node[node];
      if (name.valid()) block.mentions.push_back(name);
    }
  }
  for (const PossibleName& possible : block.names.possible) block.mentions.push_back(possible.name);
}

}  // namespace

AnalysedBlock analyse_block(std::string_view text, const BlockExtent& extent, NameTable& table,
                            std::pmr::memory_resource* memory, std::pmr::memory_resource* dense,
                            std::shared_ptr<const MacroExpansion> expansion, Reading reading, ImpliedMentions implied) {
  AnalysedBlock block(memory, dense);
  block.parsed = parse_block(text, extent, memory, std::move(reading), std::move(expansion));
  block.implied = std::move(implied);
  block.directives = directives_above(block.parsed.source(), extent);
  if (is_ignored(block.directives)) {
    block.parsed.definitions.clear();
    block.parsed.restatements.clear();
    block.parsed.diagnostics.clear();
  }
  block.names = read_names(block.parsed, table, memory);
  leave_out_background(block.parsed, block.names, table);
  block.definitions.reserve(block.parsed.definitions.size());
  block.places.reserve(std::ranges::count_if(block.names.by_node, &NameId::valid));
  for (const DefinitionSyntax& definition : block.parsed.definitions) add_definition(definition, block);
  if (!block.parsed.restatements.empty()) add_restatements(block);
  return block;
}

}  // namespace texbrdf
