#include "features/places.h"

#include "analysis/equation_text.h"

namespace texbrdf::features {

Span node_span(const Snapshot& snapshot, BlockId block, NodeId node) {
  return snapshot.absolute(block, snapshot.parsed(block).span(node));
}

Span definition_span(const Snapshot& snapshot, DefinitionId id) {
  const BlockId block = snapshot.definition(id).block;
  return snapshot.absolute(block, definition_span(snapshot.parsed(block), snapshot.syntax(id)));
}

/// A definition that was broken off may have the block's \end as its last token; that is no part of what is shown.
Span definition_span(const ParsedBlock& block, const DefinitionSyntax& definition) {
  const Node& node = block.tree.node(definition.node);
  uint32_t last = node.end_token - 1;
  while (last > node.first_token && block.tokens[last].kind == TokenKind::End) --last;
  return join(block.tokens[node.first_token].span, block.tokens[last].span);
}

Span name_span(const Snapshot& snapshot, DefinitionId id) {
  return node_span(snapshot, snapshot.definition(id).block, snapshot.syntax(id).name);
}

std::optional<DefinitionId> stood_for(const Snapshot& snapshot, const Occurrence& occurrence) {
  const Referent& referent = occurrence.referent;
  if (referent.kind == Referent::Kind::Derivative) return snapshot.find(NameId{referent.index});
  if (referent.kind != Referent::Kind::Indexed) return std::nullopt;
  return snapshot.find(snapshot.definition(occurrence.inside).checked->indexed[referent.index].names[0]);
}

std::string parameter_text(const Snapshot& snapshot, BlockId block, const CheckedParameter& parameter) {
  const bool is_name = parameter.name.valid() && parameter.function == Command::None;
  if (is_name) return std::string(snapshot.names().text(parameter.name));
  return one_line(snapshot.parsed(block), parameter.given);
}

std::string line_name(const Snapshot& snapshot, uint32_t offset) {
  const FilePlace place = snapshot.place({offset, offset});
  const uint32_t line = snapshot.text(place.file).position(place.span.begin, ColumnUnit::Utf8).line + 1;
  return "line " + std::to_string(line) + (place.file == snapshot.file() ? "" : " of another file");
}

}  // namespace texbrdf::features
