#include <fmt/core.h>

#include <memory>

#include "cli/files.h"
#include "cli/json_output.h"
#include "cli/messages.h"
#include "cli/model.h"
#include "cli/subcommands.h"
#include "syntax/print_tree_svg.h"

namespace texbrdf::cli {
namespace {

enum class Format : uint8_t { Svg, Json };

struct AstOptions {
  std::string file;
  Format format = Format::Svg;
  std::string output = "-";
};

std::string group_title(TokenKind opener) {
  if (opener == TokenKind::OpenParen) return "( )";
  return opener == TokenKind::OpenBracket ? "[ ]" : "{ }";
}

std::string node_title(const ParsedBlock& block, NodeId id) {
  const Node& node = block.tree.node(id);
  switch (node.kind) {
    case NodeKind::Number:
    case NodeKind::Name:
      return std::string(block.node_text(id));
    case NodeKind::Group:
      return group_title(block.tokens[node.token].kind);
    case NodeKind::Tuple:
      return "( , )";
    case NodeKind::Matrix:
      return "matrix";
    case NodeKind::MatrixRow:
      return "row";
    case NodeKind::Bars:
      return "| |";
    case NodeKind::Angles:
      return "⟨ ⟩";
    case NodeKind::Prefix:
    case NodeKind::Infix:
    case NodeKind::Fraction:
    case NodeKind::Root:
    case NodeKind::Function:
    case NodeKind::Inverse:
    case NodeKind::Extremum:
    case NodeKind::BigOperator:
    case NodeKind::Integral:
    case NodeKind::Derivative:
    case NodeKind::Definition:
      return std::string(block.token_text(node.token));
    case NodeKind::Apply:
    case NodeKind::Signature:
      return fmt::format("{}( )", block.node_text(block.tree.child(id, 0)));
    case NodeKind::Degrees:
      return "°";
    case NodeKind::Range:
      return "range";
    case NodeKind::Set:
      return "set";
    case NodeKind::Domain:
    case NodeKind::Differential:
      return std::string(block.node_text(id));
    case NodeKind::VectorLiteral:
      return "\\vec{ }";
    case NodeKind::Cases:
      return "{";
    case NodeKind::Case:
      return node.child_count > 1 ? "if" : "otherwise";
    case NodeKind::Membership:
      return "\\in";
    case NodeKind::Comparison:
    case NodeKind::Junction:
    case NodeKind::Not:
      return std::string(block.token_text(node.token));
    case NodeKind::Juxtaposition:
      return "side by side";
    case NodeKind::Error:
      return "error";
  }
  return {};
}

std::string tree_svg(const Snapshot& snapshot) {
  std::vector<TreeDrawing> drawings;
  for (const Definition& definition : snapshot.definitions()) {
    const ParsedBlock& block = snapshot.parsed(definition.block);
    const DefinitionSyntax& syntax = block.definitions[definition.index_in_block];
    const CheckedDefinition& checked = *definition.checked;
    const auto label = [&block, &checked, first = syntax.first_node](NodeId id) {
      return NodeLabel{node_title(block, id), std::string(type_symbol(checked.types[id.value - first]))};
    };
    drawings.push_back(
        {.heading = fmt::format("{} : {}", snapshot.names().text(definition.name), signature_text(checked.signature)),
         .tree = &block.tree,
         .root = syntax.node,
         .label = label});
  }
  return print_tree_svg(drawings);
}

/// Trees need no root, so a document without `f` is as good as any other.
std::vector<Diagnostic> diagnostics_without_root(const Snapshot& snapshot) {
  std::vector<Diagnostic> diagnostics = snapshot.diagnostics();
  std::erase_if(diagnostics, [](const Diagnostic& d) { return d.code == Code::MissingRoot; });
  return diagnostics;
}

ExitCode ast(const AstOptions& options) {
  auto read = read_document(options.file);
  if (const auto* failed = std::get_if<ExitCode>(&read)) return *failed;
  NamedDocument& named = std::get<NamedDocument>(read);
  const Snapshot& snapshot = named.document.snapshot();
  const std::vector<Diagnostic> diagnostics = diagnostics_without_root(snapshot);
  report_errors_and_warnings(snapshot, diagnostics, named.file_names);
  if (const auto failure =
          write_output(options.output, options.format == Format::Svg ? tree_svg(snapshot) : tree_json(snapshot))) {
    print_message(failure->message);
    return ExitCode::BadUsage;
  }
  return has_error(diagnostics) ? ExitCode::DocumentHasErrors : ExitCode::Fine;
}

}  // namespace

Subcommand add_ast(CLI::App& program) {
  const auto options = std::make_shared<AstOptions>();
  CLI::App* const arguments = program.add_subcommand("ast", "Draw the syntax tree of each definition, with types");
  arguments->add_option("FILE", options->file, "a LaTeX document, - for standard input")->required();
  const std::map<std::string, Format> formats{{"svg", Format::Svg}, {"json", Format::Json}};
  arguments->add_option("--format", options->format, "svg or json")
      ->transform(CLI::CheckedTransformer(formats).description(""))
      ->type_name("FORMAT");
  arguments->add_option("-o,--output", options->output, "the file to write, - for standard output")->type_name("OUT");
  return {arguments, [options] { return ast(*options); }};
}

}  // namespace texbrdf::cli
