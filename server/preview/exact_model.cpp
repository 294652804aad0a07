#include "preview/exact_model.h"

#include <algorithm>
#include <utility>

#include "eval/compile.h"
#include "ir/written_out.h"

namespace texbrdf::preview {
namespace {

/// Up to here a model is compiled in some 10 ms.
constexpr uint64_t kMaxWrittenOut = 10'000;

/// Where the flattened graph of all plain definitions has the value of each definition; functions have none.
std::vector<std::size_t> roots_of(const ir::Program& program) {
  std::vector<std::size_t> roots;
  std::size_t next = 1;
  for (const ir::ProgramDefinition& definition : program.definitions) {
    roots.push_back(definition.signature.is_function ? 0 : next++);
  }
  roots.back() = 0;
  return roots;
}

/// The parameters that definitions mention, each where it is first needed.
class QuantityWriter {
 public:
  explicit QuantityWriter(const ir::Program& program) : program_(program), is_written_(program.parameters.size()) {}

  std::vector<Quantity> write() {
    for (uint32_t i = 0; i < program_.definitions.size(); ++i) {
      const ir::ProgramDefinition& definition = program_.definitions[i];
      write_parameters(definition.graph);
      const bool is_root = &definition == &program_.root();
      if (is_root) {
        const bool is_colour = is_triple(definition.signature.result);
        add(Quantity::Kind::Brdf, definition.canonical, is_colour ? Type::Colour : definition.signature.result, i);
      } else if (!definition.signature.is_function) {
        add(Quantity::Kind::Definition, definition.canonical, definition.signature.result, i);
      }
    }
    return std::move(quantities_);
  }

 private:
  void write_parameters(const ir::Graph& graph) {
    for (const ir::Value& value : graph.values()) {
      if (value.op != ir::Op::Parameter || is_written_[value.index]) continue;
      is_written_[value.index] = true;
      const ir::Parameter& parameter = program_.parameters[value.index];
      add(Quantity::Kind::Parameter, parameter.canonical, parameter.type, value.index);
    }
  }

  void add(Quantity::Kind kind, std::string name, Type type, uint32_t index) {
    quantities_.push_back({.kind = kind, .name = std::move(name), .type = type, .index = index});
  }

  const ir::Program& program_;
  std::vector<bool> is_written_;
  std::vector<Quantity> quantities_;
};

}  // namespace

std::vector<Quantity> quantities(const ir::Program& program) {
  return QuantityWriter(program).write();
}

Result<ExactModel> ExactModel::compile(ir::Program program) {
  if (ir::written_out(program, kMaxWrittenOut) > kMaxWrittenOut)
    return Failure{"the equations are too large for values at a point"};
  Result<ir::Graph> brdf = ir::flatten(program);
  if (!brdf) return Failure{brdf.error()};
  Result<ir::Graph> all = ir::flatten(program, true);
  if (!all) return Failure{all.error()};
  return ExactModel(std::move(program), *std::move(brdf), *std::move(all));
}

ExactModel::ExactModel(ir::Program program, ir::Graph brdf, ir::Graph all)
    : program_(std::move(program)),
      parameters_(eval::parameter_values(program_)),
      quantities_(preview::quantities(program_)),
      roots_(roots_of(program_)),
      brdf_(std::move(brdf)),
      all_(std::move(all)) {}

const Quantity* ExactModel::find(std::string_view name) const {
  const auto found = std::ranges::find(quantities_, name, &Quantity::name);
  return found == quantities_.end() ? nullptr : &*found;
}

std::optional<eval::Triple> ExactModel::value(const eval::Geometry& geometry, eval::StepBudget& budget) const {
  return brdf_.evaluate(geometry, parameters_, 0, budget);
}

std::optional<eval::Triple> ExactModel::value(const Quantity& quantity, const eval::Geometry& geometry,
                                              eval::StepBudget& budget) const {
  switch (quantity.kind) {
    case Quantity::Kind::Brdf:
      return value(geometry, budget);
    case Quantity::Kind::Definition:
      return all_.evaluate(geometry, parameters_, roots_[quantity.index], budget);
    case Quantity::Kind::Parameter:
      return parameters_[quantity.index];
  }
  return std::nullopt;
}

std::optional<std::vector<eval::Triple>> ExactModel::values(const eval::Geometry& geometry,
                                                            eval::StepBudget& budget) const {
  const auto definitions = all_.evaluate_all(geometry, parameters_, budget);
  if (!definitions) return std::nullopt;
  std::vector<eval::Triple> values;
  values.reserve(quantities_.size());
  for (const Quantity& quantity : quantities_) {
    const bool is_parameter = quantity.kind == Quantity::Kind::Parameter;
    values.push_back(is_parameter ? parameters_[quantity.index] : (*definitions)[roots_[quantity.index]]);
  }
  return values;
}

}  // namespace texbrdf::preview
