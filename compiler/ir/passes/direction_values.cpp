#include "ir/passes/direction_values.h"

namespace texbrdf::ir {

ValueId clamped_cosine(Graph& graph, ValueId a, ValueId b) {
  const ValueId dot = graph.add(Op::Dot, {a, b});
  const ValueId above = graph.add(Op::Max, {dot, graph.constant(-1)});
  return graph.add(Op::Min, {above, graph.constant(1)});
}

ValueId sine_of_polar_angle(Graph& graph, ValueId cosine) {
  const ValueId one = graph.constant(1);
  const ValueId below = graph.add(Op::Subtract, {one, cosine});
  const ValueId above = graph.add(Op::Add, {one, cosine});
  return graph.add(Op::Sqrt, {graph.add(Op::Multiply, {below, above})});
}

Azimuth azimuth_of(Graph& graph, ValueId tangent, ValueId bitangent, ValueId direction) {
  const ValueId x = graph.add(Op::Dot, {direction, tangent});
  const ValueId y = graph.add(Op::Dot, {direction, bitangent});
  const ValueId squares = graph.add(Op::Add, {graph.add(Op::Multiply, {x, x}), graph.add(Op::Multiply, {y, y})});
  const ValueId radius = graph.add(Op::Sqrt, {squares});
  const ValueId zero = graph.constant(0);
  const ValueId at_pole = graph.add(Op::Equal, {radius, zero});
  const ValueId cosine = graph.add(Op::Select, {at_pole, graph.constant(1), graph.add(Op::Divide, {x, radius})});
  const ValueId sine = graph.add(Op::Select, {at_pole, zero, graph.add(Op::Divide, {y, radius})});
  return {cosine, sine};
}

}  // namespace texbrdf::ir
