#include <algorithm>
#include <array>

#include "ir/graph.h"

namespace texbrdf::ir {

namespace {

constexpr std::array kOps = {
#define OP(name, printed, least, most, payload, meaning) OpEntry{Op::name, printed, least, most, Payload::payload},
#include "ir/ops.def"
#undef OP
};

bool all_are(std::span<const Type> operands, Type type) {
  return std::all_of(operands.begin(), operands.end(), [type](Type operand) { return operand == type; });
}

/// The kinds of triples are one for graphs: of a mixture the Vector wins.
Type unify(Type a, Type b) {
  if (a == b) return a;
  return is_triple(a) && is_triple(b) ? Type::Vector : Type::Error;
}

bool is_numeric(Type type) {
  return type == Type::Real || is_triple(type);
}

Type elementwise(std::span<const Type> operands) {
  if (!std::all_of(operands.begin(), operands.end(), is_numeric)) return Type::Error;
  if (operands.size() == 1 || operands[1] == Type::Real) return operands[0];
  return operands[0] == Type::Real ? operands[1] : unify(operands[0], operands[1]);
}

Type only(bool fits, Type result) {
  return fits ? result : Type::Error;
}

bool count_fits(Op op, std::size_t count) {
  const OpEntry& entry = op_entry(op);
  const int given = static_cast<int>(count);
  return given >= entry.least_operands && (entry.most_operands < 0 || given <= entry.most_operands);
}

}  // namespace

const OpEntry& op_entry(Op op) {
  return kOps[static_cast<std::size_t>(op)];
}

Type result_type(Op op, std::span<const Type> operands) {
  if (!count_fits(op, operands.size())) return Type::Error;
  switch (op) {
    case Op::Constant:
      return Type::Real;
    case Op::Parameter:
    case Op::Convention:
    case Op::Reference:
    case Op::Formal:
    case Op::BoundVariable:
    case Op::Call:
    case Op::MakeMatrix:
      return Type::Error;
    case Op::Entry:
      return only(is_aggregate(operands[0]), Type::Real);
    case Op::MakeVector:
      return only(all_are(operands, Type::Real), Type::Vector);
    case Op::Component:
      return only(is_triple(operands[0]), Type::Real);
    case Op::Select:
      return operands[0] == Type::Boolean ? unify(operands[1], operands[2]) : Type::Error;
    case Op::Sum:
    case Op::Product:
      return only(all_are(operands.first(2), Type::Real) && is_numeric(operands[2]), operands[2]);
    case Op::Integral:
      return only(is_numeric(operands[0]), operands[0]);
    case Op::Derivative:
      return only(operands[0] == Type::Real && is_numeric(operands[1]), operands[1]);
    case Op::Less:
    case Op::LessEqual:
    case Op::Equal:
      return only(all_are(operands, Type::Real), Type::Boolean);
    case Op::And:
    case Op::Or:
    case Op::Not:
      return only(all_are(operands, Type::Boolean), Type::Boolean);
    case Op::Negate:
    case Op::Add:
    case Op::Subtract:
    case Op::Multiply:
    case Op::Divide:
    case Op::Min:
    case Op::Max:
    case Op::Power:
    case Op::Root:
    case Op::Sqrt:
    case Op::Exp:
    case Op::Ln:
    case Op::Sin:
    case Op::Cos:
    case Op::Tan:
    case Op::Arcsin:
    case Op::Arccos:
    case Op::Arctan:
    case Op::Sinh:
    case Op::Cosh:
    case Op::Tanh:
      return elementwise(operands);
    case Op::Dot:
      return only(is_triple(operands[0]) && is_triple(operands[1]), Type::Real);
    case Op::Cross:
      return is_triple(operands[0]) ? unify(operands[0], operands[1]) : Type::Error;
    case Op::Arctan2:
      return only(all_are(operands, Type::Real), Type::Real);
  }
  return Type::Error;
}

}  // namespace texbrdf::ir
