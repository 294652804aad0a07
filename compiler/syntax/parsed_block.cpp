#include "syntax/parsed_block.h"

#include "syntax/lexer.h"
#include "syntax/parser.h"

namespace texbrdf {
namespace {

Location at_begin(const ParsedBlock& block) {
  return {FileId{}, BlockId{}, block.extent.begin};
}

/// "equation" of `\begin{equation}`.
std::string environment_of(std::string_view mark) {
  const size_t open = mark.find('{') + 1;
  return std::string(mark.substr(open, mark.find('}', open) - open));
}

void report_missing_end(ParsedBlock& block) {
  const std::string environment = environment_of(block.slice(block.extent.begin));
  const std::string end = "\\end{" + environment + "}";
  if (block.extent.ended_by == BlockEnd::WrongEnd) {
    const Span wrong = {block.extent.end.begin, static_cast<uint32_t>(block.text.size())};
    Diagnostic wrong_end =
        make_diagnostic(Code::WrongEnd, at_begin(block), {environment, environment_of(block.slice(wrong))});
    wrong_end.related.push_back({{FileId{}, BlockId{}, wrong}, "closed here"});
    wrong_end.fixes.push_back({"replace by `" + end + "`", {{{FileId{}, BlockId{}, wrong}, end}}});
    block.diagnostics.push_back(std::move(wrong_end));
    return;
  }
  const uint32_t behind =
      block.tokens.size() > 1 ? block.tokens[block.tokens.size() - 2].span.end : block.extent.begin.end;
  Diagnostic missing_end = make_diagnostic(Code::MissingEnd, at_begin(block), {environment});
  missing_end.fixes.push_back({"insert `" + end + "`", {{{FileId{}, BlockId{}, {behind, behind}}, "\n" + end}}});
  block.diagnostics.push_back(std::move(missing_end));
}

}  // namespace

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
    LexedContent content = lex(block.text, extent.content, extent.end, memory);
    block.tokens = std::move(content.tokens);
    block.comments = std::move(content.comments);
    Parser(block, !closed).run();
  }
  if (!closed) report_missing_end(block);
  return block;
}

}  // namespace texbrdf
