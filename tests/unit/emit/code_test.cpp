#include "emit/code.h"

#include <gtest/gtest.h>

namespace texbrdf::emit {
namespace {

class Code : public testing::Test {
 protected:
  ExpressionId atom(std::string_view text) { return pool_.atom(text); }
  ExpressionId add(ExpressionId a, ExpressionId b) { return pool_.infix(Precedence::Additive, "+", a, b); }
  ExpressionId subtract(ExpressionId a, ExpressionId b) { return pool_.infix(Precedence::Additive, "-", a, b); }
  ExpressionId multiply(ExpressionId a, ExpressionId b) { return pool_.infix(Precedence::Multiplicative, "*", a, b); }
  ExpressionId less(ExpressionId a, ExpressionId b) { return pool_.infix(Precedence::Relational, "<", a, b); }
  ExpressionId negate(ExpressionId a) { return pool_.prefix("-", a); }

  void expect(ExpressionId id, std::string_view text) {
    EXPECT_EQ(print_expression(pool_, id), text);
    EXPECT_EQ(pool_.at(id).width, text.size()) << text;
  }

  ExpressionPool pool_;
  ExpressionId a_ = pool_.atom("a");
  ExpressionId b_ = pool_.atom("b");
  ExpressionId c_ = pool_.atom("c");
};

TEST_F(Code, HasTheParenthesesThatItNeeds) {
  expect(add(add(a_, b_), c_), "a + b + c");
  expect(add(a_, add(b_, c_)), "a + (b + c)");
  expect(subtract(a_, subtract(b_, c_)), "a - (b - c)");
  expect(multiply(add(a_, b_), c_), "(a + b) * c");
  expect(add(multiply(a_, b_), c_), "a * b + c");
  expect(multiply(a_, multiply(b_, c_)), "a * (b * c)");
}

TEST_F(Code, NeverWritesTwoSignsTogether) {
  expect(negate(negate(a_)), "-(-a)");
  expect(subtract(a_, negate(b_)), "a - (-b)");
  expect(subtract(a_, negate(multiply(b_, c_))), "a - (-b * c)");
  expect(negate(subtract(negate(a_), b_)), "-(-a - b)");
  expect(negate(multiply(negate(a_), b_)), "-(-a * b)");
  expect(multiply(a_, negate(b_)), "a * -b");
}

TEST_F(Code, NegatesProductsWithoutParentheses) {
  expect(negate(multiply(a_, b_)), "-a * b");
  expect(add(negate(multiply(a_, b_)), c_), "-a * b + c");
  expect(negate(add(a_, b_)), "-(a + b)");
}

TEST_F(Code, SeparatesAndFromOr) {
  ExpressionId both = pool_.infix(Precedence::And, "&&", less(a_, b_), less(b_, c_));
  expect(pool_.infix(Precedence::Or, "||", both, both), "(a < b && b < c) || (a < b && b < c)");
  expect(pool_.prefix("!", both), "!(a < b && b < c)");
  expect(less(less(a_, b_), c_), "(a < b) < c");
}

TEST_F(Code, WritesCallsMembersAndConditionals) {
  expect(pool_.call("f", {}), "f()");
  expect(pool_.call("f", {a_, add(b_, c_)}), "f(a, b + c)");
  expect(pool_.member(add(a_, b_), "x"), "(a + b).x");
  expect(pool_.member(pool_.call("f", {a_}), "x"), "f(a).x");
  ExpressionId choice = pool_.conditional(less(a_, b_), a_, b_);
  expect(choice, "a < b ? a : b");
  expect(add(choice, c_), "(a < b ? a : b) + c");
  expect(pool_.conditional(less(b_, c_), choice, choice), "b < c ? a < b ? a : b : a < b ? a : b");
}

TEST_F(Code, BreaksLongRowsBeforeOperators) {
  ExpressionId row = atom("first_operand");
  for (int i = 0; i < 8; ++i) row = add(row, atom("another_operand"));
  Function function{.equation = {}, .type = "float", .name = "f", .parameters = {}, .body = {}};
  function.body.resize(1);
  function.body[0].kind = Statement::Kind::Return;
  function.body[0].value = row;
  EXPECT_EQ(print_function(pool_, function).take().text,
            "float f() {\n"
            "  return first_operand + another_operand + another_operand + another_operand + another_operand\n"
            "      + another_operand + another_operand + another_operand + another_operand;\n"
            "}\n");
}

TEST_F(Code, AlignsWhatParenthesesHold) {
  ExpressionId long_name = atom("a_name_that_is_rather_long");
  ExpressionId sum = add(add(long_name, long_name), add(long_name, long_name));
  Function function{.equation = {}, .type = "float", .name = "f", .parameters = {{"float", "x"}}, .body = {}};
  function.body.resize(1);
  function.body[0].kind = Statement::Kind::Declare;
  function.body[0].type = "float";
  function.body[0].name = "y";
  function.body[0].value = pool_.call("function", {sum, multiply(a_, add(b_, c_))});
  EXPECT_EQ(print_function(pool_, function).take().text,
            "float f(float x) {\n"
            "  float y = function(a_name_that_is_rather_long + a_name_that_is_rather_long\n"
            "                     + (a_name_that_is_rather_long + a_name_that_is_rather_long),\n"
            "                     a * (b + c));\n"
            "}\n");
}

}  // namespace
}  // namespace texbrdf::emit
