#include "eval/elementary_functions.h"

#include <dlfcn.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "eval/instruction_set.h"

namespace texbrdf::eval {

namespace {

/// How SLEEF spells a variant: Sleef_ name f lanes _u10 suffix.
struct SleefVariant {
  std::string_view lanes;
  std::string_view suffix;
};

SleefVariant sleef_variant(InstructionSet set) {
  switch (set) {
    case InstructionSet::Sse2:
      return {"4", "sse2"};
    case InstructionSet::Avx2:
      return {"8", "avx2"};
    case InstructionSet::Avx512:
      return {"16", "avx512f"};
  }
  return {};
}

ElementaryFunctions scalar_functions() {
  return {
#define UNARY(Name, name) .Name = {nullptr, [](float x) { return std::name(x); }},
#define BINARY(Name, name) .Name = {nullptr, [](float x, float y) { return std::name(x, y); }},
#include "eval/elementary_functions.def"
#undef UNARY
#undef BINARY
  };
}

/// The scalar functions, with SLEEF's vector functions where all of them are found. The library stays loaded.
ElementaryFunctions with_sleef(void* library, InstructionSet set) {
  const ElementaryFunctions scalar = scalar_functions();
  if (library == nullptr) return scalar;
  ElementaryFunctions functions = scalar;
  const SleefVariant variant = sleef_variant(set);
  bool complete = true;
  const auto find = [&](std::string_view name) {
    std::string symbol = "Sleef_";
    symbol.append(name).append("f").append(variant.lanes).append("_u10").append(variant.suffix);
    void* address = dlsym(library, symbol.c_str());
    complete = complete && address != nullptr;
    return reinterpret_cast<VectorFunction>(address);
  };
#define UNARY(Name, name) functions.Name.vector = find(#name);
#define BINARY(Name, name) functions.Name.vector = find(#name);
#include "eval/elementary_functions.def"
#undef UNARY
#undef BINARY
  return complete ? functions : scalar;
}

std::array<ElementaryFunctions, kInstructionSets.size()> load_all() {
  void* library = dlopen("libsleef.so.3", RTLD_NOW | RTLD_LOCAL);
  std::array<ElementaryFunctions, kInstructionSets.size()> all{};
  for (const InstructionSet set : kInstructionSets) all[static_cast<std::size_t>(set)] = with_sleef(library, set);
  return all;
}

}  // namespace

const ElementaryFunctions& load_elementary_functions(InstructionSet set) {
  static const std::array<ElementaryFunctions, kInstructionSets.size()> all = load_all();
  return all[static_cast<std::size_t>(set)];
}

const ElementaryFunctions& scalar_elementary_functions() {
  static const ElementaryFunctions functions = scalar_functions();
  return functions;
}

}  // namespace texbrdf::eval
