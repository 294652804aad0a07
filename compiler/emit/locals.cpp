#include "emit/locals.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "emit/expressions.h"

namespace texbrdf::emit {
namespace {

using ir::Graph;
using ir::Op;
using ir::Value;
using ir::ValueId;

/// Parentheses and calls within each other, before a part becomes a local.
constexpr uint32_t kDeepestNesting = 9;
/// Names made of the names of operands may be this long.
constexpr std::size_t kLongestMadeName = 20;
/// A local that nothing better can be said of.
constexpr std::string_view kPlainName = "t";
/// It must save this many characters, because it does not say what it is.
constexpr std::size_t kWorthAPlainName = 60;

bool is_reduction(Op op) {
  return op == Op::Sum || op == Op::Product;
}

class Planner {
 public:
  Planner(ExpressionPool& pool, const GraphWithDirections& directions, const std::vector<Range>& ranges,
          const std::vector<BodyItem>& items, FunctionScope& scope, std::set<HelperUse>& helpers)
      : pool_(pool),
        directions_(directions),
        graph_(directions.graph),
        items_(items),
        scope_(scope),
        plan_{.uses = count_uses(),
              .locals = std::vector<Local>(directions.graph.size()),
              .values = std::vector<ExpressionId>(directions.graph.size()),
              .written = std::vector<ExpressionId>(directions.graph.size()),
              .constants = {},
              .binders = {}},
        expressions_(pool, directions.graph, ranges, plan_.uses, helpers) {
    note_items();
    note_operands();
  }

  BodyPlan run() {
    claim_constants();
    for (uint32_t i = 0; i < graph_.size(); ++i)
      if (plan_.uses[i] > 0) write({i});
    return std::move(plan_);
  }

 private:
  std::vector<uint32_t> count_uses() const {
    std::vector<uint32_t> uses(graph_.size());
    for (ValueId root : graph_.roots) ++uses[root.value];
    for (uint32_t i = graph_.size(); i-- > 0;) {
      if (uses[i] == 0 || is_given(graph_.at({i}))) continue;
      for (ValueId operand : graph_.operands({i})) ++uses[operand.value];
    }
    return uses;
  }

  /// A convention that is a parameter of the function, whatever it is made of.
  bool is_given(const Value& value) const {
    return value.op == Op::Convention && !scope_.conventions[value.index].empty();
  }

  void note_items() {
    for (uint32_t i = 0; i < items_.size(); ++i) {
      auto [entry, is_first] = item_of_.try_emplace(graph_.roots[i], i);
      // A local can lend its name to a value, the returned expression cannot.
      if (!is_first && items_[entry->second].name.empty()) entry->second = i;
    }
  }

  void note_operands() {
    for (uint32_t i = 0; i < graph_.size(); ++i) {
      const Value& value = graph_.at({i});
      if (plan_.uses[i] > 0 && value.op == Op::Arccos) made_into_angle_.insert(graph_.operand({i}, 0));
      if (plan_.uses[i] == 0 || !is_reduction(value.op) || integer_bounds(graph_, {i})) continue;
      float_binders_.insert(value.index);
      bounds_.insert({graph_.operand({i}, 0), graph_.operand({i}, 1)});
    }
  }

  void claim_constants() {
    for (uint32_t i = 0; i < graph_.size(); ++i) {
      const Value& value = graph_.at({i});
      if (plan_.uses[i] == 0 || value.op != Op::Convention) continue;
      auto id = static_cast<Convention>(value.index);
      if (!convention_constant(id)) continue;
      scope_.conventions[value.index] = scope_.names.claim(convention_entry(id).symbol);
      plan_.constants.push_back(id);
    }
  }

  void write(ValueId id) {
    ExpressionId expression = write_expression(id);
    plan_.values[id.value] = expression;
    choose_local(id, pool_.at(expression));
    const Local& local = plan_.locals[id.value];
    plan_.written[id.value] = local.name.empty() ? expression : pool_.atom(local.name);
  }

  ExpressionId write_expression(ValueId id) {
    const Value& value = graph_.at(id);
    if (value.op == Op::Parameter) return pool_.atom(scope_.parameters[value.index]);
    if (value.op == Op::Reference) return pool_.atom(scope_.definitions[value.index]);
    if (value.op == Op::Formal) return pool_.atom(scope_.formals[value.index]);
    if (value.op == Op::BoundVariable) return bound_variable(value.index);
    if (value.op == Op::Call) return call(id);
    if (value.op == Op::Sum) return write_number(pool_, 0);
    if (value.op == Op::Product) return write_number(pool_, 1);
    return is_given(value) ? pool_.atom(scope_.conventions[value.index]) : expressions_.write(id, plan_.written);
  }

  ExpressionId call(ValueId id) {
    std::vector<ExpressionId> arguments;
    for (ValueId operand : graph_.operands(id)) arguments.push_back(plan_.written[operand.value]);
    return pool_.call(scope_.definitions[graph_.at(id).index], std::move(arguments));
  }

  ExpressionId bound_variable(uint32_t binder) {
    auto [entry, is_new] = plan_.binders.try_emplace(binder);
    if (is_new) entry->second = scope_.names.claim("k");
    ExpressionId variable = pool_.atom(entry->second);
    return float_binders_.contains(binder) ? variable : pool_.call("float", {variable});
  }

  void choose_local(ValueId id, const Expression& expression) {
    const Value& value = graph_.at(id);
    if (is_reduction(value.op)) return name_local(id, value.op == Op::Sum ? "sum" : "product", false);
    if (expression.kind == Expression::Kind::Atom || value.op == Op::Constant || value.op == Op::BoundVariable) return;
    if (auto name = meaning(id)) return name_as_meaning(id, *name);
    if (is_only_an_item(id)) return;
    std::string name = made_name(id, expression);
    bool too_deep = expression.nesting > kDeepestNesting;
    if (too_deep || bounds_.contains(id) || shortens(id, expression, name)) name_local(id, name, false);
  }

  std::optional<std::string> meaning(ValueId id) const {
    auto direction = directions_.names.find(id);
    if (direction != directions_.names.end() && !only_makes_an_angle(id)) return direction->second;
    const Value& value = graph_.at(id);
    if (value.op != Op::Convention) return std::nullopt;
    return std::string(convention_entry(static_cast<Convention>(value.index)).symbol);
  }

  bool only_makes_an_angle(ValueId id) const { return plan_.uses[id.value] == 1 && made_into_angle_.contains(id); }

  /// The one use of the value is to be the whole of a definition.
  bool is_only_an_item(ValueId id) const { return plan_.uses[id.value] == 1 && item_of_.contains(id); }

  /// A definition that is nothing else gives the value its name.
  void name_as_meaning(ValueId id, std::string_view name) {
    auto item = item_of_.find(id);
    if (item == item_of_.end()) return name_local(id, name, true);
    const BodyItem& definition = items_[item->second];
    if (definition.name.empty() && is_only_an_item(id)) return;
    if (definition.name.empty()) return name_local(id, name, true);
    plan_.locals[id.value] = {.name = definition.name, .equation = definition.equation, .has_meaning = true};
  }

  void name_local(ValueId id, std::string_view name, bool has_meaning) {
    plan_.locals[id.value] = {.name = scope_.names.claim(name), .equation = {}, .has_meaning = has_meaning};
  }

  bool shortens(ValueId id, const Expression& expression, std::string_view name) const {
    std::size_t uses = plan_.uses[id.value];
    constexpr std::string_view kRestOfDeclaration = "   = ;";
    std::size_t declaration =
        glsl_type(graph_.at(id).type).size() + kRestOfDeclaration.size() + name.size() + expression.width;
    std::size_t worth = name == kPlainName ? kWorthAPlainName : 0;
    return uses > 1 && uses * expression.width > declaration + uses * name.size() + worth;
  }

  /// N_dot_L, sin_alpha, or the plain name.
  std::string made_name(ValueId id, const Expression& expression) const {
    std::string function = expression.text;
    if (function.ends_with('_')) function.pop_back();
    std::string name;
    for (ValueId operand : graph_.operands(id)) {
      const Expression& part = pool_.at(plan_.written[operand.value]);
      bool is_number = part.text.empty() || (part.text.front() >= '0' && part.text.front() <= '9');
      if (part.kind != Expression::Kind::Atom || is_number) return std::string(kPlainName);
      if (!name.empty()) name += "_" + function + "_";
      name += part.text;
    }
    bool one_operand = graph_.operands(id).size() == 1;
    if (expression.kind != Expression::Kind::Call || (!one_operand && graph_.at(id).op != Op::Dot))
      return std::string(kPlainName);
    if (one_operand) name.insert(0, function + "_");
    bool legible = name.size() <= kLongestMadeName && name.find("__") == std::string::npos;
    return legible ? name : std::string(kPlainName);
  }

  ExpressionPool& pool_;
  const GraphWithDirections& directions_;
  const Graph& graph_;
  const std::vector<BodyItem>& items_;
  FunctionScope& scope_;
  BodyPlan plan_;
  ExpressionWriter expressions_;
  std::map<ValueId, uint32_t> item_of_;
  std::set<ValueId> made_into_angle_;
  std::set<ValueId> bounds_;          ///< what a loop needs to know before it starts
  std::set<uint32_t> float_binders_;  ///< whose loops do not count in integers
};

}  // namespace

BodyPlan plan_body(ExpressionPool& pool, const GraphWithDirections& directions, const std::vector<Range>& ranges,
                   const std::vector<BodyItem>& items, FunctionScope& scope, std::set<HelperUse>& helpers) {
  return Planner(pool, directions, ranges, items, scope, helpers).run();
}

std::optional<std::pair<int, int>> integer_bounds(const Graph& graph, ValueId reduction) {
  constexpr double kFarthest = 1e6;
  const Value& first = graph.at(graph.operand(reduction, 0));
  const Value& last = graph.at(graph.operand(reduction, 1));
  if (first.op != Op::Constant || last.op != Op::Constant) return std::nullopt;
  if (!(std::abs(first.constant) < kFarthest && std::abs(last.constant) < kFarthest)) return std::nullopt;
  if (last.constant - first.constant >= kMostIterations) return std::nullopt;
  return std::pair{static_cast<int>(first.constant), static_cast<int>(last.constant)};
}

}  // namespace texbrdf::emit
