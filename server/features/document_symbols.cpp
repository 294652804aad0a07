#include "features/document_symbols.h"

#include "features/places.h"

namespace texbrdf::features {
namespace {

Symbol parameter_symbol(const Snapshot& snapshot, BlockId block, const CheckedParameter& parameter) {
  const ParsedBlock& parsed = snapshot.parsed(block);
  const Span span = parsed.in_source(parsed.span(parameter.given));
  const bool is_name = parameter.name.valid() && parameter.node == parameter.given;
  return {is_name ? snapshot.names().text(parameter.name) : parsed.node_text(parameter.given),
          std::string(type_symbol(parameter.type)),
          SymbolKind::Parameter,
          block,
          span,
          span,
          {}};
}

Symbol definition_symbol(const Snapshot& snapshot, const Definition& definition) {
  const ParsedBlock& parsed = snapshot.parsed(definition.block);
  const DefinitionSyntax& syntax = parsed.definitions[definition.index_in_block];
  const Signature& signature = definition.checked->signature;
  Symbol symbol{snapshot.names().text(definition.name),
                signature_text(signature),
                signature.is_function ? SymbolKind::Function : SymbolKind::Variable,
                definition.block,
                parsed.in_source(definition_span(parsed, syntax)),
                parsed.in_source(parsed.span(syntax.name)),
                {}};
  symbol.children.reserve(definition.checked->parameters.size());
  for (const CheckedParameter& parameter : definition.checked->parameters) {
    symbol.children.push_back(parameter_symbol(snapshot, definition.block, parameter));
  }
  return symbol;
}

}  // namespace

std::vector<Symbol> block_symbols(const Snapshot& snapshot, BlockId block) {
  const DefinitionRange definitions = snapshot.definitions_of(block);
  std::vector<Symbol> symbols;
  for (uint32_t id = definitions.first.value; id < definitions.end.value; ++id) {
    symbols.push_back(definition_symbol(snapshot, snapshot.definition(DefinitionId{id})));
  }
  return symbols;
}

std::vector<Symbol> document_symbols(const Snapshot& snapshot) {
  std::vector<Symbol> symbols;
  symbols.reserve(snapshot.definitions().size());
  for (const Definition& definition : snapshot.definitions()) {
    symbols.push_back(definition_symbol(snapshot, definition));
  }
  return symbols;
}

}  // namespace texbrdf::features
