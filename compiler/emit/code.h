#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emit/code_text.h"
#include "semantics/names.h"

namespace texbrdf::emit {

/// How tightly the operators of C-like languages bind, loosest first.
enum class Precedence : uint8_t {
  Conditional,
  Or,
  And,
  Equality,
  Relational,
  Additive,
  Multiplicative,
  Unary,
  Primary,
};

struct ExpressionId {
  uint32_t value = UINT32_MAX;
  constexpr bool valid() const { return value != UINT32_MAX; }
  friend constexpr auto operator<=>(const ExpressionId&, const ExpressionId&) = default;
};

/// An expression of generated code, ready to be laid out.
struct Expression {
  enum class Kind : uint8_t { Atom, Call, Member, Prefix, Infix, Conditional };
  Kind kind = Kind::Atom;
  Precedence precedence = Precedence::Primary;
  bool leading_minus = false;  ///< the first character printed is a minus
  uint32_t width = 0;          ///< characters on one line, without parentheses around it; saturates
  uint32_t nesting = 0;        ///< levels of parentheses and calls within each other
  std::string text;            ///< an atom's text, a function's name, a member's name, an operator
  std::vector<ExpressionId> operands;
};

/// What is shown above the code that is made of it.
struct Equation {
  Equation() = default;
  Equation(NameId of, std::string source) : name(of), text(std::move(source)) {}

  NameId name;
  std::string text;  ///< may be empty: then nothing is shown
};

/// All expressions of one file. Operands are older than their users and may have several.
class ExpressionPool {
 public:
  const Expression& at(ExpressionId id) const { return expressions_[id.value]; }

  ExpressionId atom(std::string_view text);
  ExpressionId call(std::string_view function, std::vector<ExpressionId> arguments);
  ExpressionId member(ExpressionId object, std::string_view name);
  ExpressionId prefix(std::string_view op, ExpressionId operand);
  /// Associates to the left.
  ExpressionId infix(Precedence precedence, std::string_view op, ExpressionId left, ExpressionId right);
  ExpressionId conditional(ExpressionId condition, ExpressionId if_true, ExpressionId if_false);

  /// Whether operand `index` of `user` needs parentheses.
  bool parenthesised(const Expression& user, uint32_t index) const;

 private:
  ExpressionId add(Expression expression);
  std::vector<Expression> expressions_;
};

struct Statement {
  enum class Kind : uint8_t {
    Comment,  ///< `text` is an equation: an empty line, then a comment, then its code up to the next empty line
    Declare,  ///< `type name = value;`
    Update,   ///< `name text value;` as in `sum += value;`
    For,      ///< `for (text) { body }`
    Return,
    ReturnIf,  ///< `if (condition) return value;`
    Break,     ///< `if (condition) break;`
    Blank,
  };
  Kind kind = Kind::Blank;
  NameId source;  ///< of a Comment: whose equation it is; of a Declare that is a parameter: which
  std::string type;
  std::string name;
  std::string text;
  ExpressionId condition;
  ExpressionId value;
  std::vector<Statement> body;
};

struct FunctionParameter {
  std::string type;
  std::string name;
};

struct Function {
  Equation equation;
  std::string type;
  std::string name;
  std::vector<FunctionParameter> parameters;
  std::vector<Statement> body;
};

/// Lines end with "\n" and are shorter than 100 columns as long as no name is longer than a third of that.
CodeText print_function(const ExpressionPool& pool, const Function& function);
/// On one line.
std::string print_expression(const ExpressionPool& pool, ExpressionId id);

}  // namespace texbrdf::emit
