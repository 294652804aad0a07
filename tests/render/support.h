#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "analysis/document.h"
#include "ir/program.h"
#include "preview/cpu_frame.h"
#include "preview/shader_model.h"
#include "render/worker_client.h"
#include "support/read_file.h"

namespace texbrdf::test {

inline const std::vector<std::string>& model_names() {
  static const std::vector<std::string> names{"ashikhmin-shirley",
                                              "ashikhmin-shirley-alternative",
                                              "blinn-phong",
                                              "conventions",
                                              "cook-torrance",
                                              "cook-torrance-alternative",
                                              "duer",
                                              "edwards-2006",
                                              "kajiya-kay",
                                              "minnaert",
                                              "oren-nayar",
                                              "ward"};
  return names;
}

/// The name of a parameterised test.
inline std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name) {
    if (c == '-') c = '_';
  }
  return name;
}

inline std::string model_path(const std::string& name, const std::string& extension) {
  return std::string(TEXBRDF_TEST_DATA) + "/models/" + name + extension;
}

inline Result<ir::Program> program_of(const std::string& text) {
  Document document(text);
  return document.snapshot().program("f");
}

/// A document of one equation, `f = …`.
inline std::string document_of(const std::string& right_side) {
  return "\\begin{equation}\nf = " + right_side + "\n\\end{equation}\n";
}

inline ir::Program model_program(const std::string& name) {
  Result<ir::Program> program = program_of(read_file(model_path(name, ".tex")));
  if (!program) ADD_FAILURE() << name << ": " << program.error();
  return program ? *std::move(program) : ir::Program{};
}

inline render::WorkerOptions worker_options(std::vector<std::string> environment = {}) {
  return {.executable = TEXBRDF_RENDER_WORKER,
          .arguments = {},
          .environment = std::move(environment),
          .deadline = std::chrono::seconds(60)};
}

/// The picture, or a failed test that says why there is none.
inline render::GpuPicture expect_picture(std::variant<render::GpuPicture, render::RenderFault> result) {
  if (const auto* fault = std::get_if<render::RenderFault>(&result)) {
    ADD_FAILURE() << fault->message;
    return {};
  }
  return std::get<render::GpuPicture>(std::move(result));
}

}  // namespace texbrdf::test
