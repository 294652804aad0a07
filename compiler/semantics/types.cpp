#include "semantics/types.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texbrdf {
namespace {

struct TypeEntry {
  std::string_view symbol;
  Shape shape;
};

constexpr auto kTypes = std::to_array<TypeEntry>({
#define TYPE(name, symbol, rows, columns) {symbol, {rows, columns}},
#include "semantics/types.def"
#undef TYPE
});

}  // namespace

std::string_view type_symbol(Type type) {
  return kTypes[static_cast<size_t>(type)].symbol;
}

Shape type_shape(Type type) {
  return kTypes[static_cast<size_t>(type)].shape;
}

std::optional<Type> type_of_shape(Shape shape) {
  if (shape == Shape{1, 1}) return Type::Real;
  for (size_t i = static_cast<size_t>(Type::Tuple); i < kTypes.size(); ++i) {
    if (kTypes[i].shape == shape) return static_cast<Type>(i);
  }
  return std::nullopt;
}

uint32_t type_components(Type type) {
  return type_shape(type).entries();
}

std::string type_word(Type type) {
  constexpr std::string_view kReals = "ℝ";
  constexpr auto kSuperscripts =
      std::to_array<std::pair<std::string_view, char>>({{"²", '2'}, {"³", '3'}, {"⁴", '4'}, {"ˣ", 'x'}});
  std::string_view symbol = type_symbol(type);
  symbol = symbol.substr(0, symbol.find('/'));
  std::string word;
  if (!symbol.starts_with(kReals)) {
    for (const char c : symbol) word += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return word;
  }
  for (symbol.remove_prefix(kReals.size()); !symbol.empty();) {
    const auto found = std::ranges::find_if(kSuperscripts, [&](const auto& s) { return symbol.starts_with(s.first); });
    if (found == kSuperscripts.end()) break;
    word += found->second;
    symbol.remove_prefix(found->first.size());
  }
  if (word.empty()) return "real";
  return (word.find('x') == std::string::npos ? "vec" : "mat") + word;
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
  return !signature.is_function || (!signature.has_implied_parameters && signature.parameters.size() == 2 &&
                                    std::ranges::all_of(signature.parameters, is_triple));
}

}  // namespace texbrdf
