// From any bytes to generated code and numbers: there is always an answer, and what is linked can be emitted and
// evaluated.
#include <array>
#include <cstdint>
#include <string>

#include "analysis/document.h"
#include "emit/emit.h"
#include "eval/batch.h"
#include "eval/compile.h"
#include "ir/print.h"
#include "ir/validate.h"
#include "syntax/print_source.h"

namespace {

using namespace texbrdf;

constexpr std::size_t kMaxInput = 1 << 14;
constexpr uint32_t kMaxEvaluated = 20'000;  // values; more takes long and shows nothing new

/// What the printers, the positions and the fixes make of a snapshot.
void read_all(const Snapshot& snapshot) {
  for (const Diagnostic& diagnostic : snapshot.diagnostics()) {
    const Span span = snapshot.absolute(diagnostic.where);
    require(span.begin <= span.end && span.end <= snapshot.text().size(), "a diagnostic is outside the document");
    snapshot.text().position(span.begin, ColumnUnit::Utf16);
    require(!message(diagnostic).empty(), "a diagnostic says nothing");
  }
  for (const Block& block : snapshot.blocks()) {
    for (const DefinitionSyntax& definition : block.parsed->definitions) {
      if (definition.readable) print_source(*block.parsed, definition);
    }
  }
}

void evaluate(const ir::Program& program) {
  const Result<eval::CompiledModel> model = eval::compile(program);
  if (!model || model->unoptimised.size() > kMaxEvaluated) return;
  const eval::Geometry geometry{.light = {0.6, 0, 0.8}, .view = {0, -0.28, 0.96}};
  eval::ReferenceEvaluator(model->unoptimised).evaluate(geometry, model->parameters);

  const std::array<float, 9> frame = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<float, 6> directions = {0.6F, 0, 0.8F, 0, -0.28F, 0.96F};
  const auto vector = [](const float* at) { return std::array{at, at + 1, at + 2}; };
  std::array<float, 3> value{};
  eval::BatchEvaluator(model->optimised)
      .evaluate({.count = 1,
                 .light = vector(directions.data()),
                 .view = vector(directions.data() + 3),
                 .normal = vector(frame.data() + 6),
                 .tangent = vector(frame.data()),
                 .bitangent = vector(frame.data() + 3)},
                model->parameters, {&value[0], &value[1], &value[2]});
}

void emit_all(const ir::Program& program) {
  for (const emit::Target& target : emit::targets()) {
    const Result<std::string> code = target.emit(program, {.parameters = emit::ParameterStyle::Uniform});
    require(!code || !code->empty(), "a target writes nothing");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size > kMaxInput) return 0;
  Document document(std::string(reinterpret_cast<const char*>(data), size));
  const Snapshot& snapshot = document.snapshot();
  read_all(snapshot);
  for (const Definition& definition : snapshot.definitions()) {
    if (!definition.in_force) continue;
    const Result<ir::Program> program = snapshot.program(snapshot.names().text(definition.name));
    if (!program) continue;
    require(!ir::find_fault(*program), "a linked program is broken");
    ir::print_program(*program);
    evaluate(*program);
    emit_all(*program);
  }
  return 0;
}
