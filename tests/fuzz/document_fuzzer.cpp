// From any bytes to generated code and numbers: there is always an answer, and what is linked can be emitted and
// evaluated.
#include <cstdint>
#include <string>

#include "analysis/document.h"
#include "diagnostics/render_terminal.h"
#include "exercise.h"
#include "syntax/block_scanner.h"
#include "syntax/print_source.h"
#include "syntax/print_tree_svg.h"
#include "syntax/print_tree_text.h"

namespace {

using namespace texbrdf;

constexpr std::size_t kMaxInput = 1 << 14;
constexpr uint32_t kPlaces = 32;          // of a document, where names are looked for
constexpr std::size_t kMaxReread = 2000;  // bytes; all brackets written, a deep tree may be too deep to be read

void read_diagnostics(const Snapshot& snapshot) {
  const PlaceFinder place = [&snapshot](const Location& location) {
    return Place{"a.tex", &snapshot.text(), snapshot.absolute(location)};
  };
  for (const Diagnostic& diagnostic : snapshot.diagnostics()) {
    const Span span = snapshot.absolute(diagnostic.where);
    require(span.begin <= span.end && span.end <= snapshot.text().size(), "a diagnostic is outside the document");
    for (const ColumnUnit unit : {ColumnUnit::Utf8, ColumnUnit::Utf16, ColumnUnit::CodePoint}) {
      require(snapshot.text().offset(snapshot.text().position(span.begin, unit), unit) <= span.begin,
              "a place moves when it is written down");
    }
    require(!message(diagnostic).empty(), "a diagnostic says nothing");
    require(render_terminal(diagnostic, place, {.colour = true}).ends_with('\n'), "a message without an end");
  }
}

/// What is printed reads as the same again.
void reread(const std::string& printed) {
  if (printed.size() > kMaxReread) return;
  const std::string text = "\\begin{equation}" + printed + "\\end{equation}";
  const std::vector<BlockExtent> extents = scan_blocks(text);
  require(extents.size() == 1, "what is printed is no block");
  const ParsedBlock block = parse_block(text, extents[0]);
  require(block.definitions.size() == 1 && block.definitions[0].readable, "what is printed cannot be read");
  require(print_source(block, block.definitions[0]) == printed, "what is printed reads as something else");
}

void print_block(const ParsedBlock& block) {
  print_tokens_text(block);
  print_tree_text(block);
  for (const DefinitionSyntax& definition : block.definitions) {
    if (!definition.readable) continue;
    reread(print_source(block, definition));
    print_tree_svg({{.heading = "a", .tree = &block.tree, .root = definition.node, .label = [](NodeId) {
                       return NodeLabel{.title = "<&\x01", .subtitle = "ℝ"};
                     }}});
  }
}

/// What an editor asks.
void look_around(const Snapshot& snapshot) {
  for (uint32_t i = 0; i < kPlaces; ++i) {
    const auto occurrence = snapshot.occurrence_at(snapshot.text().size() * i / kPlaces);
    if (occurrence) require(!snapshot.occurrences_of(*occurrence).empty(), "a name occurs nowhere");
  }
}

/// The program with its parameters set from outside, as far as that is allowed.
void set_parameters(const Snapshot& snapshot, std::string_view root, const ir::Program& program) {
  for (const ir::Parameter& parameter : program.parameters) {
    ir::LinkOptions options;
    options.values[parameter.canonical] = {parameter.value[0] / 2};
    const Result<ir::Program> changed = snapshot.program(root, options);
    require(changed || parameter.type != Type::Real, "a parameter cannot be set");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size > kMaxInput) return 0;
  Document document(std::string(reinterpret_cast<const char*>(data), size));
  const Snapshot& snapshot = document.snapshot();
  read_diagnostics(snapshot);
  for (uint32_t i = 0; i < snapshot.blocks().size(); ++i) print_block(snapshot.parsed({i}));
  look_around(snapshot);
  for (uint32_t i = 0; i < snapshot.definitions().size(); ++i) {
    const Definition definition = snapshot.definition({i});
    snapshot.constant_value({i});
    require(!snapshot.equation({i}).empty(), "a definition without text");
    if (!definition.in_force) continue;
    const std::string_view name = snapshot.names().text(definition.name);
    const Result<ir::Program> program = snapshot.program(name);
    if (!program) continue;
    test::exercise(*program);
    set_parameters(snapshot, name, *program);
  }
  return 0;
}
