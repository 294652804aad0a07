#include "features/define_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "features/demand.h"
#include "semantics/name_traits.h"

namespace texbrdf::features {
namespace {

/// How a block is laid out, to write another like it.
class Layout {
 public:
  explicit Layout(const ParsedBlock& block) : block_(block) {
    newline_ = block.text.find("\r\n") != std::string::npos ? "\r\n" : "\n";
    if (block.extent.ended_by == BlockEnd::Closed) outer_ = blank_before(block.extent.end.begin).value_or("");
    inner_ = blank_before(block.tokens.front().span.begin).value_or(outer_ + "  ");
  }

  std::string above(std::string_view equation) const { return block_with(equation) + newline_ + outer_; }
  std::string below(std::string_view equation) const { return newline_ + outer_ + block_with(equation); }

 private:
  std::string block_with(std::string_view equation) const {
    return fmt::format("{1}{0}{2}{3}{0}{4}{5}", newline_, begin_of_block(block_), inner_, equation, outer_,
                       end_of_block(block_));
  }

  /// What stands between the line's start and the offset, where that is white space within the block.
  std::optional<std::string> blank_before(uint32_t offset) const {
    const std::string_view before = block_.slice({0, offset});
    const std::size_t line = before.find_last_of("\r\n");
    if (line == std::string_view::npos) return std::nullopt;
    const std::string_view blank = before.substr(line + 1);
    if (blank.find_first_not_of(" \t") != std::string_view::npos) return std::nullopt;
    return std::string(blank);
  }

  const ParsedBlock& block_;
  std::string newline_;
  std::string outer_;
  std::string inner_;
};

/// Where a name is missing, and what has to be known of it to define it.
class MissingName {
 public:
  MissingName(const Snapshot& snapshot, BlockId block, NodeId node)
      : snapshot_(snapshot), block_(block), parsed_(snapshot.parsed(block)), node_(node) {}

  /// `q`, or `q(x, \vec{n})` where it is called; nothing where it cannot be read what it is.
  std::optional<std::string> left_side() {
    std::string left(parsed_.node_text(node_));
    const TokenKind behind = parsed_.tokens[parsed_.tree.node(node_).end_token].kind;
    if (behind == TokenKind::OpenBrace) return std::nullopt;
    if (behind != TokenKind::OpenParen) return left;
    const auto call = parent_of(node_, NodeKind::Apply);
    if (!call) return std::nullopt;
    std::vector<std::string> parameters;
    for (const NodeId argument : parsed_.tree.children(*call).subspan(1)) {
      parameters.push_back(parameter(argument, parameters));
      left += fmt::format("{}{}", parameters.size() == 1 ? "(" : ", ", parameters.back());
    }
    return left + ")";
  }

  std::string_view value() const {
    if (is_vector_name(node_)) return "\\vec{1, 1, 1}";
    const Type type = demanded();
    if (type == Type::Vector) return "\\vec{1, 1, 1}";
    return is_triple(type) ? "(1, 1, 1)" : "1";
  }

 private:
  /// Named as the argument where that is a name of its own.
  std::string parameter(NodeId argument, const std::vector<std::string>& others) const {
    while (parsed_.tree.node(argument).kind == NodeKind::Group) argument = parsed_.tree.child(argument, 0);
    std::string name = fmt::format("x_{}", others.size() + 1);
    const bool is_vector = type_of(argument) == Type::Vector;
    const bool is_name = parsed_.tree.node(argument).kind == NodeKind::Name;
    if (is_name) {
      const std::string written(parsed_.node_text(argument));
      const bool fits = is_vector || !is_vector_name(argument);
      if (fits && std::ranges::find(others, written) == others.end()) {
        name = written;
        if (is_vector_name(argument)) return name;
      }
    }
    return is_vector ? fmt::format("\\vec{{{}}}", name) : name;
  }

  bool is_vector_name(NodeId node) const {
    const NameId name = snapshot_.names_of(block_).by_node[node.value];
    return name.valid() && snapshot_.names().traits(name).is_vector;
  }

  /// From what stands in front, else from the other side of a sum.
  Type demanded() const {
    const uint32_t token = parsed_.tree.node(node_).first_token;
    if (const auto type = demanded_type(snapshot_, block_, token, open_brackets(parsed_, token))) return *type;
    const NodeId operand = parent_of(node_, NodeKind::Apply).value_or(node_);
    const auto sum = parent_of(operand, NodeKind::Infix);
    if (!sum) return Type::Error;
    const TokenKind op = parsed_.tokens[parsed_.tree.node(*sum).token].kind;
    const bool is_sum = op == TokenKind::Plus || op == TokenKind::Minus;
    return is_sum ? type_of(parsed_.tree.child(*sum, 1)) : Type::Error;
  }

  /// The node of which this one is the first child.
  std::optional<NodeId> parent_of(NodeId child, NodeKind kind) const {
    for (uint32_t node = child.value + 1; node < parsed_.tree.size(); ++node) {
      const Node& candidate = parsed_.tree.node(NodeId{node});
      const bool is_parent = candidate.child_count > 0 && parsed_.tree.child(NodeId{node}, 0) == child;
      if (is_parent) return candidate.kind == kind ? std::optional(NodeId{node}) : std::nullopt;
    }
    return std::nullopt;
  }

  Type type_of(NodeId node) const {
    const DefinitionRange definitions = snapshot_.definitions_of(block_);
    for (uint32_t id = definitions.first.value; id < definitions.end.value; ++id) {
      const DefinitionSyntax& syntax = snapshot_.syntax(DefinitionId{id});
      if (node.value < syntax.first_node || node.value > syntax.node.value) continue;
      const Definition& definition = snapshot_.definition(DefinitionId{id});
      return definition.checked->types[node.value - syntax.first_node];
    }
    return Type::Error;
  }

  const Snapshot& snapshot_;
  BlockId block_;
  const ParsedBlock& parsed_;
  NodeId node_;
};

std::optional<NodeId> name_at(const ParsedBlock& block, Span span) {
  for (uint32_t node = 0; node < block.tree.size(); ++node) {
    const bool is_meant = block.tree.node(NodeId{node}).kind == NodeKind::Name && block.span(NodeId{node}) == span;
    if (is_meant) return NodeId{node};
  }
  return std::nullopt;
}

NewDefinition new_definition(std::string_view name, uint32_t offset, std::string text) {
  return {fmt::format("define `{}` in a new equation", shown_name(name)), {{offset, offset}, std::move(text)}};
}

std::optional<NewDefinition> define_above(const Snapshot& snapshot, const Location& where) {
  const ParsedBlock& block = snapshot.parsed(where.block);
  const auto node = name_at(block, where.span);
  if (!node || is_inline(block.extent.region)) return std::nullopt;
  MissingName missing(snapshot, where.block, *node);
  const auto left = missing.left_side();
  if (!left) return std::nullopt;
  const uint32_t offset = snapshot.absolute(where.block, {}).begin;
  return new_definition(*left, offset, Layout(block).above(fmt::format("{} = {}", *left, missing.value())));
}

std::optional<NewDefinition> define_below(const Snapshot& snapshot, BlockId id, std::string_view name) {
  const ParsedBlock& block = snapshot.parsed(id);
  if (block.extent.ended_by != BlockEnd::Closed || is_inline(block.extent.region)) return std::nullopt;
  const uint32_t offset = snapshot.absolute(id, {}).begin + static_cast<uint32_t>(block.source().size());
  return new_definition(name, offset, Layout(block).below(fmt::format("{} = 1", name)));
}

}  // namespace

std::optional<NewDefinition> define_missing_name(const Snapshot& snapshot, const Diagnostic& diagnostic) {
  const bool is_used = diagnostic.code == Code::UndefinedName || diagnostic.code == Code::UnknownCommand;
  if (is_used) return define_above(snapshot, diagnostic.where);
  if (diagnostic.code != Code::MissingRoot) return std::nullopt;
  return define_below(snapshot, diagnostic.where.block, diagnostic.arguments[0]);
}

}  // namespace texbrdf::features
