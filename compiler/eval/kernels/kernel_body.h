// The kernel: one source for every instruction set. Included by each of them with TEXBRDF_LANES (of a register) and
// TEXBRDF_RUN (the name of the function) defined.

#include "eval/kernels/kernel.h"
#include "eval/kernels/vector.h"
#include "eval/limits.h"

namespace texbrdf::eval {
namespace {

using UnaryVector = Vector (*)(Vector);
using BinaryVector = Vector (*)(Vector, Vector);

/// One instruction's slots and lanes.
struct Operation {
  const Instruction& instruction;
  const Slot* slots;
  Index lanes;

  const Slot& slot(Index i) const { return slots[instruction.slots[i]]; }

  template <typename Function>
  void map(Function function) const {
    const Slot out = slot(0);
    for (Index i = 0; i < lanes; i += kLanes) store(out, i, function(i));
  }
  template <typename Function>
  void map1(Function function) const {
    const Slot a = slot(1);
    map([&](Index i) { return function(load(a, i)); });
  }
  template <typename Function>
  void map2(Function function) const {
    const Slot a = slot(1);
    const Slot b = slot(2);
    map([&](Index i) { return function(load(a, i), load(b, i)); });
  }

  /// `function` after `prepare`, in registers or else one lane at a time.
  template <typename Prepare>
  void elementary(const UnaryFunction& function, Prepare prepare) const {
    if (function.vector != nullptr) {
      const auto vector = reinterpret_cast<UnaryVector>(function.vector);
      return map1([&](Vector a) { return vector(prepare(a)); });
    }
    map1([&](Vector a) {
      Vector x = prepare(a);
      for (Index i = 0; i < kLanes; ++i) x[i] = function.scalar(x[i]);
      return x;
    });
  }
  void elementary(const UnaryFunction& function) const {
    elementary(function, [](Vector a) { return a; });
  }

  /// `wrap(a, b, call)` for each register, where `call` is the function.
  template <typename Wrap>
  void elementary2(const BinaryFunction& function, Wrap wrap) const {
    if (function.vector != nullptr) {
      const auto vector = reinterpret_cast<BinaryVector>(function.vector);
      return map2([&](Vector a, Vector b) { return wrap(a, b, vector); });
    }
    map2([&](Vector a, Vector b) {
      return wrap(a, b, [&](Vector x, Vector y) {
        for (Index i = 0; i < kLanes; ++i) x[i] = function.scalar(x[i], y[i]);
        return x;
      });
    });
  }

  bool any_in(const Slot& mask) const {
    Mask joined{};
    for (Index i = 0; i < lanes; i += kLanes) joined |= bits(load(mask, i));
    return any(joined);
  }
};

inline Vector nan() {
  return all(__builtin_nanf(""));
}

/// Arguments up to the tolerance beyond ±1 count as ±1.
inline Vector into_arc_domain(Vector x) {
  const Mask inside = absolute(x) <= static_cast<float>(1 + kArcTolerance);
  return choose(inside, maximum(minimum(x, all(1)), all(-1)), x);
}

/// x^y by `call`, which is asked for positive bases only; real_functions.h has the same in double precision.
template <typename Call>
inline Vector power(Vector x, Vector y, Call call) {
  const Parity exponent = parity(y);
  const Mask negative = x < 0;
  const Vector magnitude = call(absolute(x), y);
  const Vector result = choose(negative & exponent.odd, -magnitude, magnitude);
  return choose((y != y) | (negative & ~exponent.integer), nan(), result);
}

/// |n| of a number that is the same integer n in all lanes and small enough for repeated squaring to be quicker than
/// logarithms; 0 for any other.
inline unsigned small_exponent(const Slot& slot) {
  constexpr float kLargest = 1024;
  if (slot.stride != 0) return 0;
  const float magnitude = __builtin_fabsf(slot.data[0]);
  if (!(magnitude <= kLargest)) return 0;
  const auto whole = static_cast<unsigned>(magnitude);
  return static_cast<float>(whole) == magnitude ? whole : 0;
}

inline Vector repeated_product(Vector x, unsigned count) {
  Vector result = all(1);
  for (; count != 0; count >>= 1) {
    if ((count & 1) != 0) result *= x;
    x *= x;
  }
  return result;
}

inline Vector small_power(Vector x, Vector y, unsigned magnitude) {
  return power(x, y, [magnitude](Vector base, Vector exponent) {
    const Vector product = repeated_product(base, magnitude);
    return choose(exponent < 0, 1 / product, product);
  });
}

template <typename Call>
inline Vector root(Vector x, Vector n, Call call) {
  const Mask negative = x < 0;
  const Vector magnitude = call(absolute(x), 1 / n);
  const Vector result = choose(negative, -magnitude, magnitude);
  return choose((n == 0) | (n != n) | (negative & ~parity(n).odd), nan(), result);
}

void begin_loop(const Operation& op) {
  constexpr float kBound = static_cast<float>(kMaxBound);
  for (Index i = 0; i < op.lanes; i += kLanes) {
    const Vector first = load(op.slot(1), i);
    const Vector last = load(op.slot(2), i);
    const Mask mask = bits(load(op.slot(3), i));
    const Mask integers = parity(first).integer & parity(last).integer;
    const Mask bounded = (absolute(first) <= kBound) & (absolute(last) <= kBound);
    const Mask good = integers & bounded & (last - first < static_cast<float>(kMaxIterations));
    const Mask runs = good & mask & (first <= last);
    store(op.slot(0), i, first);
    store(op.slot(4), i, choose(runs, last - first + 1, Vector{}));
    store(op.slot(5), i, from_bits(good));
  }
}

/// Returns whether to go on. Out of iterations, the lanes that are not done have no good range.
void next_iteration(const Operation& op, bool out_of_iterations) {
  for (Index i = 0; i < op.lanes; i += kLanes) {
    Vector left = load(op.slot(2), i) - 1;
    if (out_of_iterations) {
      store(op.slot(3), i, from_bits(bits(load(op.slot(3), i)) & ~(left > 0)));
      left = Vector{};
    }
    store(op.slot(1), i, load(op.slot(1), i) + 1);
    store(op.slot(2), i, left);
  }
}

void compute(const Operation& op, const ElementaryFunctions& functions) {
  switch (op.instruction.code) {
    case Code::Move:
      return op.map1([](Vector a) { return a; });
    case Code::Negate:
      return op.map1([](Vector a) { return -a; });
    case Code::Add:
      return op.map2([](Vector a, Vector b) { return a + b; });
    case Code::Subtract:
      return op.map2([](Vector a, Vector b) { return a - b; });
    case Code::Multiply:
      return op.map2([](Vector a, Vector b) { return a * b; });
    case Code::Divide:
      return op.map2([](Vector a, Vector b) { return a / b; });
    case Code::Min:
      return op.map2(minimum);
    case Code::Max:
      return op.map2(maximum);
    case Code::Sqrt:
      return op.map1(square_root);
    case Code::Dot: {
      const Slot a = op.slot(1), b = op.slot(2), c = op.slot(3), d = op.slot(4), e = op.slot(5), f = op.slot(6);
      return op.map(
          [&](Index i) { return load(a, i) * load(d, i) + load(b, i) * load(e, i) + load(c, i) * load(f, i); });
    }
    case Code::CrossComponent: {
      const Slot a = op.slot(1), b = op.slot(2), c = op.slot(3), d = op.slot(4);
      return op.map([&](Index i) { return load(a, i) * load(b, i) - load(c, i) * load(d, i); });
    }
    case Code::Exp:
      return op.elementary(functions.Exp);
    case Code::Ln:
      return op.elementary(functions.Ln);
    case Code::Sin:
      return op.elementary(functions.Sin);
    case Code::Cos:
      return op.elementary(functions.Cos);
    case Code::Tan:
      return op.elementary(functions.Tan);
    case Code::Arcsin:
      return op.elementary(functions.Arcsin, into_arc_domain);
    case Code::Arccos:
      return op.elementary(functions.Arccos, into_arc_domain);
    case Code::Arctan:
      return op.elementary(functions.Arctan);
    case Code::Sinh:
      return op.elementary(functions.Sinh);
    case Code::Cosh:
      return op.elementary(functions.Cosh);
    case Code::Tanh:
      return op.elementary(functions.Tanh);
    case Code::Arctan2:
      // Adding 0 turns -0 into +0: angles are in (-pi, pi].
      return op.elementary2(functions.Arctan2,
                            [](Vector y, Vector x, auto call) { return call(y + Vector{}, x + Vector{}); });
    case Code::Power:
      if (const unsigned n = small_exponent(op.slot(2)); n != 0) {
        return op.map2([n](Vector x, Vector y) { return small_power(x, y, n); });
      }
      return op.elementary2(functions.Power, [](Vector x, Vector y, auto call) { return power(x, y, call); });
    case Code::Root:
      return op.elementary2(functions.Power, [](Vector x, Vector n, auto call) { return root(x, n, call); });
    case Code::Less:
      return op.map2([](Vector a, Vector b) { return from_bits(a < b); });
    case Code::LessEqual:
      return op.map2([](Vector a, Vector b) { return from_bits(a <= b); });
    case Code::Equal:
      return op.map2([](Vector a, Vector b) { return from_bits(a == b); });
    case Code::And:
      return op.map2([](Vector a, Vector b) { return from_bits(bits(a) & bits(b)); });
    case Code::AndNot:
      return op.map2([](Vector a, Vector b) { return from_bits(bits(a) & ~bits(b)); });
    case Code::Or:
      return op.map2([](Vector a, Vector b) { return from_bits(bits(a) | bits(b)); });
    case Code::Select: {
      const Slot condition = op.slot(1), a = op.slot(2), b = op.slot(3);
      return op.map([&](Index i) { return choose(bits(load(condition, i)), load(a, i), load(b, i)); });
    }
    case Code::BeginLoop:
      return begin_loop(op);
    case Code::LoopTest:
      return op.map1([](Vector left) { return from_bits(left > 0); });
    case Code::SkipUnlessAny:
    case Code::NextIteration:
      return;
  }
}

/// What the instruction decides beyond its lanes: whether to go to its target.
bool jumps(const Operation& op, unsigned& iterations) {
  const Code code = op.instruction.code;
  if (code == Code::SkipUnlessAny) return !op.any_in(op.slot(1));
  if (code == Code::LoopTest) return !op.any_in(op.slot(0));
  if (code != Code::NextIteration) return false;
  next_iteration(op, ++iterations >= kMaxTotalIterations);
  return true;
}

}  // namespace

void TEXBRDF_RUN(const Instruction* instructions, unsigned count, const Slot* slots, Index lanes,
                 const ElementaryFunctions& functions) {
  unsigned iterations = 0;
  for (unsigned at = 0; at < count;) {
    const Operation op{instructions[at], slots, lanes};
    compute(op, functions);
    at = jumps(op, iterations) ? op.instruction.target : at + 1;
  }
}

}  // namespace texbrdf::eval
