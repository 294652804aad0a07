#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "syntax/brackets.h"
#include "syntax/parsed_block.h"
#include "syntax/remark.h"
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

  /// What stands before the `=`.
  struct LeftSide {
    Part part;
    uint32_t first_token = 0;   ///< of all that belongs to it
    uint32_t function = kNone;  ///< the `\cos` of `\cos\xi = …`, which defines ξ
    uint32_t square = kNone;    ///< the `^` of `g^2 = …`, which defines g
    bool is_part = false;       ///< as in Statement
  };

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
    while (is_layout(kind()) || (open_rows_ == 0 && is_cell_or_row_end(kind()))) ++position_;
  }
  static bool means_nothing_at_end(TokenKind kind) { return is_layout(kind) || is_cell_or_row_end(kind); }
  static bool is_cell_or_row_end(TokenKind kind) { return kind == TokenKind::CellEnd || kind == TokenKind::RowEnd; }
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
  bool is_positive_part(const Part& left) const;
  Part parse_positive_part(const Part& left);
  bool is_transposed(const Part& left) const;
  Part parse_transposition(const Part& left);
  Part parse_factor_behind(Part left);
  void skip_empty_groups();
  bool degrees_begin() const;
  Part parse_degrees(Part angle);
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
  bool angled_name_begins() const { return position_ == angled_name_ || block_.begins_own_name(position_); }
  Part parse_angled_name();
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

  // Operators that bind a name (parse_big_operators.cpp).
  Part parse_big_operator();
  Part parse_index_range(uint32_t command, Part& name);
  Part parse_index_set();
  Part parse_bound(uint32_t owner);
  Part parse_last(uint32_t owner);
  Part parse_integral();
  Part parse_integration_range(uint32_t command);
  Part parse_domain(uint32_t end);
  Part parse_integrand(bool is_closed, Part& variable);
  Part parse_variable();
  Part parse_differential_factor();
  struct DerivativeVariable {
    Part name;
    std::optional<Part> order = std::nullopt;
  };
  Part parse_derivative();
  DerivativeVariable parse_derivative_variable();
  Part make_derivative(uint32_t command, const Part& body, const DerivativeVariable& variable);
  uint32_t behind_script() const;
  Part needs_bound(uint32_t token, uint32_t command);
  // Matrices (parse_matrices.cpp).
  Part parse_matrix();
  std::vector<size_t> parse_matrix_cells();
  Part make_matrix(uint32_t opener, std::span<const Part> cells, std::span<const size_t> row_lengths);
  Part make_matrix_row(std::span<const Part> cells);

  // Cases and conditions (parse_cases.cpp).
  struct CaseRow {
    Part part;
    bool is_rest = false;  ///< it says so: \text{otherwise}
  };
  Part parse_cases();
  CaseRow parse_case();
  bool skip_to_condition();
  bool row_ends() const { return at(TokenKind::RowEnd) || at(TokenKind::CloseCases) || at(TokenKind::End); }
  void skip_to_row_end();
  bool close_environment(uint32_t opener);
  enum class ConditionPlace : uint8_t { Cell, Brackets };
  Part parse_condition(ConditionPlace place);
  Part parse_conjunction(ConditionPlace place);
  Part parse_negation(ConditionPlace place);
  Part parse_comparison();
  Part parse_membership(const Part& left);
  bool joins(TokenKind junction, ConditionPlace place);
  RemarkKind remark_at(uint32_t token) const;
  bool at_relation() const { return at(TokenKind::Relation) || at(TokenKind::Equals); }
  bool is_exhaustive(std::span<const CaseRow> rows) const;
  void check_rows(uint32_t opener, std::span<const CaseRow> rows);

  // Names (parse_names.cpp).
  Part parse_name_or_call();
  Part parse_call(const Part& name);
  Part parse_power_of_call(const Part& name);
  Part parse_name_leaf();
  Part parse_bare_name();
  Part name_leaf(uint32_t first, bool readable);
  bool parse_name();
  bool parse_name_base();
  void parse_label();
  bool parse_decorated_name();
  bool parse_decorated_group();
  void parse_primes();
  bool parse_subscripts();
  bool parse_subscript();
  bool parse_subscript_group();
  bool vector_literal_begins() const;
  bool decorated_group_begins() const;
  bool primes_begin() const;
  uint32_t behind_plus(uint32_t caret) const;
  void parse_plus(uint32_t base);

  // Definitions (parse_definition.cpp).
  void parse_statement(const Statement& statement, const Statement* next, Span stretch);
  void parse_definition(const Statement& statement);
  void parse_restatements(const Statement& statement);
  bool is_equality(uint32_t relation) const;
  std::optional<Statement> angle_in_chain(const Statement& statement);
  uint32_t behind_repeated_left_side(const Statement& statement);
  Part parse_right_side();
  bool is_number(const Part& part) const;
  void report_no_definition(const Part& left, const Part& right);
  void finish(const LeftSide& left, uint32_t equals, Part right);
  void keep_what_defines(size_t definitions, size_t diagnostics);

  // Left sides (parse_left_side.cpp).
  LeftSide parse_left_side(const Statement& statement);
  void finish_left_side(const Statement& statement, Part& left);
  uint32_t enter_brackets(TokenKind opener, uint32_t& end);
  bool function_of_name_begins(uint32_t end) const;
  uint32_t square_of_name(uint32_t end) const;
  bool name_in_angles_begins(uint32_t end) const;
  uint32_t closer_behind(uint32_t opener, uint32_t end) const;
  uint32_t last_before(uint32_t token) const;
  bool defines_something(const Part& left) const;
  bool is_parameter(NodeId parameter) const;

  // Problems (parser_problems.cpp).
  Diagnostic* report(Code code, uint32_t token, std::vector<std::string> arguments = {});
  Diagnostic* report(Code code, uint32_t token, Span where, std::vector<std::string> arguments);
  void report_expected(Code code);
  void report_unknown();
  void report_too_deep(uint32_t token);
  void find_brackets(uint32_t begin, uint32_t end);
  void report_brackets();
  void report_ampersands();
  void report_square(const LeftSide& left, uint32_t equals);
  void report_number_behind_number(const Part& left);
  void report_missing_operator(uint32_t second);
  void report_row_without_operator();
  void report_factor_behind_quotient(const Part& product);
  void report_power_in_function(const Part& function, uint32_t power);
  void report_bare_function(uint32_t command);
  void report_reading(const Part& function, const FunctionOperand& read);
  void report_factors_in_function(const Part& function, uint32_t factor);
  void report_no_inverse(uint32_t command, uint32_t exponent);
  void report_unread_condition(const Statement& statement, const Statement* next);
  void report_several_names(NodeId name);
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
  uint32_t angled_name_ = kNone;         ///< the `\langle` of a left side `\langle E\rangle`
  TokenKind open_bar_ = TokenKind::End;  ///< the bar that is open here, in no bracket behind it
  bool in_condition_ = false;            ///< brackets may hold conditions
  uint32_t open_rows_ = 0;               ///< cases and matrices around this; outside of them `&` means nothing
  const bool block_is_silent_;
  bool silent_ = false;
  bool recovering_ = false;
  bool had_error_ = false;
  bool brackets_are_broken_ = false;
  std::vector<uint32_t> differentials_;  ///< those in fractions that no integral has taken yet
  std::vector<Part> list_;               ///< elements of the lists that are being read, innermost last
  std::vector<Token> mended_;  ///< the tokens without closers that close nothing; empty while there are none such
  uint32_t first_node_ = 0;    ///< of the statement
  BracketFaults faults_;
};

}  // namespace texbrdf
