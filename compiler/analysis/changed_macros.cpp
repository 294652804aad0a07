#include "analysis/changed_macros.h"

#include <utility>

namespace texbrdf {
namespace {

MacroTable table_of(const SegmentSequence& segments) {
  std::vector<const MacroDefinition*> definitions;
  for (const PlacedMacro& macro : macros_of(segments)) definitions.push_back(macro.definition);
  return MacroTable(definitions);
}

}  // namespace

void update_macros(EngineState& state, TouchedBlocks& touched) {
  const MacroTable before = std::exchange(state.macros, table_of(state.segments));
  if (touched.all) return;
  const WordSet changed = state.macros.changed_since(before);
  if (changed.empty()) return;
  state.segments.visit_from(0, [&](const Segment& segment, const Segment::Measure&) {
    const bool is_read = segment.block && segment.block->analysed;
    if (!is_read || !holds_word_of(changed, segment.block->analysed->parsed.source())) return true;
    const bool is_news = touched.before.try_emplace(segment.block->label, segment.block).second;
    if (is_news) ++state.rereadings;
    return true;
  });
}

}  // namespace texbrdf
