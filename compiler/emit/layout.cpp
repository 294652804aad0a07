#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "emit/code.h"
#include "emit/comment.h"

namespace texbrdf::emit {
namespace {

constexpr uint32_t kLineWidth = 99;
constexpr uint32_t kIndent = 2;
constexpr uint32_t kContinuation = 4;
constexpr uint32_t kDeepestAlignment = 48;

/// Writes code line by line; breaks a line only where the rest does not fit, outside before inside.
class Layout {
 public:
  Layout(const ExpressionPool& pool, uint32_t width) : pool_(pool), width_(width) {}

  CodeText take() { return std::move(out_); }

  void function(const Function& f) {
    const uint32_t first_line = out_.line_count();
    text(equation_comment(f.equation.text, 0));
    text(f.type + " " + f.name + "(");
    uint32_t open = column_;
    for (std::size_t i = 0; i < f.parameters.size(); ++i) {
      std::string piece = f.parameters[i].type + " " + f.parameters[i].name;
      piece += i + 1 == f.parameters.size() ? ") {" : ",";
      if (i > 0) space_or_new_line(static_cast<uint32_t>(piece.size()), open);
      text(piece);
    }
    text(f.parameters.empty() ? ") {\n" : "\n");
    statements(f.body, kIndent);
    end_source();
    text("}\n");
    if (f.equation.name.valid()) out_.note_lines(f.equation.name, first_line);
  }

  void flat(ExpressionId id) { expression(id, 0, 0); }

 private:
  void statements(const std::vector<Statement>& list, uint32_t indent) {
    bool first = true;
    for (const Statement& s : list) {
      const bool begins_anew = s.kind == Statement::Kind::Blank || s.kind == Statement::Kind::Comment;
      if (begins_anew || s.source.valid()) end_source();
      if (s.source.valid()) begin_source(s.source);
      statement(s, indent, first);
      first = false;
    }
  }

  void begin_source(NameId name) {
    source_ = name;
    source_begin_ = out_.line_count();
  }

  void end_source() {
    if (source_.valid()) out_.note_lines(source_, source_begin_);
    source_ = {};
  }

  void statement(const Statement& s, uint32_t indent, bool first) {
    switch (s.kind) {
      case Statement::Kind::Blank:
        if (!first) text("\n");
        return;
      case Statement::Kind::Comment:
        text(equation_comment(s.text, indent));
        return;
      case Statement::Kind::Declare:
        begin_line(indent);
        text(s.type + " " + s.name + " = ");
        expression(s.value, indent + kContinuation, 1);
        text(";\n");
        return;
      case Statement::Kind::Update:
        begin_line(indent);
        text(s.name + " " + s.text + " ");
        expression(s.value, indent + kContinuation, 1);
        text(";\n");
        return;
      case Statement::Kind::For:
        begin_line(indent);
        text("for (" + s.text + ") {\n");
        statements(s.body, indent + kIndent);
        begin_line(indent);
        text("}\n");
        return;
      case Statement::Kind::Return:
        begin_line(indent);
        text("return ");
        expression(s.value, indent + kContinuation, 1);
        text(";\n");
        return;
      case Statement::Kind::ReturnIf:
        begin_line(indent);
        text("if (");
        expression(s.condition, indent + kContinuation, 2);
        text(") return ");
        expression(s.value, indent + kContinuation, 1);
        text(";\n");
        return;
      case Statement::Kind::Break:
        begin_line(indent);
        text("if (");
        expression(s.condition, indent + kContinuation, 9);
        text(") break;\n");
        return;
    }
  }

  /// `indent`: of further lines; `tail`: characters that must follow on the last one.
  void expression(ExpressionId id, uint32_t indent, uint32_t tail) {
    const Expression& e = pool_.at(id);
    switch (e.kind) {
      case Expression::Kind::Atom:
        text(e.text);
        return;
      case Expression::Kind::Call:
        call(e, indent, tail);
        return;
      case Expression::Kind::Member:
        operand(e, 0, indent, tail + 1 + static_cast<uint32_t>(e.text.size()));
        text("." + e.text);
        return;
      case Expression::Kind::Prefix:
        text(e.text);
        operand(e, 0, indent, tail);
        return;
      case Expression::Kind::Infix:
        chain(id, indent, tail);
        return;
      case Expression::Kind::Conditional:
        conditional(e, indent, tail);
        return;
    }
  }

  void operand(const Expression& user, uint32_t index, uint32_t indent, uint32_t tail) {
    if (!pool_.parenthesised(user, index)) return expression(user.operands[index], indent, tail);
    text("(");
    expression(user.operands[index], inner_indent(indent), tail + 1);
    text(")");
  }

  uint32_t operand_width(const Expression& user, uint32_t index) const {
    return pool_.at(user.operands[index]).width + (pool_.parenthesised(user, index) ? 2 : 0);
  }

  void call(const Expression& e, uint32_t indent, uint32_t tail) {
    text(e.text + "(");
    uint32_t inside = inner_indent(indent);
    uint32_t first_line = out_.line_count();
    uint32_t count = static_cast<uint32_t>(e.operands.size());
    for (uint32_t i = 0; i < count; ++i) {
      uint32_t after = i + 1 == count ? tail + 1 : 1;
      bool after_several_lines = out_.line_count() != first_line;
      if (i > 0 && after_several_lines) {
        new_line(inside);
      } else if (i > 0) {
        space_or_new_line(operand_width(e, i) + after, inside);
      }
      expression(e.operands[i], inside, after);
      if (i + 1 < count) text(",");
    }
    text(")");
  }

  void conditional(const Expression& e, uint32_t indent, uint32_t tail) {
    bool broken = !fits(e.width + tail);
    operand(e, 0, indent, 0);
    for (uint32_t i : {1u, 2u}) {
      broken ? new_line(indent) : text(" ");
      text(i == 1 ? "? " : ": ");
      operand(e, i, indent + kContinuation, i == 2 ? tail : 0);
    }
  }

  /// a + b - c …: operators of one level, which are nested to the left in the tree, are one row on the page.
  void chain(ExpressionId id, uint32_t indent, uint32_t tail) {
    std::vector<const Expression*> links;
    const Expression* e = &pool_.at(id);
    while (true) {
      links.push_back(e);
      const Expression& left = pool_.at(e->operands[0]);
      if (left.kind != Expression::Kind::Infix || left.precedence != e->precedence || pool_.parenthesised(*e, 0)) break;
      e = &left;
    }
    operand(*links.back(), 0, indent, 0);
    for (auto link = links.rbegin(); link != links.rend(); ++link) {
      const Expression& infix = **link;
      uint32_t after = std::next(link) == links.rend() ? tail : 0;
      space_or_new_line(static_cast<uint32_t>(infix.text.size()) + 1 + operand_width(infix, 1) + after, indent);
      text(infix.text + " ");
      operand(infix, 1, column_, after);
    }
  }

  /// Where the lines go on inside of the parenthesis just opened: below its content, if there is room.
  uint32_t inner_indent(uint32_t indent) const {
    return column_ <= kDeepestAlignment ? column_ : indent + kContinuation;
  }

  void space_or_new_line(uint32_t width, uint32_t indent) {
    if (fits(1 + width)) {
      text(" ");
    } else {
      new_line(indent);
    }
  }

  bool fits(uint32_t width) const { return width_ == 0 || column_ + width <= width_; }

  void begin_line(uint32_t indent) { text(std::string(indent, ' ')); }
  void new_line(uint32_t indent) { text("\n" + std::string(indent, ' ')); }

  void text(std::string_view piece) {
    out_.append(piece);
    std::size_t line_end = piece.rfind('\n');
    column_ = line_end == std::string_view::npos ? column_ + static_cast<uint32_t>(piece.size())
                                                 : static_cast<uint32_t>(piece.size() - line_end - 1);
  }

  const ExpressionPool& pool_;
  uint32_t width_;  ///< 0: no limit
  CodeText out_;
  uint32_t column_ = 0;
  NameId source_;  ///< of the lines that are being written
  uint32_t source_begin_ = 0;
};

}  // namespace

CodeText print_function(const ExpressionPool& pool, const Function& function) {
  Layout layout(pool, kLineWidth);
  layout.function(function);
  return layout.take();
}

std::string print_expression(const ExpressionPool& pool, ExpressionId id) {
  Layout layout(pool, 0);
  layout.flat(id);
  return layout.take().take().text;
}

}  // namespace texbrdf::emit
