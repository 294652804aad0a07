#include "syntax/print_source.h"

#include "source/characters.h"
#include "syntax/control_words.h"
#include "syntax/relations.h"

namespace texbrdf {
namespace {

/// `\cos` and the like, of which a letter behind it would become part.
bool ends_with_command(std::string_view text) {
  size_t letters = text.size();
  while (letters > 0 && is_letter(text[letters - 1])) --letters;
  return letters < text.size() && letters > 0 && text[letters - 1] == '\\';
}

class SourcePrinter {
 public:
  explicit SourcePrinter(const ParsedBlock& block) : block_(block), tree_(block.tree) {}

  void print(NodeId id) {
    const Node& node = tree_.node(id);
    switch (node.kind) {
      case NodeKind::Number:
      case NodeKind::Name:
      case NodeKind::Error:
        return print_tokens(node.first_token, node.end_token);
      case NodeKind::Group:
        return print(child(id, 0));
      case NodeKind::Tuple:
        write("(");
        print_list(id, 0);
        return write(")");
      case NodeKind::Matrix:
        return print_rows(id, "pmatrix");
      case NodeKind::MatrixRow:
        return print_row(id);
      case NodeKind::Prefix:
        write("(");
        write(operator_text(node.token));
        print(child(id, 0));
        return write(")");
      case NodeKind::Infix:
      case NodeKind::Definition:
        return print_infix(id);
      case NodeKind::Fraction:
        return print_pair(id, "/");
      case NodeKind::Juxtaposition:
        return print_pair(id, "*");
      case NodeKind::Root:
        return print_root(id);
      case NodeKind::Function:
        return print_function(id);
      case NodeKind::Extremum:
        write_command(node.token);
        write("(");
        print_list(id, 0);
        return write(")");
      case NodeKind::Degrees:
        write("(");
        print(child(id, 0));
        return write("^\\circ)");
      case NodeKind::Inverse:
        write("\\");
        write(command_spelling(inverse_of(block_.tokens[node.token].command)));
        write("(");
        print(child(id, 0));
        return write(")");
      case NodeKind::BigOperator:
        return print_big_operator(id);
      case NodeKind::Integral:
        return print_integral(id);
      case NodeKind::Derivative:
        return print_derivative(id);
      case NodeKind::Range:
        return;
      case NodeKind::Set:
        write("\\{");
        print_list(id, 0);
        return write("\\}");
      case NodeKind::Domain:
        return print_tokens(node.first_token, node.end_token);
      case NodeKind::Differential:
        return write("1");
      case NodeKind::Apply:
      case NodeKind::Signature:
        print(child(id, 0));
        write("(");
        print_list(id, 1);
        return write(")");
      case NodeKind::VectorLiteral:
        return print_vector(id);
      case NodeKind::Bars:
        return print_bars(id);
      case NodeKind::Angles:
        write("\\langle");
        print_list(id, 0);
        return write("\\rangle");
      case NodeKind::Cases:
        return print_rows(id, "cases");
      case NodeKind::Case:
        return print_case(id);
      case NodeKind::Comparison:
        return print_comparison(id);
      case NodeKind::Membership:
        return print_membership(id);
      case NodeKind::Junction:
        return print_pair(id, is_conjunction(block_, id) ? "\\land" : "\\lor");
      case NodeKind::Not:
        write("(\\neg");
        print(child(id, 0));
        return write(")");
    }
  }

  std::string result() { return std::move(out_); }

 private:
  NodeId child(NodeId id, uint32_t index) const { return tree_.child(id, index); }

  void write(std::string_view piece) {
    if (!piece.empty() && is_letter(piece.front()) && ends_with_command(out_)) out_ += ' ';
    out_ += piece;
  }

  std::string_view operator_text(uint32_t token) const {
    const Token& op = block_.tokens[token];
    return op.kind == TokenKind::Multiply ? "*" : block_.token_text(token);
  }

  void print_tokens(uint32_t first, uint32_t end) {
    for (uint32_t token = first; token < end; ++token) {
      if (!is_layout(block_.tokens[token].kind)) write(block_.token_text(token));
    }
  }

  void print_infix(NodeId id) {
    const Node& node = tree_.node(id);
    if (node.kind == NodeKind::Infix) return print_pair(id, operator_text(node.token));
    print(child(id, 0));
    write("=");
    print(child(id, 1));
  }

  void print_pair(NodeId id, std::string_view between) {
    write("(");
    print(child(id, 0));
    write(between);
    print(child(id, 1));
    write(")");
  }

  void print_list(NodeId id, uint32_t first) {
    const uint32_t count = tree_.node(id).child_count;
    for (uint32_t i = first; i < count; ++i) {
      if (i > first) write(",");
      print(child(id, i));
    }
  }

  void write_command(uint32_t token) {
    write("\\");
    write(command_spelling(block_.tokens[token].command));
  }

  void print_function(NodeId id) {
    write_command(tree_.node(id).token);
    if (tree_.node(id).child_count > 1) {
      write("_");
      print_braced(child(id, 1));
    }
    write("(");
    print(child(id, 0));
    write(")");
  }

  void print_braced(NodeId id) {
    write("{");
    print(id);
    write("}");
  }

  /// `(\sum_{k=1}^{N}body)`
  void print_big_operator(NodeId id) {
    const NodeId range = child(id, 1);
    write("(");
    write(block_.token_text(tree_.node(id).token));
    write("_{");
    print(child(id, 0));
    if (tree_.node(range).kind == NodeKind::Set) {
      write("\\in");
      print(range);
      write("}");
    } else {
      write("=");
      print(child(range, 0));
      write("}^");
      print_braced(child(range, 1));
    }
    print(child(id, 2));
    write(")");
  }

  /// `(\int_{a}^{b}dx\,body)`: a differential in a fraction has become a factor 1.
  void print_integral(NodeId id) {
    const NodeId range = child(id, 0);
    write("(");
    write("\\int_");
    if (tree_.node(range).kind == NodeKind::Range) {
      print_braced(child(range, 0));
      write("^");
      print_braced(child(range, 1));
    } else {
      const bool is_group = block_.token_text(tree_.node(range).first_token) == "{";
      if (is_group) print(range);
      if (!is_group) print_braced(range);
    }
    write("d ");
    print(child(id, 2));
    write("\\,");
    write("(");
    print(child(id, 1));
    write("))");
  }

  void print_power(NodeId exponent) {
    write("^");
    print(exponent);
  }

  void print_derivative(NodeId id) {
    const bool is_repeated = tree_.node(id).child_count > 2;
    write("(\\frac{d");
    if (is_repeated) print_power(child(id, 2));
    write("}{d ");
    print(child(id, 1));
    if (is_repeated) print_power(child(id, 2));
    write("}(");
    print(child(id, 0));
    write("))");
  }

  void print_bars(NodeId id) {
    NodeId inner = child(id, 0);
    while (tree_.node(inner).kind == NodeKind::Group) inner = child(inner, 0);
    const bool is_nested = tree_.node(inner).kind == NodeKind::Bars;
    write(is_nested ? "|(" : "|");
    print(inner);
    write(is_nested ? ")|" : "|");
  }

  void print_rows(NodeId id, std::string_view environment) {
    write("\\begin{");
    write(environment);
    write("}");
    const std::span<const NodeId> rows = tree_.children(id);
    for (size_t i = 0; i < rows.size(); ++i) {
      if (i > 0) write("\\\\");
      print(rows[i]);
    }
    write("\\end{");
    write(environment);
    write("}");
  }

  void print_row(NodeId id) {
    for (uint32_t i = 0; i < tree_.node(id).child_count; ++i) {
      if (i > 0) write("&");
      print(child(id, i));
    }
  }

  void print_case(NodeId id) {
    print(child(id, 0));
    write("&");
    if (tree_.node(id).child_count == 1) return write("\\text{otherwise}");
    print(child(id, 1));
  }

  void print_comparison(NodeId id) {
    write("(");
    for (uint32_t i = 0; i < tree_.node(id).child_count; ++i) {
      if (i > 0) write(block_.token_text(relation_token(block_, id, i - 1)));
      print(child(id, i));
    }
    write(")");
  }

  void print_membership(NodeId id) {
    const Node& node = tree_.node(id);
    write("(");
    print(child(id, 0));
    write("\\in");
    write(block_.token_text(node.token));
    print(child(id, 1));
    write(",");
    print(child(id, 2));
    write(block_.token_text(node.end_token - 1));
    write(")");
  }

  void print_root(NodeId id) {
    write("\\sqrt");
    if (tree_.node(id).child_count > 1) {
      write("[");
      print(child(id, 1));
      write("]");
    }
    write("(");
    print(child(id, 0));
    write(")");
  }

  /// Only numbers and their signs may stand in a literal, no parentheses.
  void print_vector(NodeId id) {
    write("\\vec{");
    const std::span<const NodeId> elements = tree_.children(id);
    for (size_t i = 0; i < elements.size(); ++i) {
      if (i > 0) write(",");
      print_tokens(tree_.node(elements[i]).first_token, tree_.node(elements[i]).end_token);
    }
    write("}");
  }

  const ParsedBlock& block_;
  const SyntaxTree& tree_;
  std::string out_;
};

}  // namespace

std::string print_source(const ParsedBlock& block, const DefinitionSyntax& definition) {
  SourcePrinter printer(block);
  printer.print(definition.node);
  return printer.result();
}

}  // namespace texbrdf
