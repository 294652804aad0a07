#pragma once

#include <string>
#include <utility>

#include "ir/program.h"

namespace texbrdf::test {

/// A program of one definition: a graph whose parameters are real and colours by turns.
inline ir::Program program_of_graph(ir::Graph graph, int parameters) {
  ir::Program program;
  for (int i = 0; i < parameters; ++i) {
    ir::Parameter& parameter = program.parameters.emplace_back();
    parameter.name.base = std::string(1, static_cast<char>('p' + i));
    parameter.type = i % 2 == 0 ? Type::Real : Type::Colour;
    parameter.value = {0.5, 0.25, 0.125};
  }
  ir::ProgramDefinition& root = program.definitions.emplace_back();
  root.name.base = "f";
  root.signature.result = graph.at(graph.roots[0]).type;
  root.graph = std::move(graph);
  root.equation = "f = a graph";
  return program;
}

}  // namespace texbrdf::test
