#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "preview/bad_values.h"

namespace texbrdf::preview {
namespace {

using render::BadPixel;

template <typename Predicate>
bool any_component(const Quantity& quantity, const eval::Triple& value, Predicate is_so) {
  return std::ranges::any_of(std::span(value).first(type_components(quantity.type)), is_so);
}

/// Whether a value can make another one bad that is computed from it.
bool is_source(BadPixel kind, const Quantity& quantity, const eval::Triple& value) {
  switch (kind) {
    case BadPixel::NotANumber:
      return any_component(quantity, value, [](double x) { return std::isnan(x); });
    case BadPixel::Infinite:
      return any_component(quantity, value, [](double x) { return std::isinf(x); });
    case BadPixel::Negative:
      return quantity.type != Type::Vector && any_component(quantity, value, [](double x) { return x < 0; });
  }
  return false;
}

/// What quantities need, as indices of ExactModel::quantities.
class Needs {
 public:
  explicit Needs(const ExactModel& model)
      : program_(model.program()),
        by_definition_(program_.definitions.size()),
        by_parameter_(program_.parameters.size()) {
    const std::span<const Quantity> quantities = model.quantities();
    for (uint32_t i = 0; i < quantities.size(); ++i) {
      const bool is_parameter = quantities[i].kind == Quantity::Kind::Parameter;
      (is_parameter ? by_parameter_ : by_definition_)[quantities[i].index] = i;
    }
  }

  /// In order of need: directly, or by the functions that are called.
  std::vector<uint32_t> of(const Quantity& quantity) const {
    std::vector<uint32_t> needs;
    if (quantity.kind == Quantity::Kind::Parameter) return needs;
    std::vector<uint32_t> functions = {quantity.index};
    for (std::size_t next = 0; next < functions.size(); ++next) {
      for (const ir::Value& value : program_.definitions[functions[next]].graph.values()) {
        if (value.op == ir::Op::Reference) needs.push_back(by_definition_[value.index]);
        if (value.op == ir::Op::Parameter) needs.push_back(by_parameter_[value.index]);
        if (value.op == ir::Op::Call) functions.push_back(value.index);
      }
    }
    std::ranges::sort(needs);
    return needs;
  }

 private:
  const ir::Program& program_;
  std::vector<uint32_t> by_definition_;
  std::vector<uint32_t> by_parameter_;
};

}  // namespace

const Quantity& origin_of(const ExactModel& model, std::span<const eval::Triple> values, BadPixel kind) {
  const std::span<const Quantity> quantities = model.quantities();
  const Needs needs(model);
  const auto first_source = [&](const Quantity& user, BadPixel wanted) -> const Quantity* {
    for (const uint32_t need : needs.of(user)) {
      if (is_source(wanted, quantities[need], values[need])) return &quantities[need];
    }
    return nullptr;
  };
  const Quantity* origin = &model.brdf();
  while (true) {
    const Quantity* source = first_source(*origin, kind);
    if (source == nullptr && kind == BadPixel::NotANumber) {
      source = first_source(*origin, BadPixel::Infinite);
      if (source != nullptr) kind = BadPixel::Infinite;
    }
    if (source == nullptr) return *origin;
    origin = source;
  }
}

}  // namespace texbrdf::preview
