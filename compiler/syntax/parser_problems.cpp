#include <algorithm>

#include "source/utf8.h"
#include "syntax/control_words.h"
#include "syntax/operators.h"
#include "syntax/parser.h"
#include "syntax/relations.h"

namespace texbrdf {
namespace {

constexpr size_t kLongestQuote = 60;

/// The text on one line, without what makes a message unreadable.
std::string quote(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!space) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
    if (line.size() > kLongestQuote) break;
  }
  if (line.size() > kLongestQuote) {
    line.resize(kLongestQuote);
    while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0) == 0x80) line.pop_back();
    if (!line.empty() && static_cast<unsigned char>(line.back()) >= 0xC0) line.pop_back();
    line += "…";
  }
  return printable(line);
}

/// The `\end{cases}` of `\begin{cases}`.
std::string end_of_environment(std::string_view begin) {
  return "\\end" + std::string(begin.substr(std::min(begin.find('{'), begin.size())));
}

std::string hexadecimal(unsigned char byte) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  return {'0', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
}

/// `text` is the opener's.
std::string closer_text(TokenKind opener, std::string_view text) {
  if (opener == TokenKind::OpenParen) return ")";
  if (opener == TokenKind::OpenSet) return "\\}";
  if (opener == TokenKind::OpenAngle) return "\\rangle";
  if (opener == TokenKind::OpenCases || opener == TokenKind::OpenMatrix) return end_of_environment(text);
  return opener == TokenKind::OpenBrace ? "}" : "]";
}

}  // namespace

bool Parser::is_silent_at(uint32_t token) const {
  if (silent_ || recovering_) return true;
  if (!brackets_are_broken_) return false;
  const bool behind_stray =
      token > 0 && std::binary_search(faults_.ignored_closers.begin(), faults_.ignored_closers.end(), token - 1);
  return behind_stray ||
         std::any_of(faults_.unclosed.begin(), faults_.unclosed.end(),
                     [token](const UnclosedBracket& b) { return b.opener < token && token <= b.reach; });
}

Diagnostic* Parser::report(Code code, uint32_t token, std::vector<std::string> arguments) {
  return report(code, token, tokens_[token].span, std::move(arguments));
}

/// The diagnostic, or nullptr where this region has been reported already.
Diagnostic* Parser::report(Code code, uint32_t token, Span where, std::vector<std::string> arguments) {
  had_error_ = true;
  const bool silent = is_silent_at(token);
  recovering_ = true;
  if (silent) return nullptr;
  return &block_.diagnostics.emplace_back(make_diagnostic(code, at_span(where), std::move(arguments)));
}

void Parser::report_square(const LeftSide& left, uint32_t equals) {
  if (silent_) return;
  const Span square = join(tokens_[left.first_token].span, tokens_[last_before(equals)].span);
  block_.diagnostics.push_back(make_diagnostic(Code::SquareDefined, at_span(square), {}));
}

void Parser::report_expected(Code code) {
  report(code, position_, {describe(position_)});
}

void Parser::report_unknown() {
  const std::string_view text = block_.token_text(position_);
  const Span span = tokens_[position_].span;
  const MacroProblem* const macro = block_.expansion ? block_.expansion->problem_at(span.begin) : nullptr;
  if (macro != nullptr) {
    report(macro->code, position_, macro->arguments);
  } else if (text.starts_with("\\begin")) {
    const size_t close = text.find('}');
    const uint32_t size = close == std::string_view::npos ? span.size() : static_cast<uint32_t>(close) + 1;
    const size_t open = std::min(text.find('{'), text.size() - 1);
    const std::string_view name = text.substr(open + 1, size - open - 2);
    report(Code::UnknownEnvironment, position_, {span.begin, span.begin + size}, {quote(name)});
  } else if (text == "\\text" || text == "\\mathrm") {
    had_error_ = true;
    // A group that is never closed is reported as such.
    if (kind_behind(position_) == TokenKind::OpenBrace) return;
    report(Code::MissingTextGroup, position_, {std::string(text)});
  } else if (!code_point_at_front(text).well_formed) {
    report(Code::InvalidUtf8, position_, {hexadecimal(static_cast<unsigned char>(text[0]))});
  } else {
    report(Code::UnknownCharacter, position_, {quote(text)});
  }
}

/// Nothing more is read: whatever follows would be as deep.
void Parser::report_too_deep(uint32_t token) {
  report(Code::TooDeep, token, {std::to_string(kMaxTreeHeight)});
  recovering_ = true;
  silent_ = true;
  skip_to_end();
}

/// Closers that close nothing are not seen any more.
void Parser::find_brackets(uint32_t begin, uint32_t end) {
  faults_ = find_bracket_faults(block_.tokens, begin, end);
  if (faults_.ignored_closers.empty()) return;
  if (mended_.empty()) mended_.assign(block_.tokens.begin(), block_.tokens.end());
  for (const uint32_t closer : faults_.ignored_closers) mended_[closer].kind = TokenKind::Ampersand;
  tokens_ = mended_.data();
}

void Parser::report_brackets() {
  brackets_are_broken_ = !faults_.unclosed.empty() || !faults_.ignored_closers.empty();
  if (!brackets_are_broken_) return;
  had_error_ = true;
  if (silent_) return;

  for (const UnclosedBracket& bracket : faults_.unclosed) {
    const Token& opener = tokens_[bracket.opener];
    const std::string closer = closer_text(opener.kind, block_.slice(opener.span));
    const Token& found = tokens_[bracket.found];
    Diagnostic& diagnostic = block_.diagnostics.emplace_back(
        make_diagnostic(Code::UnclosedBracket, at_span(opener.span), {std::string(block_.slice(opener.span))}));
    diagnostic.related.push_back(
        {at_span(found.span), "found " + describe(bracket.found) + " instead of `" + closer + "`"});
    const uint32_t behind = tokens_[bracket.found - 1].span.end;
    diagnostic.fixes.push_back({"insert `" + closer + "`", {{at_span({behind, behind}), closer}}});
  }
  for (const uint32_t closer : faults_.stray_closers) {
    const Span span = tokens_[closer].span;
    Diagnostic& diagnostic = block_.diagnostics.emplace_back(
        make_diagnostic(Code::StrayCloser, at_span(span), {std::string(block_.slice(span))}));
    diagnostic.fixes.push_back({"remove `" + diagnostic.arguments[0] + "`", {{at_span(span), ""}}});
  }
}

void Parser::report_ampersands() {
  if (silent_) return;
  for (const Token& token : block_.tokens) {
    if (token.kind != TokenKind::Ampersand) continue;
    Diagnostic& diagnostic =
        block_.diagnostics.emplace_back(make_diagnostic(Code::IgnoredAmpersand, at_span(token.span)));
    diagnostic.fixes.push_back({"remove `&`", {{at_span(token.span), ""}}});
  }
}

/// `\sqrt 42`, where TeX takes the first digit, or `4 2`.
void Parser::report_number_behind_number(const Part& left) {
  const uint32_t second = position_;
  const SyntaxTree& tree = block_.tree;
  NodeId last = left.node;
  while (tree.node(last).kind == NodeKind::Juxtaposition || tree.node(last).kind == NodeKind::Infix) {
    last = tree.child(last, 1);
  }
  const Node& node = tree.node(last);
  if (node.kind != NodeKind::Root && node.kind != NodeKind::Fraction) return report_missing_operator(second);
  const Span digit = tokens_[second - 1].span;
  const Span rest = tokens_[second].span;
  if (digit.end != rest.begin || is_silent_at(second)) return;
  const std::string number = "{" + std::string(block_.slice(join(digit, rest))) + "}";
  const std::string whole = std::string(block_.slice({tokens_[node.token].span.begin, digit.begin})) + number;
  Diagnostic& diagnostic = block_.diagnostics.emplace_back(
      make_diagnostic(Code::OneDigitArgument, at_span(rest),
                      {std::string(block_.token_text(node.token)), std::string(block_.slice(digit)), quote(whole)}));
  diagnostic.fixes.push_back({"put the number in braces", {{at_span(join(digit, rest)), number}}});
}

/// Rows multiply where the second begins with an operand.
void Parser::report_row_without_operator() {
  if (is_silent_at(position_)) return;
  uint32_t token = position_;
  while (token > 0 && is_layout(tokens_[token - 1].kind) && tokens_[token - 1].kind != TokenKind::NewRow) --token;
  if (token == 0 || tokens_[token - 1].kind != TokenKind::NewRow) return;
  const Span first = tokens_[position_].span;
  Diagnostic& diagnostic = block_.diagnostics.emplace_back(make_diagnostic(Code::RowIsFactor, at_span(first)));
  diagnostic.fixes.push_back({"insert `\\cdot`", {{at_span({first.begin, first.begin}), "\\cdot "}}});
}

void Parser::report_missing_operator(uint32_t second) {
  if (Diagnostic* diagnostic = report(Code::MissingOperator, second)) {
    const uint32_t begin = tokens_[second].span.begin;
    diagnostic->fixes.push_back({"insert `\\cdot`", {{at_span({begin, begin}), "\\cdot "}}});
  }
}

void Parser::report_no_inverse(uint32_t command, uint32_t exponent) {
  report(Code::NoInverse, exponent, {shown(command, command + 1)});
}

/// `1/4\pi`, once for all factors behind the quotient: says what is divided and how the other reading is written.
void Parser::report_factor_behind_quotient(const Part& product) {
  const SyntaxTree& tree = block_.tree;
  const bool goes_on = role_of(kind()).begins_operand || opens_bars();
  if (goes_on || is_silent_at(tree.node(product.node).token)) return;
  NodeId quotient = product.node;
  while (tree.node(quotient).kind == NodeKind::Juxtaposition) quotient = tree.child(quotient, 0);
  const Node& node = tree.node(quotient);
  if (node.kind != NodeKind::Infix || tokens_[node.token].kind != TokenKind::Divide) return;

  const Span whole = block_.span(product.node);
  const Span read = block_.span(quotient);
  const Span below = {block_.span(tree.child(quotient, 1)).begin, whole.end};
  const std::string grouped = "(" + std::string(block_.slice(read)) + ")";
  const std::string other = "(" + std::string(block_.slice(below)) + ")";
  Diagnostic& diagnostic = block_.diagnostics.emplace_back(
      make_diagnostic(Code::FactorBehindQuotient, at_span(tokens_[node.token].span),
                      {quote(grouped + std::string(block_.slice({read.end, whole.end}))),
                       quote(std::string(block_.slice({whole.begin, below.begin})) + other)}));
  diagnostic.fixes.push_back({"put the quotient in parentheses", {{at_span(read), grouped}}});
  diagnostic.fixes.push_back({"put all of it below the line", {{at_span(below), other}}});
}

void Parser::report_reading(const Part& function, const FunctionOperand& read) {
  const NodeId operand = block_.tree.child(function.node, 0);
  NodeId first = operand;
  while (block_.tree.node(first).child_count > 0) first = block_.tree.child(first, 0);
  if (read.factor == kNone) {
    if (read.power != kNone) report_power_in_function(function, read.power);
  } else if (block_.tree.node(first).kind != NodeKind::Number) {
    report_factors_in_function(function, read.factor);
  }
}

void Parser::report_bare_function(uint32_t command) {
  const std::string text(block_.token_text(command));
  const std::string_view spelling = command_spelling(tokens_[command].command);
  if (text != spelling || is_silent_at(command)) return;
  const Span span = tokens_[command].span;
  Diagnostic& diagnostic = block_.diagnostics.emplace_back(make_diagnostic(Code::BareFunction, at_span(span), {text}));
  diagnostic.fixes.push_back({"write `\\" + text + "`", {{at_span({span.begin, span.begin}), "\\"}}});
}

/// `\cos n\phi`: says how far the operand goes and how the other reading is written.
void Parser::report_factors_in_function(const Part& function, uint32_t factor) {
  if (is_silent_at(factor)) return;
  const Node& node = block_.tree.node(function.node);
  const Span operand = block_.span(block_.tree.child(function.node, 0));
  const Span whole = {tokens_[node.token].span.begin, operand.end};
  const Span value = {whole.begin, tokens_[factor - 1].span.end};
  const std::string command(block_.slice({whole.begin, operand.begin}));
  const std::string grouped_operand = command + "(" + std::string(block_.slice(operand)) + ")";
  const std::string grouped_value =
      "(" + std::string(block_.slice(value)) + ")" + std::string(block_.slice({value.end, whole.end}));
  Diagnostic& diagnostic = block_.diagnostics.emplace_back(make_diagnostic(
      Code::FactorsInFunction, at_span(tokens_[factor].span), {quote(grouped_operand), quote(grouped_value)}));
  diagnostic.fixes.push_back({"put the operand in parentheses", {{at_span(whole), grouped_operand}}});
  diagnostic.fixes.push_back({"end the operand before this", {{at_span(whole), grouped_value}}});
}

/// `\ln\alpha^2`: says how it is read and how the other reading is written.
void Parser::report_power_in_function(const Part& function, uint32_t power) {
  if (is_silent_at(power)) return;
  const Node& node = block_.tree.node(function.node);
  const Span command = tokens_[node.token].span;
  const Span operand = block_.span(block_.tree.child(function.node, 0));
  const Span value = {command.begin, tokens_[power - 1].span.end};
  const Span whole = {command.begin, operand.end};
  const std::string exponent(block_.slice({value.end, whole.end}));
  const std::string grouped_operand =
      std::string(block_.slice(command)) + "(" + std::string(block_.slice(operand)) + ")";
  const std::string grouped_value = "(" + std::string(block_.slice(value)) + ")" + exponent;
  Diagnostic& diagnostic = block_.diagnostics.emplace_back(make_diagnostic(
      Code::PowerInFunction, at_span(tokens_[power].span), {quote(grouped_operand), quote(grouped_value)}));
  diagnostic.fixes.push_back({"put the operand in parentheses", {{at_span(whole), grouped_operand}}});
  diagnostic.fixes.push_back({"raise the function's value", {{at_span(whole), grouped_value}}});
}

/// `f = 1 \text{ if } x > 0`: what follows the words is no part of the definition.
void Parser::report_unread_condition(const Statement& statement, const Statement* next) {
  const auto block_end = static_cast<uint32_t>(block_.tokens.size()) - 1;
  const uint32_t end = next == nullptr ? block_end : next->begin;
  for (uint32_t token = statement.end; token < end && !silent_; ++token) {
    if (tokens_[token].kind != TokenKind::Text) continue;
    const std::string_view words = block_.token_text(token);
    if (read_remark(words) != RemarkKind::Introduction || !starts_condition(words)) continue;
    const bool compares = next != nullptr && next->relation < next->end &&
                          tokens_[next->relation].kind == TokenKind::Relation && next->begin < next->relation;
    if (!compares && words.find('$') == std::string_view::npos) continue;
    block_.diagnostics.push_back(make_diagnostic(Code::ConditionNotRead, at_span(tokens_[token].span)));
    return;
  }
}

/// `a_{\{v,l\}} = …`
void Parser::report_several_names(NodeId name) {
  const Node& node = block_.tree.node(name);
  const auto is_set = [](const Token& token) { return token.kind == TokenKind::OpenSet; };
  if (silent_ || std::none_of(tokens_ + node.first_token, tokens_ + node.end_token, is_set)) return;
  const Span span = block_.span(name);
  block_.diagnostics.push_back(make_diagnostic(Code::SeveralNames, at_span(span), {quote(block_.slice(span))}));
}

/// `2^3^2`, once for the chain: at its last operator.
void Parser::report_power_chain(const Part& power) {
  const SyntaxTree& tree = block_.tree;
  if (power.damaged || tree.node(power.node).kind != NodeKind::Infix) return;
  const NodeId right = tree.child(power.node, 1);
  auto is_power = [&](NodeId id) {
    return tree.node(id).kind == NodeKind::Infix && tokens_[tree.node(id).token].kind == TokenKind::Caret;
  };
  if (!is_power(right) || is_power(tree.child(right, 1)) || is_silent_at(tree.node(right).token)) return;
  const Span exponent = block_.span(right);
  const Span whole = block_.span(power.node);
  const std::string grouped = "{" + std::string(block_.slice(exponent)) + "}";
  const std::string read = std::string(block_.slice({whole.begin, exponent.begin})) + grouped;
  Diagnostic& diagnostic = block_.diagnostics.emplace_back(
      make_diagnostic(Code::PowerChain, at_span(tokens_[tree.node(right).token].span), {quote(read)}));
  diagnostic.fixes.push_back({"put the exponent in braces", {{at_span(exponent), grouped}}});
}

void Parser::check_vector_elements(const Part& vector, bool& damaged) {
  const SyntaxTree& tree = block_.tree;
  const uint32_t first = tree.node(vector.node).first_token;
  const std::span<const NodeId> elements = tree.children(vector.node);
  constexpr size_t kComponents = 3;
  if (elements.size() != kComponents) {
    report(Code::VectorLength, first, block_.span(vector.node), {std::to_string(elements.size())});
    recovering_ = false;
    damaged = true;
    return;
  }
  for (NodeId element : elements) {
    const Span span = block_.span(element);
    while (tree.node(element).kind == NodeKind::Prefix) element = tree.child(element, 0);
    if (tree.node(element).kind == NodeKind::Number) continue;
    report(Code::VectorElement, first, span, {});
    recovering_ = false;
    damaged = true;
  }
}

std::string Parser::describe(uint32_t token) const {
  if (token == end_) return "the end of the equation";
  return "`" + quote(block_.token_text(token)) + "`";
}

std::string Parser::shown(uint32_t first_token, uint32_t end_token) const {
  return quote(block_.slice(join(tokens_[first_token].span, tokens_[end_token - 1].span)));
}

}  // namespace texbrdf
