#include "syntax/parsed_block.h"

#include "syntax/lexer.h"
#include "syntax/parser.h"

namespace texbrdf {
namespace {

Location at_begin(const ParsedBlock& block) {
  return {FileId{}, BlockId{}, block.extent.begin};
}

std::string_view environment_of(const ParsedBlock& block) {
  const std::string_view mark = block.slice(block.extent.begin);
  const size_t open = mark.find('{') + 1;
  return mark.substr(open, mark.find('}', open) - open);
}

bool has_columns(const ParsedBlock& block) {
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
  return std::string(block.slice(block.extent.begin));
}

std::string end_of_block(const ParsedBlock& block) {
  if (block.extent.region != MathRegion::Environment) return std::string(closer_of(block.extent.region));
  return "\\end{" + std::string(environment_of(block)) + "}";
}

ParsedBlock parse_block(std::string_view text, const BlockExtent& extent, std::pmr::memory_resource* memory,
                        std::span<const uint32_t> factors) {
  ParsedBlock block(memory);
  block.factors.assign(factors.begin(), factors.end());
  block.text = text;
  block.extent = extent;
  const bool closed = extent.ended_by == BlockEnd::Closed;
  if (text.size() > kMaxBlockBytes) {
    block.tokens.push_back({.kind = TokenKind::End, .span = extent.end});
    if (closed) {
      block.diagnostics.push_back(
          make_diagnostic(Code::BlockTooLong, at_begin(block), {std::to_string(kMaxBlockBytes)}));
    }
  } else {
    LexedContent content = lex(block.text, extent.content, has_columns(block), extent.end, memory);
    block.tokens = std::move(content.tokens);
    block.comments = std::move(content.comments);
    Parser(block, !closed).run();
  }
  if (!closed) report_missing_end(block);
  return block;
}

}  // namespace texbrdf
