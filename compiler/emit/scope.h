#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emit/code.h"
#include "emit/namer.h"
#include "semantics/types.h"

namespace texbrdf::emit {

/// The identifiers that the leaves of a graph have in one function.
struct FunctionScope {
  Namer names;  ///< of everything visible in the function; its locals are claimed here
  std::vector<std::string> formals;
  std::vector<std::string> parameters;   ///< by index of Program::parameters
  std::vector<std::string> definitions;  ///< by index of Program::definitions: locals, or names of functions
  std::vector<std::string> conventions;  ///< by Convention; empty where the function must make it
};

/// A local with the value of one root of the graph, or the function's result.
struct BodyItem {
  Equation equation;
  std::string type;
  std::string name;     ///< empty: it is returned
  bool spread = false;  ///< a real that is returned as a grey triple
};

inline std::string_view glsl_type(Type type) {
  if (is_triple(type)) return "vec3";
  return type == Type::Boolean ? "bool" : "float";
}

}  // namespace texbrdf::emit
