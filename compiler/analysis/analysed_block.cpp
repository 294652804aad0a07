#include "analysis/analysed_block.h"

#include <algorithm>

#include "semantics/check.h"

namespace texbrdf {

bool AnalysedBlock::is_same(std::string_view text, const BlockExtent& extent) const {
  const BlockExtent& own = parsed.extent;
  return parsed.text == text && own.begin == extent.begin && own.content == extent.content && own.end == extent.end &&
         own.ended_by == extent.ended_by;
}

namespace {

bool is_ignored(const std::vector<Directive>& directives) {
  return std::ranges::any_of(directives, [](const Directive& d) { return d.kind == Directive::Kind::Ignore; });
}

}  // namespace

AnalysedBlock analyse_block(std::string_view text, const BlockExtent& extent, NameTable& table,
                            std::pmr::memory_resource* memory) {
  AnalysedBlock block(memory);
  block.parsed = parse_block(text, extent, memory);
  block.directives = directives_above(block.parsed.text, extent);
  if (is_ignored(block.directives)) {
    block.parsed.definitions.clear();
    block.parsed.diagnostics.clear();
  }
  block.names = read_names(block.parsed, table, memory);
  block.definitions.reserve(block.parsed.definitions.size());
  for (const DefinitionSyntax& definition : block.parsed.definitions) {
    const SmallNameMap mentioned = mentioned_names(block.parsed, definition, block.names);
    block.mentions.insert(block.mentions.end(), mentioned.names().begin(), mentioned.names().end());
    const NameId name = block.names.by_node[definition.name.value];
    block.definitions.push_back({name, static_cast<uint32_t>(block.mentions.size())});
  }
  return block;
}

}  // namespace texbrdf
