#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "emit/code.h"
#include "emit/directions.h"
#include "emit/helpers.h"
#include "emit/ranges.h"
#include "emit/scope.h"

namespace texbrdf::emit {

/// A value that is declared, instead of written at each place of use.
struct Local {
  std::string name;          ///< empty: the value is no local
  Equation equation;         ///< above its declaration
  bool has_meaning = false;  ///< its name says what it is, so it may stand above the equation that uses it
};

/// How one function's values are written; by index of the value.
struct BodyPlan {
  std::vector<uint32_t> uses;  ///< how many operands and roots it is; 0: not needed
  std::vector<Local> locals;
  std::vector<ExpressionId> values;   ///< what it is
  std::vector<ExpressionId> written;  ///< what stands for it where it is used
  std::vector<Convention> constants;  ///< pi and epsilon, where needed
  std::map<uint32_t, std::string> binders;
};

/// Decides which values are locals: where that shortens the code, where their names read better than they do, and
/// where expressions would nest too deeply.
BodyPlan plan_body(ExpressionPool& pool, const GraphWithDirections& directions, const std::vector<Range>& ranges,
                   const std::vector<BodyItem>& items, FunctionScope& scope, std::set<HelperUse>& helpers);

/// The bounds of a Sum or Product whose loop counts in integers: known beforehand, and few enough.
std::optional<std::pair<int, int>> integer_bounds(const ir::Graph& graph, ir::ValueId reduction);
/// More iterations make a Sum or Product NaN: drivers cut loops off there.
inline constexpr int kMostIterations = 65'535;

}  // namespace texbrdf::emit
