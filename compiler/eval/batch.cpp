#include "eval/batch.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "eval/tape.h"
#include "ir/passes/passes.h"
#include "source/internal_error.h"

namespace texbrdf::eval {

namespace {

constexpr uint32_t kBatchLanes = 128;
/// A tape with many slots gets short batches: its memory stays bounded, and the cache is lost anyway.
constexpr uint32_t kManySlots = 4096;

Kernel kernel_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::Sse2:
      return run_sse2;
    case InstructionSet::Avx2:
      return run_avx2;
    case InstructionSet::Avx512:
      return run_avx512;
  }
  return run_sse2;
}

using Inputs = std::array<const float*, kInputSlots>;

Inputs inputs_of(const GeometryBatch& geometry) {
  Inputs inputs{};
  auto* next = inputs.begin();
  for (const auto& vector : {geometry.light, geometry.view, geometry.normal, geometry.tangent, geometry.bitangent}) {
    next = std::copy(vector.begin(), vector.end(), next);
  }
  return inputs;
}

/// The memory of one run of a tape over many batches.
class Frame {
 public:
  Frame(const Tape& tape, Kernel kernel, const ElementaryFunctions& functions)
      : tape_(tape),
        kernel_(kernel),
        functions_(functions),
        lanes_(tape.lane_slots > kManySlots ? kUniformLanes : kBatchLanes),
        memory_(std::size_t{tape.uniform_slots} * kUniformLanes +
                (std::size_t{tape.lane_slots} + kInputSlots) * lanes_) {
    slots_.resize(kInputSlots + tape.uniform_slots + tape.lane_slots);
    float* next = memory_.data();
    padding_ = std::exchange(next, next + std::size_t{kInputSlots} * lanes_);
    for (uint32_t i = 0; i < tape.uniform_slots; ++i) {
      slots_[kInputSlots + i] = {.data = std::exchange(next, next + kUniformLanes), .stride = 0};
    }
    for (uint32_t i = kInputSlots + tape.uniform_slots; i < slots_.size(); ++i) {
      slots_[i] = {.data = std::exchange(next, next + lanes_), .stride = 1};
    }
  }

  uint32_t lanes() const { return lanes_; }

  void run_prologue(std::span<const Triple> parameters, const Tape::Root& root) {
    for (const TapeConstant& constant : tape_.constants) fill(constant.slot, constant.number);
    for (const TapeParameter& parameter : tape_.parameters) {
      require(parameter.parameter < parameters.size(), "a parameter without a value");
      fill(parameter.slot, static_cast<float>(parameters[parameter.parameter][parameter.component]));
    }
    kernel_(tape_.prologue.data(), root.prologue_end, slots_.data(), 1, functions_);
  }

  /// Geometries [first, first + count); count is at most lanes().
  void run_batch(const Inputs& inputs, std::size_t first, uint32_t count, const Tape::Root& root) {
    for (uint32_t i = 0; i < kInputSlots; ++i) {
      if (tape_.uses_input[i]) slots_[i] = {.data = input(inputs[i] + first, i, count), .stride = 1};
    }
    kernel_(tape_.body.data(), root.body_end, slots_.data(), lanes_, functions_);
  }

  void copy_result(uint32_t slot, float* out, uint32_t count) const {
    const Slot& result = slots_[slot];
    if (result.stride == 0) {
      std::fill_n(out, count, result.data[0]);
    } else {
      std::copy_n(result.data, count, out);
    }
  }

 private:
  void fill(uint32_t slot, float number) { std::fill_n(slots_[slot].data, kUniformLanes, number); }

  /// Where the input can be read for all lanes: where it is, or a copy that repeats the first geometry behind the last.
  float* input(const float* given, uint32_t index, uint32_t count) {
    // Inputs are only read: no instruction has an input slot as output.
    if (count == lanes_) return const_cast<float*>(given);
    float* padded = padding_ + std::size_t{index} * lanes_;
    std::copy_n(given, count, padded);
    std::fill_n(padded + count, lanes_ - count, given[0]);
    return padded;
  }

  const Tape& tape_;
  Kernel kernel_;
  const ElementaryFunctions& functions_;
  uint32_t lanes_;
  std::vector<float> memory_;
  float* padding_;
  std::vector<Slot> slots_;
};

bool has_compound_convention(const ir::Graph& graph) {
  return std::any_of(graph.values().begin(), graph.values().end(),
                     [](const ir::Value& value) { return value.op == ir::Op::Convention && value.operand_count > 0; });
}

}  // namespace

BatchEvaluator::BatchEvaluator(const ir::Graph& graph, InstructionSet set)
    : BatchEvaluator(graph, set, load_elementary_functions(set)) {}

BatchEvaluator::BatchEvaluator(const ir::Graph& graph, InstructionSet set, const ElementaryFunctions& functions)
    : tape_(std::make_unique<Tape>(build_tape(has_compound_convention(graph) ? ir::expand_conventions(graph) : graph))),
      set_(set),
      functions_(&functions) {
  require(has_instruction_set(set), "an instruction set that this machine does not have");
}

BatchEvaluator::BatchEvaluator(BatchEvaluator&&) noexcept = default;
BatchEvaluator& BatchEvaluator::operator=(BatchEvaluator&&) noexcept = default;
BatchEvaluator::~BatchEvaluator() = default;

void BatchEvaluator::evaluate(const GeometryBatch& geometry, std::span<const Triple> parameters,
                              std::array<float*, 3> out, std::size_t root) const {
  require(root < tape_->roots.size(), "a root that the graph does not have");
  const Tape::Root& end = tape_->roots[root];
  const Inputs inputs = inputs_of(geometry);
  Frame frame(*tape_, kernel_of(set_), *functions_);
  frame.run_prologue(parameters, end);
  for (std::size_t first = 0; first < geometry.count; first += frame.lanes()) {
    const auto count = static_cast<uint32_t>(std::min<std::size_t>(frame.lanes(), geometry.count - first));
    frame.run_batch(inputs, first, count, end);
    for (uint32_t i = 0; i < 3; ++i) frame.copy_result(end.slots[i], out[i] + first, count);
  }
}

}  // namespace texbrdf::eval
