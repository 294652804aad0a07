#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "syntax/brackets.h"
#include "syntax/parsed_block.h"
#include "syntax/statements.h"

namespace texbrdf {

/// Parses the tokens of one block into its tree, definitions and diagnostics. It never asks what a name is: operands
/// side by side become Juxtaposition, a name followed by `(` becomes Apply unless the block says that it is a factor.
///
/// What defines nothing is passed over without a word: an inequality anywhere, anything in inline mathematics, and what
/// has no `=` beside other statements.
///
/// Recovery: after a problem everything is silent until an operator, comma or closer is read where it belongs, so a
/// damaged region is reported once. What brackets cannot be paired is known before parsing.
class Parser {
 public:
  /// A silent parser reports nothing and takes a missing operator for damage.
  Parser(ParsedBlock& block, bool silent);

  void run();

 private:
  /// A node with what its parents need to know of it.
  struct Part {
    NodeId node;
    uint32_t height = 0;
    bool damaged = false;
  };

  /// How the operand of a function was read, where a reader may see another one.
  struct FunctionOperand {
    uint32_t power = kNone;   ///< the `^` that the first factor took with it
    uint32_t factor = kNone;  ///< the first token of its second factor
  };
  static constexpr uint32_t kNone = UINT32_MAX;

  // Tokens.
  TokenKind kind() const { return kind_at(position_); }
  TokenKind kind_at(uint32_t token) const { return token >= end_ ? TokenKind::End : tokens_[token].kind; }
  bool at(TokenKind wanted) const { return kind() == wanted; }
  TokenKind kind_behind(uint32_t token) const;
  TokenKind kind_before(uint32_t token) const;
  uint32_t advance() {
    const uint32_t token = position_;
    if (position_ < end_) ++position_;
    skip_ignored();
    return token;
  }
  void skip_ignored() {
    while (is_layout(kind())) ++position_;
  }
  void skip_to_end() { position_ = end_; }
  void continue_after(uint32_t closer);

  // Nodes.
  Part leaf(NodeKind kind, uint32_t token, uint32_t end_token) {
    return {block_.tree.add(kind, token, token, end_token, {}), 0, kind == NodeKind::Error};
  }
  Part make(NodeKind kind, uint32_t token, uint32_t first_token, std::initializer_list<Part> children);
  Part make(NodeKind kind, uint32_t token, uint32_t first_token, const Part* children, size_t count);
  Part error_here();
  uint32_t first_token(const Part& part) const { return block_.tree.node(part.node).first_token; }

  // Expressions (parser.cpp).
  Part parse_expression(uint8_t min_power);
  Part parse_infix(Part left, uint8_t min_power);
  Part parse_factor_behind(Part left);
  void skip_empty_groups();
  Part parse_unknown_between(Part left);
  Part parse_operand();
  Part parse_prefix();
  Part parse_primary();
  Part parse_unknown_operand();

  // Operands (parse_operands.cpp).
  Part parse_inside(TokenKind bar = TokenKind::End);
  Part parse_group();
  enum class BarSide : uint8_t { Left, Right, Either };
  BarSide bar_side(uint32_t bar) const;
  bool opens_bars() const;
  bool is_doubled_bar(uint32_t first, uint32_t second) const;
  Part parse_bars();
  Part parse_angles();
  Part parse_function();
  Part parse_function_power();
  Part parse_function_operand(bool behind_sign, FunctionOperand& read);
  Part parse_first_factor(bool behind_sign, FunctionOperand& read);
  bool continues_function_operand() const;
  Part parse_extremum();
  Part parse_fraction();
  Part parse_root();
  Part parse_braced(uint32_t owner);
  bool at_one_letter() const { return at(TokenKind::Word) && tokens_[position_].span.size() == 1; }
  Part parse_vector_literal();
  Part parse_list(NodeKind kind, uint32_t token, uint32_t first_token, uint32_t opener);
  Part finish_list(NodeKind kind, uint32_t token, uint32_t first_token, uint32_t opener, size_t first_element);
  bool close(uint32_t opener);

  // Names (parse_names.cpp).
  Part parse_name_or_call();
  Part parse_name_leaf();
  Part parse_bare_name();
  Part name_leaf(uint32_t first, bool readable);
  bool parse_name();
  bool parse_name_base();
  bool parse_decorated_name();
  bool parse_decorated_group();
  void parse_primes();
  bool parse_subscripts();
  bool parse_subscript();
  bool parse_subscript_group();
  bool vector_literal_begins() const;
  bool decorated_group_begins() const;
  bool primes_begin() const;

  // Definitions (parse_definition.cpp).
  void parse_statement(const Statement& statement, Span stretch);
  void parse_definition(const Statement& statement);
  Part parse_left_side(const Statement& statement);
  bool defines_something(const Part& left) const;
  Part parse_right_side();
  void report_no_definition(const Part& left, const Part& right);
  void finish(const Part& left, uint32_t equals, Part right);
  void keep_what_defines(size_t definitions, size_t diagnostics);

  // Problems (parser_problems.cpp).
  Diagnostic* report(Code code, uint32_t token, std::vector<std::string> arguments = {});
  Diagnostic* report(Code code, uint32_t token, Span where, std::vector<std::string> arguments);
  void report_expected(Code code);
  void report_unknown();
  void report_too_deep(uint32_t token);
  void find_brackets(uint32_t begin, uint32_t end);
  void report_brackets();
  void report_ampersands();
  void report_missing_operator(uint32_t second);
  void report_factor_behind_quotient(const Part& product);
  void report_power_in_function(const Part& function, uint32_t power);
  void report_reading(const Part& function, const FunctionOperand& read);
  void report_factors_in_function(const Part& function, uint32_t factor);
  void report_no_inverse(uint32_t command, uint32_t exponent);
  void report_power_chain(const Part& power);
  void check_vector_elements(const Part& vector, bool& damaged);
  bool is_silent_at(uint32_t token) const;
  std::string describe(uint32_t token) const;
  std::string shown(uint32_t first_token, uint32_t end_token) const;
  static Location at_span(Span span) { return {FileId{}, BlockId{}, span}; }

  ParsedBlock& block_;
  const Token* tokens_;  ///< the block's, or `mended_`
  uint32_t end_ = 0;     ///< behind the statement: a separator, or the End token
  uint32_t position_ = 0;
  uint32_t depth_ = 0;
  TokenKind open_bar_ = TokenKind::End;  ///< the bar that is open here, in no bracket behind it
  const bool block_is_silent_;
  bool silent_ = false;
  bool recovering_ = false;
  bool had_error_ = false;
  bool brackets_are_broken_ = false;
  std::vector<Part> list_;     ///< elements of the lists that are being read, innermost last
  std::vector<Token> mended_;  ///< the tokens without closers that close nothing; empty while there are none such
  uint32_t first_node_ = 0;    ///< of the statement
  BracketFaults faults_;
};

}  // namespace texbrdf
