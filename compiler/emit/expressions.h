#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>

#include "emit/code.h"
#include "emit/helpers.h"
#include "emit/ranges.h"
#include "ir/graph.h"

namespace texbrdf::emit {

/// A number of any sign, NaN and infinities included.
ExpressionId write_number(ExpressionPool& pool, double number);

/// Writes single values of one graph as expressions of GLSL; what stands for the operands is decided outside.
class ExpressionWriter {
 public:
  /// `uses[i]`: how many operands and roots value i is.
  ExpressionWriter(ExpressionPool& pool, const ir::Graph& graph, std::span<const Range> ranges,
                   std::span<const uint32_t> uses, std::set<HelperUse>& helpers)
      : pool_(pool), graph_(graph), ranges_(ranges), uses_(uses), helpers_(helpers) {}

  /// `written[i]` is what stands for value i. Not for leaves that are names, calls and reductions.
  ExpressionId write(ir::ValueId id, std::span<const ExpressionId> written);

 private:
  ExpressionId operand(ir::ValueId id, uint32_t index) const { return written_[graph_.operand(id, index).value]; }
  /// Of an operand, or of each of its components.
  Range range(ir::ValueId id, uint32_t index) const;
  bool is_triple_value(ir::ValueId id) const { return is_triple(graph_.at(id).type); }
  std::vector<ExpressionId> operands(ir::ValueId id) const;
  /// Of the type of the value: a real beside a triple is written `vec3(x)`.
  std::vector<ExpressionId> spread_operands(ir::ValueId id);
  ExpressionId number(double value) { return write_number(pool_, value); }
  ExpressionId infix(Precedence precedence, std::string_view op, ExpressionId left, ExpressionId right) {
    return pool_.infix(precedence, op, left, right);
  }
  ExpressionId helper(Helper helper, std::vector<ExpressionId> arguments, bool of_triples);
  ExpressionId dot_operands(ir::ValueId id, uint32_t first, uint32_t second);
  ExpressionId clamped(ExpressionId x) { return pool_.call("clamp", {x, number(-1), number(1)}); }

  ExpressionId product(ExpressionId left, ExpressionId right);
  ExpressionId quotient(ir::ValueId id);
  bool is_repeated(ExpressionId id, std::string_view name) const;
  ExpressionId convention(ir::ValueId id);
  ExpressionId extremum(ir::ValueId id);
  std::optional<ExpressionId> clamp(ir::ValueId id);
  ExpressionId power(ir::ValueId id);
  ExpressionId whole_power(ExpressionId base, uint32_t exponent, bool of_triples);
  ExpressionId inverse_cosine_or_sine(ir::ValueId id, std::string_view function, Helper tolerant);

  ExpressionPool& pool_;
  const ir::Graph& graph_;
  std::span<const Range> ranges_;
  std::span<const uint32_t> uses_;
  std::set<HelperUse>& helpers_;
  std::span<const ExpressionId> written_;
};

}  // namespace texbrdf::emit
