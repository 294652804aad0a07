#include "stages.h"

#include <array>
#include <functional>

#include "analysis/equation_text.h"
#include "emit/emit.h"
#include "ir/print.h"
#include "syntax/print_source.h"
#include "syntax/print_tree_text.h"

namespace texbrdf::test {
namespace {

std::string of_each_block(const Snapshot& snapshot, std::string (*print)(const ParsedBlock&)) {
  std::string out;
  for (const Block& block : snapshot.blocks()) {
    if (!out.empty()) out += "\n";
    out += print(*block.parsed);
  }
  return out;
}

std::string tokens(const Snapshot& snapshot) {
  return of_each_block(snapshot, print_tokens_text);
}

std::string tree(const Snapshot& snapshot) {
  return of_each_block(snapshot, print_tree_text);
}

std::string name_of(const Snapshot& snapshot, BlockId block, const CheckedParameter& parameter) {
  const bool is_name = parameter.name.valid() && parameter.function == Command::None;
  return is_name ? std::string(snapshot.names().text(parameter.name))
                 : one_line(snapshot.parsed(block), parameter.given);
}

/// `name: signature`, and how the types of parameters were decided.
std::string types(const Snapshot& snapshot) {
  std::string out;
  for (const Definition& definition : snapshot.definitions()) {
    const CheckedDefinition& checked = *definition.checked;
    out += std::string(snapshot.names().text(definition.name)) + ": " + signature_text(checked.signature);
    if (!checked.sound) out += " (in error)";
    out += "\n";
    for (const CheckedParameter& parameter : checked.parameters) {
      out += "  " + name_of(snapshot, definition.block, parameter) + ": " + std::string(type_symbol(parameter.type));
      if (parameter.inferred) out += " (inferred)";
      for (Convention shadowed : parameter.shadowed) out += ", hides " + std::string(convention_entry(shadowed).symbol);
      out += "\n";
    }
  }
  return out;
}

std::string ir_of_program(const Snapshot& snapshot) {
  Result<ir::Program> program = snapshot.program();
  return program ? ir::print_program(*program) : "no program: " + program.error() + "\n";
}

std::string emitted(const Snapshot& snapshot, std::string_view target) {
  Result<ir::Program> program = snapshot.program();
  if (!program) return "no program: " + program.error() + "\n";
  Result<emit::EmittedCode> code = emit::find_target(target)->emit(*program, {});
  return code ? code->text : "not emitted: " + code.error() + "\n";
}

std::string glsl(const Snapshot& snapshot) {
  return emitted(snapshot, "glsl");
}

std::string brdf(const Snapshot& snapshot) {
  return emitted(snapshot, "disney");
}

std::string print(const Snapshot& snapshot) {
  std::string out;
  for (const Block& block : snapshot.blocks())
    for (const DefinitionSyntax& definition : block.parsed->definitions)
      if (definition.readable) out += print_source(*block.parsed, definition) + "\n";
  return out;
}

constexpr std::array kStages{Stage{"tokens", tokens},    Stage{"tree", tree}, Stage{"types", types},
                             Stage{"ir", ir_of_program}, Stage{"glsl", glsl}, Stage{"brdf", brdf},
                             Stage{"print", print}};

}  // namespace

std::span<const Stage> stages() {
  return kStages;
}

const Stage* find_stage(std::string_view name) {
  for (const Stage& stage : kStages)
    if (stage.name == name) return &stage;
  return nullptr;
}

}  // namespace texbrdf::test
