#include "semantics/infer_parameters.h"

#include <algorithm>

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
                Times times)
      : view_(view), body_(body), parameters_(parameters), times_(times) {}

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

  TypeSet length(TypeSet operand) { return (operand & Type::Error) | Type::Real; }

  TypeSet tuple(NodeId id, const std::vector<TypeSet>& values) {
    TypeSet found = Type::Tuple;
    for (NodeId element : view_.block.tree.children(id)) {
      found = found | (accept(values[view_.slot(element)], Type::Real) & Type::Error);
    }
    return found;
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

  // What of `got` is expected. A poisoned operand is accepted and poisons.
  TypeSet accept(TypeSet got, TypeSet expected) { return checked(got & (expected | Type::Error)); }

  const DefinitionView& view_;
  const ResolvedBody& body_;
  const std::vector<TypeSet>& parameters_;
  const Times times_;
  bool failed_ = false;
};

class Search {
 public:
  Search(const DefinitionView& view, const ResolvedBody& body, const std::vector<Type>& known, Times times)
      : view_(view), body_(body), times_(times), values_(view.slot_count()) {
    for (uint32_t i = 0; i < known.size(); ++i) {
      const bool is_open = known[i] == Type::Error;
      types_.push_back(is_open ? TypeSet::any_value() : TypeSet(known[i]));
      if (is_open) open_.push_back(i);
    }
  }

  std::optional<std::vector<Type>> run() {
    if (!may_check()) return std::nullopt;
    for (uint32_t parameter : open_) narrow(parameter);
    std::erase_if(open_, [&](uint32_t parameter) { return types_[parameter] != TypeSet::any_value(); });
    for (uint32_t vectors = 0; vectors <= open_.size() && !is_exhausted(); ++vectors) {
      if (assign(vectors)) return chosen();
    }
    return std::nullopt;
  }

 private:
  bool is_exhausted() const { return steps_ > kMaxInferenceSteps; }

  bool may_check() {
    steps_ += values_.size();
    PossibleTypes domain(view_, body_, types_, times_);
    TypeWalk<PossibleTypes>(view_, body_, domain).run(values_);
    return !domain.stopped();
  }

  void narrow(uint32_t parameter) {
    for (Type type : {Type::Real, Type::Vector}) {
      if (is_exhausted()) return;
      types_[parameter] = type;
      const bool possible = may_check();
      types_[parameter] = possible ? TypeSet::any_value() : TypeSet(type == Type::Real ? Type::Vector : Type::Real);
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
        types_[open_[next++]] = as_vector ? Type::Vector : Type::Real;
        left -= as_vector ? 1 : 0;
        continue;
      }
      while (next > 0 && types_[open_[next - 1]] != TypeSet(Type::Vector)) types_[open_[--next]] = TypeSet::any_value();
      if (next == 0) return false;
      types_[open_[next - 1]] = Type::Real;
      ++left;
    }
    return false;
  }

  std::vector<Type> chosen() const {
    std::vector<Type> types;
    for (TypeSet set : types_) types.push_back(set.contains(Type::Vector) ? Type::Vector : Type::Real);
    return types;
  }

  const DefinitionView& view_;
  const ResolvedBody& body_;
  const Times times_;
  std::vector<TypeSet> types_;  // by parameter
  std::vector<uint32_t> open_;  // parameters that may still be either
  std::vector<TypeSet> values_;
  uint64_t steps_ = 0;
};

}  // namespace

std::optional<std::vector<Type>> infer_parameters(const DefinitionView& view, const ResolvedBody& body,
                                                  const std::vector<Type>& known) {
  for (const Times times : {Times::IsCrossProduct, Times::IsAnyProduct}) {
    if (auto types = Search(view, body, known, times).run()) return types;
  }
  return std::nullopt;
}

}  // namespace texbrdf
