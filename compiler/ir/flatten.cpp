#include <fmt/format.h>

#include <map>
#include <optional>

#include "ir/program.h"
#include "source/internal_error.h"

namespace texbrdf::ir {

namespace {

/// One use of a function: equal uses give the same value.
struct Instance {
  uint32_t function;
  std::vector<ValueId> arguments;
  friend auto operator<=>(const Instance&, const Instance&) = default;
};

/// Copies definitions into one graph. Calls nest on a stack of its own: a function may call through thousands of
/// others.
class Flattener {
 public:
  explicit Flattener(const Program& program)
      : program_(program),
        plain_(program.definitions.size()),
        parameters_(program.parameters.size()),
        conventions_(conventions().size()) {}

  Result<Graph> run(bool all_plain) {
    for (uint32_t i = 0; i < program_.definitions.size(); ++i) {
      const ProgramDefinition& definition = program_.definitions[i];
      const bool is_root = i + 1 == program_.definitions.size();
      if (definition.signature.is_function && !is_root) continue;
      if (!has_brdf_parameters(definition.signature)) {
        return Failure{fmt::format("`{}` is no function of two vectors", definition.canonical)};
      }
      if (auto failure = expand_definition(i)) return *std::move(failure);
    }
    flat_.roots.push_back(last_result_);
    if (all_plain) add_plain_roots();
    return std::move(flat_);
  }

 private:
  struct Frame {
    Instance instance;
    uint32_t next_value = 0;
    std::vector<ValueId> values;           ///< by id in the definition's own graph
    std::map<uint32_t, uint32_t> binders;  ///< of the definition → of the flat graph
    std::optional<ValueId> called;         ///< result of the call at next_value
  };

  const ProgramDefinition& definition(const Frame& frame) const {
    return program_.definitions[frame.instance.function];
  }

  void add_plain_roots() {
    for (uint32_t i = 0; i < program_.definitions.size(); ++i) {
      if (!program_.definitions[i].signature.is_function) flat_.roots.push_back(plain_[i]);
    }
  }

  std::optional<Failure> expand_definition(uint32_t index) {
    std::vector<ValueId> arguments;
    if (program_.definitions[index].signature.is_function) {
      arguments = {convention(Convention::OmegaI), convention(Convention::OmegaO)};
    }
    open({index, std::move(arguments)});
    while (!stack_.empty()) {
      if (auto failure = step()) return failure;
    }
    return std::nullopt;
  }

  void open(Instance instance) {
    Frame frame;
    frame.instance = std::move(instance);
    frame.values.reserve(program_.definitions[frame.instance.function].graph.size());
    stack_.push_back(std::move(frame));
  }

  /// Copies values of the innermost definition up to a call that must be expanded first, or to its end.
  std::optional<Failure> step() {
    const std::size_t depth = stack_.size();
    while (stack_.size() == depth) {
      Frame& frame = stack_.back();
      const Graph& graph = definition(frame).graph;
      if (frame.next_value == graph.size()) {
        close();
        break;
      }
      if (auto failure = copy_next(frame, graph)) return failure;
    }
    return std::nullopt;
  }

  void close() {
    Frame frame = std::move(stack_.back());
    stack_.pop_back();
    const ProgramDefinition& done = definition(frame);
    last_result_ = frame.values[done.graph.roots[0].value];
    if (!stack_.empty()) stack_.back().called = last_result_;
    if (done.signature.is_function) {
      instances_.emplace(std::move(frame.instance), last_result_);
    } else {
      plain_[frame.instance.function] = last_result_;
    }
  }

  std::optional<Failure> copy_next(Frame& frame, const Graph& graph) {
    if (++steps_ > kMaxFlatValues) {
      return Failure{fmt::format("more than {} values when every call is written out; `{}` is called too often",
                                 kMaxFlatValues, definition(frame).canonical)};
    }
    const ValueId id{frame.next_value};
    std::vector<ValueId> operands;
    for (const ValueId operand : graph.operands(id)) operands.push_back(frame.values[operand.value]);
    const Value& value = graph.at(id);
    if (value.op == Op::Call) return copy_call({value.index, std::move(operands)});
    if (is_binding(value.op) && !has_binder(frame, value.index)) {
      return Failure{fmt::format("more than {} sums and products when every call is written out", kMaxBinders)};
    }
    finish(frame, copy(frame, value, operands));
    return std::nullopt;
  }

  void finish(Frame& frame, ValueId result) {
    frame.values.push_back(result);
    frame.called.reset();
    ++frame.next_value;
  }

  std::optional<Failure> copy_call(Instance instance) {
    Frame& frame = stack_.back();
    if (frame.called) {
      finish(frame, *frame.called);
    } else if (const auto known = instances_.find(instance); known != instances_.end()) {
      finish(frame, known->second);
    } else {
      open(std::move(instance));
    }
    return std::nullopt;
  }

  ValueId copy(Frame& frame, Value value, std::span<const ValueId> operands) {
    if (value.op == Op::Formal) return frame.instance.arguments[value.index];
    if (value.op == Op::Reference) return plain_[value.index];
    if (value.op == Op::Parameter) return parameter(value);
    if (value.op == Op::Convention && operands.empty()) return convention(static_cast<Convention>(value.index));
    if (is_binding(value.op)) value.index = frame.binders.at(value.index);
    return flat_.copy(value, operands);
  }

  ValueId parameter(const Value& value) {
    ValueId& known = parameters_[value.index];
    if (!known.valid()) known = flat_.copy(value, {});
    return known;
  }

  ValueId convention(Convention id) {
    ValueId& known = conventions_[static_cast<std::size_t>(id)];
    if (!known.valid()) known = flat_.convention(id);
    return known;
  }

  static bool is_binding(Op op) { return op == Op::BoundVariable || binds(op); }

  /// Each instance has binders of its own. False where the graph has no more.
  bool has_binder(Frame& frame, uint32_t binder) {
    if (frame.binders.contains(binder)) return true;
    if (flat_.binder_count() == kMaxBinders) return false;
    frame.binders.emplace(binder, flat_.new_binder());
    return true;
  }

  const Program& program_;
  Graph flat_;
  uint32_t steps_ = 0;
  std::vector<ValueId> plain_;
  std::vector<ValueId> parameters_;
  std::vector<ValueId> conventions_;
  std::map<Instance, ValueId> instances_;
  std::vector<Frame> stack_;
  ValueId last_result_;
};

}  // namespace

Result<Graph> flatten(const Program& program, bool all_plain) {
  require(!program.definitions.empty(), "flatten of a program without a root");
  return Flattener(program).run(all_plain);
}

}  // namespace texbrdf::ir
