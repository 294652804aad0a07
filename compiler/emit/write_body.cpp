#include "emit/write_body.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "emit/directions.h"
#include "emit/expressions.h"
#include "emit/locals.h"

namespace texbrdf::emit {
namespace {

using ir::BinderSet;
using ir::Graph;
using ir::Op;
using ir::Value;
using ir::ValueId;

Statement statement(Statement::Kind kind) {
  Statement result;
  result.kind = kind;
  return result;
}

Statement declaration(std::string_view type, std::string_view name, ExpressionId value) {
  Statement result = statement(Statement::Kind::Declare);
  result.type = type;
  result.name = name;
  result.value = value;
  return result;
}

/// Puts the locals and items of a plan in order.
class BodyWriter {
 public:
  BodyWriter(ExpressionPool& pool, const Graph& graph, BodyPlan plan, const std::vector<BodyItem>& items,
             FunctionScope& scope)
      : pool_(pool),
        graph_(graph),
        plan_(std::move(plan)),
        items_(items),
        scope_(scope),
        declared_(graph.size()),
        users_(graph.size(), kNoItem) {}

  std::vector<Statement> run() {
    for (Convention id : plan_.constants)
      statements_.push_back(declaration("const float", scope_.conventions[static_cast<std::size_t>(id)],
                                        write_number(pool_, *convention_constant(id))));
    find_users();
    for (uint32_t i = 0; i < items_.size(); ++i) item(i);
    return std::move(statements_);
  }

 private:
  static constexpr uint32_t kNoItem = UINT32_MAX;
  static constexpr uint32_t kSeveralItems = UINT32_MAX - 1;

  const Local& local(ValueId id) const { return plan_.locals[id.value]; }

  void find_users() {
    for (uint32_t i = 0; i < items_.size(); ++i)
      for (ValueId id : needed(graph_.roots[i], 0)) users_[id.value] = users_[id.value] == kNoItem ? i : kSeveralItems;
  }

  /// The locals not yet declared that `root` is made of, itself included, each before its users. Those that need loop
  /// variables beyond the `available` ones are left to their loops.
  std::vector<ValueId> needed(ValueId root, BinderSet available) const {
    std::vector<ValueId> result;
    std::vector<ValueId> open{root};
    std::set<ValueId> seen{root};
    while (!open.empty()) {
      ValueId id = open.back();
      open.pop_back();
      if (declared_[id.value]) continue;
      if (!local(id).name.empty() && (graph_.at(id).binders & ~available) == 0) result.push_back(id);
      for (ValueId operand : graph_.operands(id))
        if (seen.insert(operand).second) open.push_back(operand);
    }
    std::ranges::sort(result);
    return result;
  }

  void item(uint32_t index) {
    ValueId root = graph_.roots[index];
    const BodyItem& item = items_[index];
    bool is_local = !item.name.empty() && local(root).name == item.name;
    if (is_local && declared_[root.value]) return;

    std::vector<ValueId> list = needed(root, 0);
    if (is_local) list.pop_back();
    std::set<ValueId> above = standing_above(list);
    if (!above.empty()) blank();
    bool after_equation = false;
    for (ValueId id : above) {
      if (after_equation) blank();
      after_equation = !local(id).equation.text.empty();
      declare(id, 0, statements_);
    }
    if (is_local) return declare_with(root, list);

    comment(item.equation);
    for (ValueId id : list)
      if (!declared_[id.value]) declare(id, 0, statements_);
    Statement result = declaration(item.type, item.name, plan_.written[root.value]);
    if (item.spread) result.value = pool_.call("vec3", {result.value});
    if (item.name.empty()) result.kind = Statement::Kind::Return;
    statements_.push_back(std::move(result));
  }

  /// A local that is a definition as well: its own parts stand below its equation.
  void declare_with(ValueId root, const std::vector<ValueId>& parts) {
    comment(local(root).equation);
    for (ValueId id : parts)
      if (!declared_[id.value]) declare(id, 0, statements_);
    plan_.locals[root.value].equation = {};
    declare(root, 0, statements_);
  }

  /// What stands above an equation and not below it: what has a meaning of its own, what other equations need too, and
  /// what these are made of.
  std::set<ValueId> standing_above(const std::vector<ValueId>& list) const {
    std::set<ValueId> above;
    for (auto id = list.rbegin(); id != list.rend(); ++id) {
      if (above.contains(*id) || (!local(*id).has_meaning && users_[id->value] != kSeveralItems)) continue;
      for (ValueId part : needed(*id, 0)) above.insert(part);
    }
    return above;
  }

  void declare(ValueId id, BinderSet available, std::vector<Statement>& out) {
    declared_[id.value] = true;
    comment(local(id).equation);
    const Value& value = graph_.at(id);
    if (value.op == Op::Sum || value.op == Op::Product) return loop(id, available, out);
    out.push_back(declaration(glsl_type(value.type), local(id).name, plan_.values[id.value]));
  }

  /// A Sum or Product.
  void loop(ValueId id, BinderSet available, std::vector<Statement>& out) {
    const Value& value = graph_.at(id);
    auto [binder, is_new] = plan_.binders.try_emplace(value.index);
    if (is_new) binder->second = scope_.names.claim("k");
    Statement total = declaration(glsl_type(value.type), local(id).name, plan_.values[id.value]);
    Statement loop = statement(Statement::Kind::For);
    if (auto bounds = integer_bounds(graph_, id)) {
      loop.text = counting(binder->second, std::to_string(bounds->first), "<= " + std::to_string(bounds->second));
    } else {
      bound_at_run_time(id, binder->second, total, loop);
    }
    if (is_triple(value.type)) total.value = pool_.call("vec3", {total.value});

    ValueId body = graph_.operand(id, 2);
    available |= BinderSet{1} << value.index;
    std::vector<ValueId> inside = needed(body, available);
    for (ValueId part : inside) declare(part, available, loop.body);
    loop.body.push_back(statement(Statement::Kind::Update));
    loop.body.back().name = local(id).name;
    loop.body.back().text = value.op == Op::Sum ? "+=" : "*=";
    loop.body.back().value = plan_.written[body.value];
    for (ValueId part : inside) declared_[part.value] = false;
    out.push_back(std::move(total));
    out.push_back(std::move(loop));
  }

  static std::string counting(const std::string& variable, std::string_view first, std::string_view condition) {
    return "int " + variable + " = " + std::string(first) + "; " + variable + " " + std::string(condition) + "; ++" +
           variable;
  }

  /// Bounds that are not known beforehand: NaN where they are too far apart or no numbers.
  void bound_at_run_time(ValueId id, const std::string& variable, Statement& total, Statement& loop) {
    ExpressionId first = plan_.written[graph_.operand(id, 0).value];
    ExpressionId last = plan_.written[graph_.operand(id, 1).value];
    ExpressionId distance = pool_.infix(Precedence::Additive, "-", last, first);
    ExpressionId in_reach = pool_.infix(Precedence::Relational, "<", distance, write_number(pool_, kMostIterations));
    total.value = pool_.conditional(in_reach, total.value, write_number(pool_, std::nan("")));
    std::string step = scope_.names.claim(variable + "_step");
    loop.text = counting(
        step, "0",
        "< " + std::to_string(kMostIterations) + " && float(" + step + ") <= " + print_expression(pool_, distance));
    ExpressionId position = pool_.infix(Precedence::Additive, "+", first, pool_.call("float", {pool_.atom(step)}));
    loop.body.push_back(declaration("float", variable, position));
  }

  /// The entries of a matrix share an equation, which is told above the first.
  void comment(const Equation& equation) {
    if (equation.text.empty()) return;
    const bool is_told = equation.name.valid() && equation.name == told_;
    told_ = equation.name;
    if (is_told && statements_.back().kind == Statement::Kind::Blank) statements_.pop_back();
    if (is_told) return;
    blank();
    statements_.push_back(statement(Statement::Kind::Comment));
    statements_.back().source = equation.name;
    statements_.back().text = equation.text;
  }

  void blank() {
    if (statements_.empty() || statements_.back().kind != Statement::Kind::Blank)
      statements_.push_back(statement(Statement::Kind::Blank));
  }

  ExpressionPool& pool_;
  const Graph& graph_;
  BodyPlan plan_;
  const std::vector<BodyItem>& items_;
  FunctionScope& scope_;
  std::vector<bool> declared_;
  std::vector<uint32_t> users_;  ///< by value, of locals: the item that needs it
  std::vector<Statement> statements_;
  NameId told_;  ///< whose equation is the last comment
};

}  // namespace

std::vector<Statement> write_body(ExpressionPool& pool, const Graph& graph, const ProgramRanges& ranges,
                                  const std::vector<bool>* formals_can_fail, const std::vector<BodyItem>& items,
                                  FunctionScope& scope, std::set<HelperUse>& helpers) {
  bool is_entry_point = formals_can_fail == nullptr;
  GraphWithDirections directions = name_directions(graph, is_entry_point);
  std::vector<Range> values =
      find_ranges(directions.graph, ranges, is_entry_point ? std::vector<bool>{} : *formals_can_fail);
  BodyPlan plan = plan_body(pool, directions, values, items, scope, helpers);
  return BodyWriter(pool, directions.graph, std::move(plan), items, scope).run();
}

}  // namespace texbrdf::emit
