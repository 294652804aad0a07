#include "analysis/analysed_block.h"

#include <algorithm>
#include <utility>

#include "semantics/background.h"
#include "semantics/check.h"

namespace texbrdf {

bool AnalysedBlock::is_same(std::string_view text, const BlockExtent& extent) const {
  BlockExtent own = parsed.extent;
  own.whole = extent.whole;
  return parsed.text == text && own == extent;
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
}

void add_definition(const DefinitionSyntax& syntax, AnalysedBlock& block) {
  const SmallNameMap mentioned = mentioned_names(block.parsed, syntax, block.names);
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

}  // namespace

AnalysedBlock analyse_block(std::string_view text, const BlockExtent& extent, NameTable& table,
                            std::pmr::memory_resource* memory, std::pmr::memory_resource* dense,
                            std::span<const uint32_t> factors) {
  AnalysedBlock block(memory, dense);
  block.parsed = parse_block(text, extent, memory, factors);
  block.directives = directives_above(block.parsed.text, extent);
  if (is_ignored(block.directives)) {
    block.parsed.definitions.clear();
    block.parsed.diagnostics.clear();
  }
  block.names = read_names(block.parsed, table, memory);
  leave_out_background(block.parsed, block.names, table);
  block.definitions.reserve(block.parsed.definitions.size());
  block.places.reserve(std::ranges::count_if(block.names.by_node, &NameId::valid));
  for (const DefinitionSyntax& definition : block.parsed.definitions) add_definition(definition, block);
  return block;
}

}  // namespace texbrdf
