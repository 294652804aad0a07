#include "ir/differentiate.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "ir/differential_rules.h"
#include "ir/passes/passes.h"
#include "ir/passes/rewrite.h"

namespace texbrdf::ir {
namespace {

constexpr uint32_t kMostValues = 200'000;
constexpr uint32_t kMostCalls = 64;

bool is_leaf_of_document(const Value& value) {
  return value.op == Op::Reference || value.op == Op::Parameter || value.op == Op::Convention;
}

/// Differentiates one body by one variable. Values of the body that do not change with it are not copied.
class Differentiation {
 public:
  Differentiation(const Graph& source, std::span<const ProgramDefinition> definitions, Graph& result,
                  std::vector<ValueId>& images, uint32_t& next_binder)
      : source_(source), definitions_(definitions), result_(result), images_(images), next_binder_(next_binder) {}

  std::optional<ValueId> run(ValueId derivative) {
    const ValueId place = source_.operand(derivative, 0);
    const ValueId body = source_.operand(derivative, 1);
    seed_ = {images_[place.value], result_.constant(1)};
    binder_ = source_.at(derivative).index;
    if (is_leaf_of_document(source_.at(place))) named_ = source_.at(place);
    if (named_) find_dependent_definitions();
    const Type type = source_.at(body).type;
    const Dual dual = walk_body(body);
    if (has_failed_) return std::nullopt;
    return dual.tangent ? add_spread(result_, *dual.tangent, type) : add_constant(result_, 0, type);
  }

 private:
  /// Where values come from: a body in the source, or the graph of a definition that is written out.
  struct Scope {
    const Graph* graph;
    std::span<const Dual> formals;       ///< of a call
    bool is_source = false;              ///< values that do not change have images
    std::map<uint32_t, Dual> variables;  ///< by binder
    BinderSet copied = 0;                ///< binders whose values are copied
    BinderSet open = 0;                  ///< those of them that have a value here
  };

  Dual walk_body(ValueId body) {
    Scope scope{.graph = &source_, .formals = {}, .is_source = true, .variables = {}};
    scope.variables.emplace(binder_, seed_);
    scope.copied = scope.open = BinderSet{1} << binder_;
    add_inner_binders(scope, body);
    return walk(scope, body);
  }

  /// Sums whose values are copied get binders of their own.
  void add_inner_binders(Scope& scope, ValueId root) const {
    const std::vector<bool> reached = reached_from(*scope.graph, root);
    for (uint32_t i = root.value + 1; i-- > 0;) {
      const Value& value = scope.graph->at({i});
      const bool is_sum = value.op == Op::Sum || value.op == Op::Product;
      if (!reached[i] || !is_sum) continue;
      if (copies_all(scope) || (value.binders & scope.copied) != 0) scope.copied |= BinderSet{1} << value.index;
    }
  }

  bool copies_all(const Scope& scope) const { return !scope.is_source || named_.has_value(); }

  static std::vector<bool> reached_from(const Graph& graph, ValueId root) {
    std::vector<bool> reached(root.value + 1);
    reached[root.value] = true;
    for (uint32_t i = root.value + 1; i-- > 0;) {
      if (!reached[i]) continue;
      for (const ValueId operand : graph.operands({i})) reached[operand.value] = true;
    }
    return reached;
  }

  /// All values that the root needs and that have a value where the open binders have theirs.
  Dual walk(const Scope& scope, ValueId root) {
    const std::vector<bool> reached = reached_from(*scope.graph, root);
    std::vector<Dual> duals(root.value + 1);
    for (uint32_t i = 0; i <= root.value && !has_failed_; ++i) {
      const Value& value = scope.graph->at({i});
      if (!reached[i] || (value.binders & scope.copied & ~scope.open) != 0) continue;
      duals[i] = is_constant(scope, value) ? Dual{images_[i], {}} : dual_of(scope, {i}, duals);
      if (result_.size() > kMostValues) has_failed_ = true;
    }
    return duals[root.value];
  }

  bool is_constant(const Scope& scope, const Value& value) const {
    return !copies_all(scope) && (value.binders & scope.copied) == 0;
  }

  Dual dual_of(const Scope& scope, ValueId id, const std::vector<Dual>& duals) {
    const Value& value = scope.graph->at(id);
    if (named_ && value.op == named_->op && value.index == named_->index) return seed_;
    switch (value.op) {
      case Op::Formal:
        return scope.is_source ? Dual{result_.copy(value, {}), {}} : scope.formals[value.index];
      case Op::BoundVariable:
        return variable(scope, value);
      case Op::Sum:
      case Op::Product:
        return reduction(scope, id, duals);
      case Op::Call:
      case Op::Reference:
        return use(scope, id, duals);
      default:
        break;
    }
    std::vector<Dual> operands;
    for (const ValueId operand : scope.graph->operands(id)) operands.push_back(duals[operand.value]);
    return DualRules(result_).apply(value, operands);
  }

  Dual variable(const Scope& scope, const Value& value) {
    const auto known = scope.variables.find(value.index);
    if (known != scope.variables.end()) return known->second;
    return {result_.copy(value, {}), {}};
  }

  Dual use(const Scope& scope, ValueId id, const std::vector<Dual>& duals) {
    const Value& value = scope.graph->at(id);
    std::vector<Dual> arguments;
    std::vector<ValueId> plain;
    for (const ValueId operand : scope.graph->operands(id)) {
      arguments.push_back(duals[operand.value]);
      plain.push_back(arguments.back().value);
    }
    const bool changes = std::ranges::any_of(arguments, [](const Dual& dual) { return dual.tangent.has_value(); }) ||
                         (named_ && is_dependent_[value.index]);
    if (!changes) return {result_.copy(value, plain), {}};
    if (calls_ == kMostCalls) {
      has_failed_ = true;
      return {};
    }
    ++calls_;
    const Graph& called = definitions_[value.index].graph;
    Scope inside{.graph = &called, .formals = arguments, .is_source = false, .variables = {}};
    add_inner_binders(inside, called.roots[0]);
    const Dual dual = walk(inside, called.roots[0]);
    --calls_;
    return dual;
  }

  /// A sum for the value and one for its derivative: each has variables of its own.
  Dual reduction(const Scope& scope, ValueId id, const std::vector<Dual>& duals) {
    const Value& value = scope.graph->at(id);
    const ValueId first = duals[scope.graph->operand(id, 0).value].value;
    const ValueId last = duals[scope.graph->operand(id, 1).value].value;
    const auto [binder, body] = body_of(scope, id);
    if (has_failed_) return {};
    Dual dual{result_.add(value.op, {first, last, body.value}, binder), {}};
    if (!body.tangent) return dual;
    const auto [changing, change] = body_of(scope, id);
    if (has_failed_) return {};
    ValueId term = *change.tangent;
    if (value.op == Op::Product) {
      const auto [other, factor] = body_of(scope, id);
      if (has_failed_) return {};
      const ValueId here = result_.leaf(Op::BoundVariable, Type::Real, changing);
      const ValueId there = result_.leaf(Op::BoundVariable, Type::Real, other);
      const ValueId one = add_constant(result_, 1, result_.at(factor.value).type);
      const ValueId others = result_.add(Op::Select, {result_.add(Op::Equal, {here, there}), one, factor.value});
      term = result_.add(Op::Multiply, {term, result_.add(Op::Product, {first, last, others}, other)});
    }
    dual.tangent = result_.add(Op::Sum, {first, last, term}, changing);
    return dual;
  }

  std::pair<uint32_t, Dual> body_of(const Scope& scope, ValueId id) {
    if (next_binder_ >= kMaxBinders) {
      has_failed_ = true;
      return {};
    }
    const uint32_t binder = next_binder_++;
    const uint32_t own = scope.graph->at(id).index;
    Scope inside = scope;
    inside.variables[own] = {result_.leaf(Op::BoundVariable, Type::Real, binder), {}};
    inside.open |= BinderSet{1} << own;
    return {binder, walk(inside, scope.graph->operand(id, 2))};
  }

  void find_dependent_definitions() {
    for (const ProgramDefinition& definition : definitions_) {
      is_dependent_.push_back(std::ranges::any_of(definition.graph.values(), [this](const Value& value) {
        if (value.op == named_->op && value.index == named_->index) return true;
        return (value.op == Op::Reference || value.op == Op::Call) && is_dependent_[value.index];
      }));
    }
  }

  const Graph& source_;
  std::span<const ProgramDefinition> definitions_;
  Graph& result_;
  std::vector<ValueId>& images_;
  uint32_t& next_binder_;
  Dual seed_;
  uint32_t binder_ = 0;
  std::optional<Value> named_;  ///< the variable, where it is a name of the document
  std::vector<bool> is_dependent_;
  uint32_t calls_ = 0;
  bool has_failed_ = false;
};

/// The first derivative of the graph, which holds no other one.
std::optional<Graph> expand_first(const Graph& graph, ValueId derivative,
                                  std::span<const ProgramDefinition> definitions) {
  Graph result;
  std::vector<ValueId> images(graph.size());
  uint32_t next_binder = graph.binder_count();
  std::vector<ValueId> operands;
  for (uint32_t i = 0; i < graph.size(); ++i) {
    if (ValueId{i} == derivative) {
      const auto expanded = Differentiation(graph, definitions, result, images, next_binder).run(derivative);
      if (!expanded) return std::nullopt;
      images[i] = *expanded;
      continue;
    }
    operands.clear();
    for (const ValueId operand : graph.operands({i})) operands.push_back(images[operand.value]);
    images[i] = result.copy(graph.at({i}), operands);
  }
  for (const ValueId root : graph.roots) result.roots.push_back(images[root.value]);
  return remove_dead_values(result);
}

}  // namespace

std::optional<Graph> expand_derivatives(const Graph& graph, std::span<const ProgramDefinition> definitions) {
  const auto is_derivative = [](const Value& value) { return value.op == Op::Derivative; };
  std::optional<Graph> expanded = graph;
  while (expanded) {
    const auto values = expanded->values();
    const auto first = std::ranges::find_if(values, is_derivative);
    if (first == values.end()) return expanded;
    expanded = expand_first(*expanded, {static_cast<uint32_t>(first - values.begin())}, definitions);
  }
  return std::nullopt;
}

}  // namespace texbrdf::ir
