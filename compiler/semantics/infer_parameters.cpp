#include "semantics/infer_parameters.h"

#include <algorithm>

#include "semantics/instance_facts.h"
#include "semantics/type_walk.h"

namespace texbrdf {
namespace {

/// Parameters beside a `\times` are vectors, if that is possible at all.
enum class Times : uint8_t { IsCrossProduct, IsAnyProduct };

/// The types that each value may have while some parameters are open. Stops where a value has none left.
class PossibleTypes {
 public:
  using Value = TypeSet;

  PossibleTypes(const DefinitionView& view, const ResolvedBody& body, const std::vector<TypeSet>& parameters,
                Times times, Calls calls)
      : view_(view), body_(body), parameters_(parameters), times_(times), calls_(calls) {}

  bool stopped() const { return failed_; }
  TypeSet exactly(Type type) const { return type; }
  TypeSet leaf(uint32_t slot) const { return body_.leaves[slot]; }
  TypeSet parameter(uint32_t position) const { return parameters_[position]; }
  TypeSet binary(NodeId, Operator op, TypeSet left, TypeSet right) {
    if (op == Operator::Cross && times_ == Times::IsCrossProduct) {
      left = left & (TypeSet::triples() | Type::Error);
      right = right & (TypeSet::triples() | Type::Error);
    }
    return checked(results(op, left, right));
  }

  TypeSet elementary(NodeId id, const std::vector<TypeSet>& values) {
    TypeSet found;
    bool may_be_real = true;
    for (NodeId operand : view_.block.tree.children(id)) {
      const TypeSet got = accept(values[view_.slot(operand)], TypeSet::componentwise());
      may_be_real = may_be_real && !(got & (TypeSet(Type::Real) | Type::Error)).empty();
      if (got.contains(Type::Colour) || got.contains(Type::Tuple)) found = found | Type::Colour;
      found = found | (got & Type::Error);
    }
    return may_be_real ? found | Type::Real : found;
  }

  TypeSet determinant(NodeId, TypeSet operand) {
    return (accept(operand, TypeSet::aggregates()) & Type::Error) | Type::Real;
  }

  TypeSet power_of_matrix(NodeId id, MatrixPower power, TypeSet base, TypeSet exponent) {
    const bool has_sign = has_transposition_sign(view_, body_, id);
    TypeSet found = base & Type::Error;
    for (const Type type : TypeSet::all_types()) {
      if (!base.contains(type)) continue;
      if (power != MatrixPower::Transposed && is_square_matrix(type)) found = found | type;
      const std::optional<Type> transpose =
          power == MatrixPower::Transposed ? transposed_base(view_, id, type) : std::nullopt;
      if (transpose) found = found | *transpose;
    }
    return checked(has_sign ? found : found | results(Operator::Power, base, exponent));
  }

  TypeSet builtin(NodeId id, Builtin function, const std::vector<TypeSet>& values) {
    std::vector<Type> arguments;
    for (NodeId argument : view_.block.tree.children(id).subspan(1)) {
      arguments.push_back(values[view_.slot(argument)].only_aggregate());
    }
    return call(id, signature_for(function, arguments), values);
  }

  TypeSet derivative_call(NodeId id, const Signature& signature, const std::vector<TypeSet>& values) {
    return call(id, signature, values);
  }

  TypeSet bounds(NodeId id, const std::vector<TypeSet>& values) {
    TypeSet found = Type::Real;
    for (NodeId bound : view_.block.tree.children(id)) {
      found = found | (accept(values[view_.slot(bound)], Type::Real) & Type::Error);
    }
    return found;
  }

  TypeSet derivative(NodeId, TypeSet variable, TypeSet body) {
    return body | (accept(variable, Type::Real) & Type::Error);
  }

  TypeSet reduction(NodeId id, TypeSet bounds, TypeSet body) {
    if (!is_product(view_, id)) return body | (bounds & Type::Error);
    TypeSet found = accept(body, TypeSet::componentwise()) | (bounds & Type::Error);
    if (found.contains(Type::Tuple)) found = found | Type::Colour;
    return found;
  }

  TypeSet signed_value(NodeId, TypeSet operand) {
    return accept(operand, TypeSet::triples() | TypeSet::aggregates() | Type::Real);
  }

  TypeSet length(NodeId id, TypeSet operand) { return (signed_value(id, operand) & Type::Error) | Type::Real; }

  TypeSet comparison(NodeId id, const std::vector<TypeSet>& values) { return condition_of(id, values, Type::Real); }

  TypeSet junction(NodeId id, const std::vector<TypeSet>& values) { return condition_of(id, values, Type::Boolean); }

  TypeSet row(NodeId id, const std::vector<TypeSet>& values) {
    const std::span<const NodeId> children = view_.block.tree.children(id);
    if (children.size() > 1) accept(values[view_.slot(children[1])], Type::Boolean);
    return values[view_.slot(children[0])];
  }

  TypeSet cases(NodeId id, const std::vector<TypeSet>& values) {
    const std::span<const NodeId> rows = view_.block.tree.children(id);
    TypeSet found = values[view_.slot(rows[0])];
    for (NodeId row : rows.subspan(1)) found = checked(results(Operator::Plus, found, values[view_.slot(row)]));
    return found;
  }

  TypeSet tuple(NodeId id, const std::vector<TypeSet>& values) {
    const std::span<const NodeId> elements = view_.block.tree.children(id);
    return entries(elements, values) | tuple_type(elements.size()).value_or(Type::Tuple);
  }

  TypeSet matrix(NodeId id, const std::vector<TypeSet>& values) {
    TypeSet found = type_of_shape(matrix_shape(view_, id)).value_or(Type::Error);
    for (NodeId row : view_.block.tree.children(id)) found = found | entries(view_.block.tree.children(row), values);
    return found;
  }

  TypeSet call_definition(NodeId id, NameId function, const Signature& signature, const std::vector<TypeSet>& values) {
    if (calls_ == Calls::AsDefined || signature.open == 0) return call(id, signature, values);
    std::vector<Type> arguments;
    for (NodeId argument : view_.block.tree.children(id).subspan(1)) {
      const std::optional<Type> only = values[view_.slot(argument)].only();
      if (!only) return TypeSet::all();
      arguments.push_back(*only);
    }
    const std::optional<Instance> instance = called_instance(function, signature, arguments);
    if (!instance) return call(id, signature, values);
    const InstanceFact fact = view_.facts.instance(*instance);
    return checked(fact.kind == InstanceFact::Kind::Fits ? TypeSet(fact.result) : TypeSet());
  }

  TypeSet call(NodeId id, const Signature& signature, const std::vector<TypeSet>& values) {
    const std::span<const NodeId> arguments = view_.block.tree.children(id).subspan(1);
    const size_t count = std::min(arguments.size(), signature.parameters.size());
    TypeSet found;
    bool may_be_plain = true;
    for (size_t i = 0; i < count; ++i) {
      const Type expected = signature.parameters[i];
      const bool is_spread = signature.is_spread(i);
      const TypeSet all = is_spread ? TypeSet::componentwise() : TypeSet::fitting(expected);
      const TypeSet got = accept(values[view_.slot(arguments[i])], expected == Type::Error ? TypeSet::all() : all);
      if (got.contains(Type::Error) || expected == Type::Error) found = found | Type::Error;
      if (!is_spread) continue;
      may_be_plain = may_be_plain && !(got & (TypeSet(Type::Real) | Type::Error)).empty();
      if (got.contains(Type::Colour) || got.contains(Type::Tuple)) found = found | Type::Colour;
    }
    return may_be_plain ? found | signature.result : found;
  }

 private:
  TypeSet checked(TypeSet types) {
    failed_ = failed_ || types.empty();
    return types;
  }

  /// Error where one may be in error.
  TypeSet entries(std::span<const NodeId> entries, const std::vector<TypeSet>& values) {
    TypeSet found;
    for (NodeId entry : entries) found = found | (accept(values[view_.slot(entry)], Type::Real) & Type::Error);
    return found;
  }

  TypeSet condition_of(NodeId id, const std::vector<TypeSet>& values, Type operands) {
    TypeSet found = Type::Boolean;
    for (NodeId operand : view_.block.tree.children(id)) {
      found = found | (accept(values[view_.slot(operand)], operands) & Type::Error);
    }
    return found;
  }

  // What of `got` is expected. A poisoned operand is accepted and poisons.
  TypeSet accept(TypeSet got, TypeSet expected) { return checked(got & (expected | Type::Error)); }

  const DefinitionView& view_;
  const ResolvedBody& body_;
  const std::vector<TypeSet>& parameters_;
  const Times times_;
  const Calls calls_;
  bool failed_ = false;
};

class Search {
 public:
  /// An open parameter is a real or of the type `vector`.
  Search(const DefinitionView& view, const ResolvedBody& body, const std::vector<Type>& known, Times times, Calls calls,
         Type vector)
      : view_(view),
        body_(body),
        known_(known),
        times_(times),
        calls_(calls),
        vector_(vector),
        values_(view.slot_count()) {
    for (uint32_t i = 0; i < known.size(); ++i) {
      const bool is_open = known[i] == Type::Error;
      types_.push_back(is_open ? either() : TypeSet(known[i]));
      if (is_open) open_.push_back(i);
    }
  }

  std::optional<std::vector<Type>> run() {
    if (!may_check()) return std::nullopt;
    for (uint32_t parameter : open_) narrow(parameter);
    std::erase_if(open_, [&](uint32_t parameter) { return types_[parameter] != either(); });
    for (uint32_t vectors = 0; vectors <= open_.size() && !is_exhausted(); ++vectors) {
      if (assign(vectors)) return chosen();
    }
    return std::nullopt;
  }

 private:
  TypeSet either() const { return TypeSet(Type::Real) | vector_; }
  bool is_exhausted() const { return steps_ > (calls_ == Calls::AsDefined ? kMaxInferenceSteps : kMaxInstanceSteps); }

  bool may_check() {
    steps_ += values_.size();
    PossibleTypes domain(view_, body_, types_, times_, calls_);
    TypeWalk<PossibleTypes>(view_, body_, domain).run(values_);
    return !domain.stopped();
  }

  void narrow(uint32_t parameter) {
    for (Type type : {Type::Real, vector_}) {
      if (is_exhausted()) return;
      types_[parameter] = type;
      const bool possible = may_check();
      types_[parameter] = possible ? either() : TypeSet(type == Type::Real ? vector_ : Type::Real);
      if (!possible) return;
    }
  }

  // Chooses `vectors` of the open parameters, the leftmost choice first. Iterative: `next` is the parameter to
  // decide, and going back turns the last vector that can be moved into a real.
  bool assign(uint32_t vectors) {
    size_t next = 0;
    uint32_t left = vectors;
    while (!is_exhausted()) {
      const bool enough_remain = open_.size() - next >= left;
      if (enough_remain && may_check()) {
        if (next == open_.size()) return true;
        const bool as_vector = left > 0;
        types_[open_[next++]] = as_vector ? vector_ : Type::Real;
        left -= as_vector ? 1 : 0;
        continue;
      }
      while (next > 0 && types_[open_[next - 1]] != TypeSet(vector_)) types_[open_[--next]] = either();
      if (next == 0) return false;
      types_[open_[next - 1]] = Type::Real;
      ++left;
    }
    return false;
  }

  std::vector<Type> chosen() const {
    std::vector<Type> types;
    for (size_t i = 0; i < types_.size(); ++i) {
      const bool is_known = known_[i] != Type::Error;
      types.push_back(is_known ? known_[i] : types_[i].contains(vector_) ? vector_ : Type::Real);
    }
    return types;
  }

  const DefinitionView& view_;
  const ResolvedBody& body_;
  const std::vector<Type>& known_;
  const Times times_;
  const Calls calls_;
  const Type vector_;
  std::vector<TypeSet> types_;  // by parameter
  std::vector<uint32_t> open_;  // parameters that may still be either
  std::vector<TypeSet> values_;
  uint64_t steps_ = 0;
};

}  // namespace

std::optional<std::vector<Type>> infer_parameters(const DefinitionView& view, const ResolvedBody& body,
                                                  const std::vector<Type>& known, Calls calls) {
  for (const Times times : {Times::IsCrossProduct, Times::IsAnyProduct}) {
    if (auto types = Search(view, body, known, times, calls, Type::Vector).run()) return types;
  }
  for (const Type vector : {Type::Vector2, Type::Vector4}) {
    if (auto types = Search(view, body, known, Times::IsAnyProduct, calls, vector).run()) return types;
  }
  return std::nullopt;
}

}  // namespace texbrdf
