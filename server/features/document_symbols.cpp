#include "features/document_symbols.h"

#include "features/places.h"

namespace texbrdf::features {
namespace {

Symbol parameter_symbol(const Snapshot& snapshot, BlockId block, const CheckedParameter& parameter) {
  const Span span = node_span(snapshot, block, parameter.node);
  return {snapshot.names().text(parameter.name),
          std::string(type_symbol(parameter.type)),
          SymbolKind::Parameter,
          span,
          span,
          {}};
}

Symbol definition_symbol(const Snapshot& snapshot, DefinitionId id) {
  const Definition& definition = snapshot.definition(id);
  const Signature& signature = definition.checked->signature;
  Symbol symbol{snapshot.names().text(definition.name),
                signature_text(signature),
                signature.is_function ? SymbolKind::Function : SymbolKind::Variable,
                definition_span(snapshot, id),
                name_span(snapshot, id),
                {}};
  for (const CheckedParameter& parameter : definition.checked->parameters) {
    symbol.children.push_back(parameter_symbol(snapshot, definition.block, parameter));
  }
  return symbol;
}

}  // namespace

std::vector<Symbol> document_symbols(const Snapshot& snapshot) {
  const auto count = static_cast<uint32_t>(snapshot.definitions().size());
  std::vector<Symbol> symbols;
  symbols.reserve(count);
  for (uint32_t i = 0; i < count; ++i) symbols.push_back(definition_symbol(snapshot, DefinitionId{i}));
  return symbols;
}

}  // namespace texbrdf::features
