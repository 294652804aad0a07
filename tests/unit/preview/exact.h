#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "analysis/document.h"
#include "preview/exact_model.h"
#include "support/program_of_graph.h"
#include "support/read_graph.h"

namespace texbrdf::preview {

inline std::string equation(const std::string& text) {
  return "\\begin{equation}\n" + text + "\n\\end{equation}\n";
}

template <typename... Equations>
std::string equations(const Equations&... texts) {
  return (equation(texts) + ...);
}

inline ir::Program program_of(const std::string& document) {
  Document analysed(document);
  auto program = analysed.snapshot().program("f");
  EXPECT_TRUE(program) << program.error();
  return program ? *std::move(program) : ir::Program{};
}

inline ExactModel model_of(ir::Program program) {
  auto model = ExactModel::compile(std::move(program));
  EXPECT_TRUE(model) << model.error();
  return *std::move(model);
}

/// Of the equations, of which one defines `f`.
template <typename... Equations>
ExactModel model_of_equations(const Equations&... texts) {
  return model_of(program_of(equations(texts...)));
}

/// A sum of so many ones, as a BRDF.
inline ExactModel model_of_loop(int iterations) {
  return model_of(test::program_of_graph(test::read_graph("%0: ℝ = constant 1\n"
                                                          "%1: ℝ = constant " +
                                                          std::to_string(iterations) +
                                                          "\n"
                                                          "%k: ℝ = bound k0\n"
                                                          "%b: ℝ = power %k %0\n"
                                                          "%c: ℝ = divide %b %k\n"
                                                          "%s: ℝ = sum k0 %0 %1 %c\n"
                                                          "roots %s"),
                                         0));
}

}  // namespace texbrdf::preview
