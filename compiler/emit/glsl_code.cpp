#include "emit/glsl_code.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "emit/expressions.h"
#include "emit/helpers.h"
#include "emit/number.h"
#include "emit/write_body.h"
#include "ir/passes/passes.h"

namespace texbrdf::emit {
namespace {

constexpr std::array kInputs{Convention::OmegaI, Convention::OmegaO, Convention::Normal, Convention::Tangent,
                             Convention::Bitangent};

class CodeWriter {
 public:
  CodeWriter(const ir::Program& program, const Dialect& dialect, ParameterScope parameters)
      : program_(program),
        dialect_(dialect),
        parameter_scope_(parameters),
        names_(entry_point_names(dialect)),
        parameters_(claim_parameters(program, names_)),
        ranges_(find_ranges(program)) {}

  Result<GlslCode> run() {
    Result<LiftedProgram> lifted = lift(program_, parameter_scope_);
    if (!lifted) return Failure{lifted.error()};
    claim_definitions(*lifted);
    CodeText functions;
    for (const LiftedFunction& function : lifted->functions) {
      functions.append(write(function));
      functions.append("\n");
    }
    functions.append(entry_point(*lifted));
    CodeText all;
    all.append(print_helpers(helpers_));
    all.append(functions);
    return GlslCode{parameters_, std::move(all)};
  }

 private:
  /// In document order of need, so that a name depends on nothing that comes after it.
  void claim_definitions(const LiftedProgram& lifted) {
    definitions_.resize(program_.definitions.size());
    std::vector<uint32_t> order = lifted.definitions;
    order.pop_back();
    for (const LiftedFunction& function : lifted.functions) order.push_back(function.definition);
    std::ranges::sort(order);
    for (uint32_t index : order) definitions_[index] = names_.claim(program_.definitions[index].name);
    for (const LiftedFunction& function : lifted.functions)
      function_names_.push_back(definitions_[function.definition]);
  }

  static std::vector<std::string> no_conventions() { return std::vector<std::string>(conventions().size()); }

  CodeText write(const LiftedFunction& lifted) {
    const ir::ProgramDefinition& definition = program_.definitions[lifted.definition];
    FunctionScope scope{.names = Namer(dialect_),
                        .formals = {},
                        .parameters = parameters_,
                        .definitions = definitions_,
                        .conventions = no_conventions()};
    for (const std::string& name : function_names_) scope.names.reserve(name);
    reserve_uniforms(lifted.graph, scope.names);
    for (const Capture& capture : lifted.captures) {
      if (capture.kind != Capture::Kind::Input) continue;
      std::string symbol(convention_entry(static_cast<Convention>(capture.index)).symbol);
      scope.names.reserve(symbol);
      scope.conventions[capture.index] = symbol;
    }
    Function function{.equation = {definition.id, definition.equation},
                      .type = std::string(glsl_type(definition.signature.result)),
                      .name = definitions_[lifted.definition],
                      .parameters = {},
                      .body = {}};
    for (std::size_t i = 0; i < definition.formals.size(); ++i) {
      scope.formals.push_back(scope.names.claim(definition.formals[i]));
      function.parameters.push_back({std::string(glsl_type(definition.signature.parameters[i])), scope.formals.back()});
    }
    for (const Capture& capture : lifted.captures) function.parameters.push_back(captured_parameter(capture, scope));
    std::vector<BodyItem> items{{.equation = {}, .type = function.type, .name = {}}};
    function.body =
        write_body(pool_, lifted.graph, ranges_, &ranges_.formals_can_fail[lifted.definition], items, scope, helpers_);
    return print_function(pool_, function);
  }

  /// A function may reuse the name of a uniform that it does not read.
  void reserve_uniforms(const ir::Graph& graph, Namer& names) const {
    if (parameter_scope_ != ParameterScope::Everywhere) return;
    for (const ir::Value& value : graph.values())
      if (value.op == ir::Op::Parameter) names.reserve(parameters_[value.index]);
  }

  FunctionParameter captured_parameter(const Capture& capture, FunctionScope& scope) const {
    switch (capture.kind) {
      case Capture::Kind::Input:
        return {"vec3", scope.conventions[capture.index]};
      case Capture::Kind::Derived: {
        const ConventionEntry& entry = convention_entry(static_cast<Convention>(capture.index));
        scope.conventions[capture.index] = scope.names.claim(entry.symbol);
        return {std::string(glsl_type(entry.type)), scope.conventions[capture.index]};
      }
      case Capture::Kind::Parameter:
        scope.parameters[capture.index] = scope.names.claim(parameters_[capture.index]);
        return {std::string(glsl_type(program_.parameters[capture.index].type)), scope.parameters[capture.index]};
      case Capture::Kind::Definition:
        scope.definitions[capture.index] = scope.names.claim(definitions_[capture.index]);
        return {std::string(glsl_type(program_.definitions[capture.index].signature.result)),
                scope.definitions[capture.index]};
    }
    throw InternalError("a capture of no kind");
  }

  CodeText entry_point(const LiftedProgram& lifted) {
    FunctionScope scope{.names = names_,
                        .formals = {},
                        .parameters = parameters_,
                        .definitions = definitions_,
                        .conventions = no_conventions()};
    Function function{
        .equation = {}, .type = "vec3", .name = std::string(dialect_.entry_point), .parameters = {}, .body = {}};
    for (Convention input : kInputs) {
      std::string symbol(convention_entry(input).symbol);
      function.parameters.push_back({"vec3", symbol});
      scope.conventions[static_cast<std::size_t>(input)] = symbol;
    }
    std::vector<Statement> constants = constant_parameters(lifted);
    std::vector<Statement> body =
        write_body(pool_, lifted.body, ranges_, nullptr, entry_point_items(lifted), scope, helpers_);
    auto first_item = std::ranges::find_if(body, [](const Statement& s) { return s.type != "const float"; });
    body.insert(first_item, std::make_move_iterator(constants.begin()), std::make_move_iterator(constants.end()));
    if (dialect_.zero_below_horizon) {
      function.body.push_back(horizon_test());
      if (body.front().kind != Statement::Kind::Blank) function.body.emplace_back();
    }
    function.body.insert(function.body.end(), std::make_move_iterator(body.begin()),
                         std::make_move_iterator(body.end()));
    return print_function(pool_, function);
  }

  std::vector<BodyItem> entry_point_items(const LiftedProgram& lifted) const {
    std::vector<BodyItem> items;
    for (uint32_t index : lifted.definitions) {
      const ir::ProgramDefinition& definition = program_.definitions[index];
      items.push_back({.equation = {definition.id, definition.equation},
                       .type = std::string(glsl_type(definition.signature.result)),
                       .name = definitions_[index]});
    }
    items.back().name.clear();
    items.back().spread = !is_triple(program_.root().signature.result);
    return items;
  }

  std::vector<Statement> constant_parameters(const LiftedProgram& lifted) {
    std::vector<Statement> result;
    if (parameter_scope_ == ParameterScope::Everywhere) return result;
    for (std::size_t i = 0; i < program_.parameters.size(); ++i) {
      if (!lifted.parameter_used[i]) continue;
      const ir::Parameter& parameter = program_.parameters[i];
      Statement& s = result.emplace_back();
      s.kind = Statement::Kind::Declare;
      s.source = parameter.id;
      s.type = "const " + std::string(glsl_type(parameter.type));
      s.name = parameters_[i];
      s.value = write_number(pool_, parameter.value[0]);
      if (!is_triple(parameter.type)) continue;
      s.value = pool_.call("vec3",
                           {s.value, write_number(pool_, parameter.value[1]), write_number(pool_, parameter.value[2])});
    }
    return result;
  }

  Statement horizon_test() {
    auto below = [&](std::string_view direction) {
      ExpressionId cosine = pool_.call("dot", {pool_.atom("N"), pool_.atom(direction)});
      return pool_.infix(Precedence::Relational, "<=", cosine, pool_.atom("0.0"));
    };
    Statement s;
    s.kind = Statement::Kind::ReturnIf;
    s.condition = pool_.infix(Precedence::Or, "||", below("L"), below("V"));
    s.value = pool_.call("vec3", {pool_.atom("0.0")});
    return s;
  }

  const ir::Program& program_;
  const Dialect& dialect_;
  ParameterScope parameter_scope_;
  Namer names_;
  std::vector<std::string> parameters_;
  ProgramRanges ranges_;
  std::vector<std::string> definitions_;
  std::vector<std::string> function_names_;
  ExpressionPool pool_;
  std::set<HelperUse> helpers_;
};

}  // namespace

Namer entry_point_names(const Dialect& dialect) {
  Namer names(dialect);
  for (Convention input : kInputs) names.reserve(convention_entry(input).symbol);
  return names;
}

std::vector<std::string> claim_parameters(const ir::Program& program, Namer& names) {
  std::vector<std::string> result;
  for (const ir::Parameter& parameter : program.parameters) result.push_back(names.claim(parameter.name));
  return result;
}

Result<GlslCode> write_glsl(const ir::Program& program, const Dialect& dialect, ParameterScope scope) {
  ir::Program prepared = ir::run_passes(with_directions_for_root_formals(program), ir::emission_passes());
  return CodeWriter(prepared, dialect, scope).run();
}

}  // namespace texbrdf::emit
