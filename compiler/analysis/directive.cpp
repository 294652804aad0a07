#include "analysis/directive.h"

#include <algorithm>

#include "semantics/names.h"
#include "source/trimmed.h"

namespace texbrdf {
namespace {

constexpr std::string_view kMark = "texbrdf:";
constexpr std::string_view kHtmlOpener = "<!--";
constexpr std::string_view kHtmlCloser = "-->";

Directive::Kind kind_of(std::string_view word) {
  if (word == "root") return Directive::Kind::Root;
  if (word == "ignore") return Directive::Kind::Ignore;
  if (word == "allow") return Directive::Kind::Allow;
  return Directive::Kind::Unknown;
}

/// What a comment of LaTeX or of Markdown says.
std::optional<std::string_view> said_in(std::string_view comment) {
  if (comment.starts_with('%')) return trimmed(comment.substr(1));
  if (!comment.starts_with(kHtmlOpener)) return std::nullopt;
  const std::string_view inside = comment.substr(kHtmlOpener.size());
  return trimmed(inside.substr(0, inside.find(kHtmlCloser)));
}

}  // namespace

std::string root_of(const Directive& directive) {
  return canonical_name(directive.argument).value_or(directive.argument);
}

std::optional<Directive> read_directive(std::string_view comment, Span span) {
  const std::optional<std::string_view> said = said_in(comment);
  if (!said || !said->starts_with(kMark)) return std::nullopt;
  std::string_view rest = trimmed(said->substr(kMark.size()));
  const size_t word_end = std::min(rest.find_first_of(" \t="), rest.size());
  std::string_view argument = trimmed(rest.substr(word_end));
  if (argument.starts_with('=')) argument = trimmed(argument.substr(1));
  const auto at = span.begin + static_cast<uint32_t>(argument.data() - comment.data());
  Directive directive{kind_of(rest.substr(0, word_end)), std::string(argument), span, {at, at}};
  directive.argument_span.end += static_cast<uint32_t>(argument.size());
  const bool needs_argument = directive.kind == Directive::Kind::Root || directive.kind == Directive::Kind::Allow;
  if (needs_argument == argument.empty()) directive.kind = Directive::Kind::Unknown;
  return directive;
}

std::vector<Directive> directives_above(std::string_view block_text, const BlockExtent& extent) {
  std::vector<Directive> directives;
  for (uint32_t at = 0; at < extent.begin.begin;) {
    const auto end = static_cast<uint32_t>(std::min<size_t>(block_text.find_first_of("\r\n", at), extent.begin.begin));
    const std::string_view line = block_text.substr(at, end - at);
    const size_t comment = std::min({line.find('%'), line.find(kHtmlOpener), line.size()});
    const uint32_t mark = at + static_cast<uint32_t>(comment);
    if (auto directive = read_directive(block_text.substr(mark, end - mark), {mark, end})) {
      directives.push_back(std::move(*directive));
    }
    at = end + 1;
  }
  return directives;
}

}  // namespace texbrdf
