#include <bit>
#include <initializer_list>
#include <limits>
#include <unordered_map>

#include "eval/demand.h"
#include "eval/schedule.h"
#include "eval/tape_registers.h"
#include "source/internal_error.h"

namespace texbrdf::eval {

namespace {

using ir::Op;
using ir::ValueId;
using Triplet = std::array<Register, 3>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

bool is_input(Convention id) {
  return convention_entry(id).operands.empty() && !convention_constant(id);
}

/// The first of the three slots of an input.
Register input_register(Convention input) {
  switch (input) {
    case Convention::OmegaI:
      return 0;
    case Convention::OmegaO:
      return 3;
    case Convention::Normal:
      return 6;
    case Convention::Tangent:
      return 9;
    case Convention::Bitangent:
      return 12;
    default:
      throw InternalError("a convention that should have been expanded");
  }
}

/// For each value, whether it is the same for all geometries.
std::vector<bool> find_uniform(const ir::Graph& graph) {
  std::vector<bool> uniform(graph.size());
  for (uint32_t i = 0; i < graph.size(); ++i) {
    const ir::Value& v = graph.at({i});
    uniform[i] = v.op != Op::Convention || !is_input(static_cast<Convention>(v.index));
    for (const ValueId operand : graph.operands({i})) uniform[i] = uniform[i] && uniform[operand.value];
  }
  return uniform;
}

class TapeWriter {
 public:
  explicit TapeWriter(const ir::Graph& graph)
      : graph_(graph),
        schedule_(schedule(graph)),
        demanded_(demanded_components(graph)),
        uniform_(find_uniform(graph)),
        registers_(graph.size()),
        loops_(graph.binder_count()) {
    tape_.is_uniform.assign(kInputSlots, false);
  }

  RegisterTape write() {
    std::vector<RootEnd> ends(schedule_.steps.size() + 1);
    for (uint32_t at = 0; at < schedule_.steps.size(); ++at) {
      close_regions(at);
      write_step(schedule_.steps[at]);
      ends[at + 1] = {size_of(tape_.prologue), size_of(tape_.body)};
    }
    close_regions(static_cast<uint32_t>(schedule_.steps.size()));
    for (std::size_t i = 0; i < graph_.roots.size(); ++i) {
      const RootEnd& end = ends[schedule_.root_end[i]];
      const Triplet result = components(graph_.roots[i]);
      for (const Register r : result) read(r);
      tape_.roots.push_back({result, end.prologue, end.body});
    }
    return std::move(tape_);
  }

 private:
  struct RootEnd {
    uint32_t prologue = 0;
    uint32_t body = 0;
  };
  /// A branch that is being written.
  struct Branch {
    uint32_t end;   ///< the step behind it
    uint32_t skip;  ///< the instruction that jumps over it
    Register outer_mask;
  };
  /// A reduction that is being written.
  struct OpenLoop {
    Register variable;
    Register left;
    Register good;
    Register active;
    Register outer_mask;
    uint32_t test;  ///< its LoopTest
    uint32_t loop;  ///< in List::loops
    uint32_t enclosing;
  };
  static constexpr Register kEverywhere = UINT32_MAX;

  static uint32_t size_of(const RegisterTape::List& list) { return static_cast<uint32_t>(list.instructions.size()); }

  /// Of what no root demands the operands have no registers.
  void write_step(const Step& step) {
    if (demanded_[step.value.value] == 0) return;
    if (depth_ == 0) list_ = uniform_[step.value.value] ? &tape_.prologue : &tape_.body;
    switch (step.kind) {
      case Step::Kind::Compute:
        return write_value(step.value);
      case Step::Kind::IfTrue:
      case Step::Kind::IfFalse:
        return open_branch(step);
      case Step::Kind::BeginLoop:
        return open_loop(step.value);
      case Step::Kind::EndLoop:
        return close_loop(step.value);
    }
  }

  // Registers and instructions.

  Register new_register() {
    tape_.is_uniform.push_back(list_ == &tape_.prologue);
    return tape_.register_count() - 1;
  }

  uint32_t append(Code code, Register out, std::initializer_list<Register> inputs, uint32_t target = 0) {
    Instruction instruction{.code = code, .target = target, .slots = {}};
    instruction.slots[0] = out;
    uint32_t next = 1;
    for (const Register input : inputs) instruction.slots[next++] = read(input);
    list_->instructions.push_back(instruction);
    list_->loop_of.push_back(loop_);
    return size_of(*list_) - 1;
  }

  Register emit(Code code, std::initializer_list<Register> inputs) {
    const Register out = new_register();
    append(code, out, inputs);
    return out;
  }

  Register read(Register input) {
    if (input < kInputSlots) tape_.uses_input[input] = true;
    return input;
  }

  Register uniform_register() {
    tape_.is_uniform.push_back(true);
    return tape_.register_count() - 1;
  }

  Register constant(float number) {
    const auto [known, is_new] = constants_.try_emplace(std::bit_cast<uint32_t>(number));
    if (is_new) {
      known->second = uniform_register();
      tape_.constants.emplace_back(known->second, number);
    }
    return known->second;
  }

  Register all_lanes() { return constant(std::bit_cast<float>(UINT32_MAX)); }

  Register component(ValueId value, uint32_t i) const {
    return registers_[value.value][is_triple(graph_.at(value).type) ? i : 0];
  }
  Register operand(ValueId value, uint32_t i, uint32_t of = 0) const { return component(graph_.operand(value, i), of); }
  Triplet components(ValueId value) const { return {component(value, 0), component(value, 1), component(value, 2)}; }

  // Regions.

  Register mask_or_all() { return mask_ == kEverywhere ? all_lanes() : mask_; }

  void open_branch(const Step& step) {
    const Register condition = operand(step.value, 0);
    const bool if_true = step.kind == Step::Kind::IfTrue;
    Register inner = condition;
    if (!if_true) {
      inner = emit(Code::AndNot, {mask_or_all(), condition});
    } else if (mask_ != kEverywhere) {
      inner = emit(Code::And, {mask_, condition});
    }
    const uint32_t skip = append(Code::SkipUnlessAny, 0, {inner});
    branches_.push_back({.end = step.target, .skip = skip, .outer_mask = mask_});
    mask_ = inner;
    ++depth_;
  }

  /// Branches that end before step `at`.
  void close_regions(uint32_t at) {
    while (!branches_.empty() && branches_.back().end == at) {
      list_->instructions[branches_.back().skip].target = size_of(*list_);
      mask_ = branches_.back().outer_mask;
      branches_.pop_back();
      --depth_;
    }
  }

  void open_loop(ValueId value) {
    const ir::Value& v = graph_.at(value);
    OpenLoop& loop = loops_[v.index];
    loop = {.variable = new_register(),
            .left = new_register(),
            .good = new_register(),
            .active = 0,
            .outer_mask = mask_,
            .test = 0,
            .loop = static_cast<uint32_t>(list_->loops.size()),
            .enclosing = loop_};
    append(Code::BeginLoop, loop.variable, {operand(value, 0), operand(value, 1), mask_or_all(), loop.left, loop.good});
    for_each_component(value, [&](uint32_t i) {
      registers_[value.value][i] = emit(Code::Move, {constant(v.op == Op::Sum ? 0.0F : 1.0F)});
    });
    list_->loops.push_back({.begin = size_of(*list_), .end = 0, .parent = loop_});
    loop_ = loop.loop;
    loop.active = new_register();
    loop.test = append(Code::LoopTest, loop.active, {loop.left});
    mask_ = loop.active;
    ++depth_;
  }

  void close_loop(ValueId value) {
    const ir::Value& v = graph_.at(value);
    const OpenLoop& loop = loops_[v.index];
    const Code code = v.op == Op::Sum ? Code::Add : Code::Multiply;
    for_each_component(value, [&](uint32_t i) {
      const Register result = registers_[value.value][i];
      const Register next = emit(code, {result, operand(value, 2, i)});
      append(Code::Select, result, {loop.active, next, result});
    });
    append(Code::NextIteration, 0, {loop.variable, loop.left, loop.good}, loop.test);
    list_->loops[loop.loop].end = size_of(*list_);
    list_->instructions[loop.test].target = size_of(*list_);
    mask_ = loop.outer_mask;
    loop_ = loop.enclosing;
    --depth_;
    for_each_component(value, [&](uint32_t i) {
      const Register result = registers_[value.value][i];
      append(Code::Select, result, {loop.good, result, constant(kNan)});
    });
  }

  // Values.

  template <typename Action>
  void for_each_component(ValueId value, Action action) {
    for (uint32_t i = 0; i < 3; ++i) {
      if ((demanded_[value.value] & (1u << i)) != 0) action(i);
    }
  }

  void elementwise(ValueId value, Code code) {
    const auto operands = graph_.operands(value);
    for_each_component(value, [&](uint32_t i) {
      registers_[value.value][i] = operands.size() == 1
                                       ? emit(code, {component(operands[0], i)})
                                       : emit(code, {component(operands[0], i), component(operands[1], i)});
    });
  }

  void write_value(ValueId value) {
    const ir::Value& v = graph_.at(value);
    Triplet& out = registers_[value.value];
    switch (v.op) {
      case Op::Constant:
        out[0] = constant(static_cast<float>(v.constant));
        return;
      case Op::Parameter:
        for_each_component(value, [&](uint32_t i) {
          out[i] = uniform_register();
          tape_.parameters.push_back({.slot = out[i], .parameter = v.index, .component = i});
        });
        return;
      case Op::Convention:
        return write_convention(value);
      case Op::BoundVariable:
        out[0] = loops_[v.index].variable;
        return;
      case Op::MakeVector:
        for_each_component(value, [&](uint32_t i) { out[i] = operand(value, i); });
        return;
      case Op::Component:
        out[0] = operand(value, 0, v.index);
        return;
      case Op::Select:
        for_each_component(value, [&](uint32_t i) {
          out[i] = emit(Code::Select, {operand(value, 0), operand(value, 1, i), operand(value, 2, i)});
        });
        return;
      case Op::Not:
        out[0] = emit(Code::AndNot, {all_lanes(), operand(value, 0)});
        return;
      case Op::Dot: {
        const Triplet a = components(graph_.operand(value, 0));
        const Triplet b = components(graph_.operand(value, 1));
        out[0] = emit(Code::Dot, {a[0], a[1], a[2], b[0], b[1], b[2]});
        return;
      }
      case Op::Cross: {
        const Triplet a = components(graph_.operand(value, 0));
        const Triplet b = components(graph_.operand(value, 1));
        for_each_component(value, [&](uint32_t i) {
          const uint32_t j = (i + 1) % 3;
          const uint32_t k = (i + 2) % 3;
          out[i] = emit(Code::CrossComponent, {a[j], b[k], a[k], b[j]});
        });
        return;
      }
#define ELEMENTWISE(Name) \
  case Op::Name:          \
    return elementwise(value, Code::Name);
        ELEMENTWISE(Negate)
        ELEMENTWISE(Add)
        ELEMENTWISE(Subtract)
        ELEMENTWISE(Multiply)
        ELEMENTWISE(Divide)
        ELEMENTWISE(Min)
        ELEMENTWISE(Max)
        ELEMENTWISE(Power)
        ELEMENTWISE(Root)
        ELEMENTWISE(Sqrt)
        ELEMENTWISE(Exp)
        ELEMENTWISE(Ln)
        ELEMENTWISE(Sin)
        ELEMENTWISE(Cos)
        ELEMENTWISE(Tan)
        ELEMENTWISE(Arcsin)
        ELEMENTWISE(Arccos)
        ELEMENTWISE(Arctan)
        ELEMENTWISE(Arctan2)
        ELEMENTWISE(Sinh)
        ELEMENTWISE(Cosh)
        ELEMENTWISE(Tanh)
        ELEMENTWISE(Less)
        ELEMENTWISE(LessEqual)
        ELEMENTWISE(Equal)
        ELEMENTWISE(And)
        ELEMENTWISE(Or)
#undef ELEMENTWISE
      case Op::Reference:
      case Op::Formal:
      case Op::Call:
      case Op::Sum:
      case Op::Product:
      case Op::Integral:
      case Op::Derivative:
      case Op::MakeMatrix:
      case Op::Entry:
        break;
    }
    throw InternalError("an op that flattening or the schedule should have taken away");
  }

  void write_convention(ValueId value) {
    const auto id = static_cast<Convention>(graph_.at(value).index);
    Triplet& out = registers_[value.value];
    if (const auto number = convention_constant(id)) {
      out[0] = constant(static_cast<float>(*number));
      return;
    }
    const Register first = input_register(id);
    out = {first, first + 1, first + 2};
  }

  const ir::Graph& graph_;
  Schedule schedule_;
  std::vector<uint8_t> demanded_;
  std::vector<bool> uniform_;
  std::vector<Triplet> registers_;  ///< by value; of those components only that are demanded
  std::vector<OpenLoop> loops_;     ///< by binder
  std::vector<Branch> branches_;
  std::unordered_map<uint32_t, Register> constants_;  ///< by their bits
  RegisterTape tape_;
  RegisterTape::List* list_ = &tape_.body;
  Register mask_ = kEverywhere;  ///< of the lanes that need what is being written
  uint32_t loop_ = RegisterTape::kNoLoop;
  uint32_t depth_ = 0;  ///< of regions
};

}  // namespace

RegisterTape write_registers(const ir::Graph& graph) {
  return TapeWriter(graph).write();
}

}  // namespace texbrdf::eval
