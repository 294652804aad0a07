#include "semantics/types.h"

#include <algorithm>
#include <array>

namespace texbrdf {
namespace {

struct TypeEntry {
  std::string_view symbol;
  uint32_t components;
};

constexpr auto kTypes = std::to_array<TypeEntry>({
#define TYPE(name, symbol, components) {symbol, components},
#include "semantics/types.def"
#undef TYPE
});

}  // namespace

std::string_view type_symbol(Type type) {
  return kTypes[static_cast<size_t>(type)].symbol;
}

uint32_t type_components(Type type) {
  return kTypes[static_cast<size_t>(type)].components;
}

std::string signature_text(const Signature& signature) {
  std::string text;
  for (Type parameter : signature.parameters) {
    if (!text.empty()) text += " × ";
    text += type_symbol(parameter);
  }
  if (signature.is_function) text += " → ";
  text += type_symbol(signature.result);
  return text;
}

bool has_brdf_parameters(const Signature& signature) {
  return !signature.is_function ||
         (signature.parameters.size() == 2 && std::ranges::all_of(signature.parameters, is_triple));
}

}  // namespace texbrdf
