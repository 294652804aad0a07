#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/program.h"
#include "source/result.h"

namespace texbrdf::emit {

enum class ParameterStyle : uint8_t { Constant, Uniform };

struct EmitOptions {
  ParameterStyle parameters = ParameterStyle::Constant;  ///< `disney` has its own and ignores this
};

/// Lines of generated code that a definition of the document, or a parameter, has for itself.
struct CodeLines {
  NameId name;
  uint32_t first = 0;  ///< counted from 0
  uint32_t last = 0;
  friend bool operator==(const CodeLines&, const CodeLines&) = default;
};

struct EmittedCode {
  std::string text;
  std::vector<CodeLines> lines;  ///< in order; no two have a line in common
};

/// A language that programs are compiled to; one table line each in targets.cpp.
struct Target {
  std::string_view name;       ///< as in `--target`
  std::string_view extension;  ///< ".brdf"
  std::string_view description;
  Result<EmittedCode> (*emit)(const ir::Program& program, const EmitOptions& options);
};

std::span<const Target> targets();
/// nullptr where there is none of that name.
const Target* find_target(std::string_view name);

/// The identifier that generated GLSL uses for each parameter, in the order of Program::parameters: what a host sets.
std::vector<std::string> parameter_identifiers(const ir::Program& program);

}  // namespace texbrdf::emit
