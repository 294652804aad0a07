#include "syntax/parsed_block.h"

#include <utility>

#include "syntax/control_words.h"
#include "syntax/cut_tokens.h"
#include "syntax/lexer.h"
#include "syntax/parser.h"
#include "syntax/split_subscripts.h"

namespace texbrdf {
namespace {

Location at_begin(const ParsedBlock& block) {
  return {FileId{}, BlockId{}, block.extent.begin};
}

std::string_view environment_of(const ParsedBlock& block) {
  return environment_name(block.slice(block.extent.begin));
}

const MathShortcut& shortcut_of(const ParsedBlock& block) {
  return *find_math_shortcut(block.slice(block.extent.begin).substr(1));
}

bool has_columns(const ParsedBlock& block) {
  if (block.extent.region == MathRegion::Shortcut) return shortcut_of(block).has_columns;
  if (block.extent.region != MathRegion::Environment) return false;
  const MathEnvironment* const environment = find_math_environment(environment_of(block));
  return environment != nullptr && environment->has_columns;
}

void report_missing_end(ParsedBlock& block) {
  const std::string end = end_of_block(block);
  if (block.extent.ended_by == BlockEnd::WrongEnd) {
    const Span wrong = {block.extent.end.begin, static_cast<uint32_t>(block.text.size())};
    Diagnostic wrong_end =
        make_diagnostic(Code::WrongEnd, at_begin(block), {begin_of_block(block), std::string(block.slice(wrong))});
    wrong_end.related.push_back({{FileId{}, BlockId{}, wrong}, "closed here"});
    wrong_end.fixes.push_back({"replace by `" + end + "`", {{{FileId{}, BlockId{}, wrong}, end}}});
    block.diagnostics.push_back(std::move(wrong_end));
    return;
  }
  const uint32_t behind =
      block.tokens.size() > 1 ? block.tokens[block.tokens.size() - 2].span.end : block.extent.begin.end;
  Diagnostic missing_end = make_diagnostic(Code::MissingEnd, at_begin(block), {begin_of_block(block), end});
  missing_end.fixes.push_back({"insert `" + end + "`", {{{FileId{}, BlockId{}, {behind, behind}}, "\n" + end}}});
  block.diagnostics.push_back(std::move(missing_end));
}

}  // namespace

std::string begin_of_block(const ParsedBlock& block) {
  if (block.extent.region == MathRegion::Fence) return std::string(opener_of(MathRegion::Fence));
  return std::string(block.slice(block.extent.begin));
}

std::string end_of_block(const ParsedBlock& block) {
  switch (block.extent.region) {
    case MathRegion::Environment:
      return "\\end{" + std::string(environment_of(block)) + "}";
    case MathRegion::Shortcut:
      return "\\" + std::string(shortcut_of(block).closer);
    case MathRegion::Brackets:
    case MathRegion::DoubleDollars:
    case MathRegion::Parentheses:
    case MathRegion::Dollars:
    case MathRegion::Fence:
    case MathRegion::BacktickDollars:
      return std::string(closer_of(block.extent.region));
  }
  return {};
}

NodeId ParsedBlock::parameter_name(NodeId parameter) const {
  if (tree.node(parameter).kind == NodeKind::Name) return parameter;
  const bool is_function = tree.node(parameter).kind == NodeKind::Function;
  if (!is_function || !is_trigonometric(tokens[tree.node(parameter).token].command)) return {};
  NodeId angle = tree.child(parameter, 0);
  while (tree.node(angle).kind == NodeKind::Group) angle = tree.child(angle, 0);
  return tree.node(angle).kind == NodeKind::Name ? angle : NodeId{};
}

ParsedBlock parse_block(std::string_view text, const BlockExtent& extent, std::pmr::memory_resource* memory,
                        Reading reading, std::shared_ptr<const MacroExpansion> expansion) {
  ParsedBlock block(memory);
  block.reading = std::move(reading);
  block.expansion = std::move(expansion);
  block.text = block.expansion ? std::string_view(block.expansion->text()) : text;
  block.extent = block.expansion ? block.expansion->extent() : extent;
  const bool closed = extent.ended_by == BlockEnd::Closed;
  if (block.text.size() > kMaxBlockBytes) {
    block.tokens.push_back({.kind = TokenKind::End, .span = block.extent.end});
    if (closed) {
      block.diagnostics.push_back(
          make_diagnostic(Code::BlockTooLong, at_begin(block), {std::to_string(kMaxBlockBytes)}));
    }
  } else {
    LexedContent content = lex(block.text, block.extent.content, has_columns(block), block.extent.end, memory);
    block.tokens = std::move(content.tokens);
    if (!block.reading.cuts.empty()) cut_tokens(block.tokens, block.reading.cuts);
    block.comments = std::move(content.comments);
    split_subscripts(block.tokens);
    Parser(block, !closed).run();
  }
  if (!closed) report_missing_end(block);
  return block;
}

}  // namespace texbrdf
