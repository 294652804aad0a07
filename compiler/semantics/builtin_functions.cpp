#include "semantics/builtin_functions.h"

#include <algorithm>
#include <vector>

#include "semantics/matrix_rules.h"

namespace texbrdf {
namespace {

constexpr size_t kShortest = 2;

BuiltinEntry entry(std::string_view spellings, std::vector<Type> parameters, Type result, std::string_view meaning) {
  Signature signature{.is_function = true, .parameters = std::move(parameters), .result = result};
  for (size_t i = 0; i < signature.parameters.size(); ++i) {
    if (signature.parameters[i] == Type::Real) signature.spreads |= uint64_t{1} << i;
  }
  return {spellings, std::move(signature), meaning};
}

std::string_view word_of(std::string_view canonical) {
  constexpr std::string_view kText = "\\text{";
  if (canonical.starts_with(kText) && canonical.ends_with('}')) {
    return canonical.substr(kText.size(), canonical.size() - kText.size() - 1);
  }
  return canonical.starts_with('\\') ? canonical.substr(1) : canonical;
}

bool lists(std::string_view spellings, std::string_view word) {
  while (!spellings.empty()) {
    const size_t end = spellings.find(' ');
    if (spellings.substr(0, end) == word) return true;
    spellings = end == std::string_view::npos ? std::string_view{} : spellings.substr(end + 1);
  }
  return false;
}

}  // namespace

std::span<const BuiltinEntry> builtin_functions() {
#define PARAMETERS(...) {__VA_ARGS__}
  static const BuiltinEntry entries[] = {
#define BUILTIN(name, spellings, parameters, result, meaning) \
  entry(spellings, PARAMETERS parameters, Type::result, meaning),
#include "semantics/builtin_functions.def"
#undef BUILTIN
  };
#undef PARAMETERS
  return entries;
}

const BuiltinEntry& builtin_entry(Builtin function) {
  return builtin_functions()[static_cast<size_t>(function)];
}

Signature signature_for(Builtin function, std::span<const Type> arguments) {
  Signature signature = builtin_entry(function).signature;
  const Type general = signature.parameters[0];
  const bool has_sizes = general == Type::Matrix2x2 || (general == Type::Vector && function != Builtin::Cross);
  if (!has_sizes) return signature;
  const auto is_meant = [&](Type type) {
    return general == Type::Vector ? is_aggregate(type) && is_column(type) : is_square_matrix(type);
  };
  const auto argument = std::ranges::find_if(arguments, is_meant);
  if (argument == arguments.end()) return signature;
  std::ranges::replace(signature.parameters, general, *argument);
  if (signature.result == general) signature.result = *argument;
  return signature;
}

std::optional<Builtin> find_builtin(std::string_view canonical) {
  if (canonical == kStepFunction) return Builtin::UnitStep;
  const std::string_view word = word_of(canonical);
  if (word.size() < kShortest || word.find_first_of("_'{}") != std::string_view::npos) return std::nullopt;
  const std::span<const BuiltinEntry> entries = builtin_functions();
  for (size_t i = 0; i < entries.size(); ++i) {
    if (lists(entries[i].spellings, word)) return static_cast<Builtin>(i);
  }
  return std::nullopt;
}

}  // namespace texbrdf
