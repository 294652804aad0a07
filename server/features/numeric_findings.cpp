#include "features/numeric_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "eval/compile.h"
#include "eval/evaluate.h"
#include "features/integral_error.h"
#include "features/sample_geometries.h"
#include "ir/free_name.h"
#include "ir/lower.h"

namespace texbrdf::features {
namespace {

using eval::Geometry;
using eval::Triple;

constexpr size_t kMostChains = 64;
constexpr uint64_t kMostSteps = 100'000;
constexpr uint32_t kMostValues = 10'000;
constexpr double kRelative = 1e-6;
constexpr double kAbsolute = 1e-9;

bool is_finite(const Triple& v) {
  return std::ranges::all_of(v, [](double x) { return std::isfinite(x); });
}

bool differ(const Triple& a, const Triple& b) {
  for (size_t i = 0; i < a.size(); ++i) {
    const double size = std::max(std::fabs(a[i]), std::fabs(b[i]));
    if (std::fabs(a[i] - b[i]) > kRelative * size + kAbsolute) return true;
  }
  return false;
}

std::string shown(const Triple& v) {
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", v[0], v[1], v[2]);
}

std::string shown_value(const Triple& v, Type type) {
  return is_triple(type) ? fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]) : fmt::format("{:.6g}", v[0]);
}

/// Where two computations differ first.
struct Difference {
  Geometry geometry;
  Triple first;
  Triple second;
};

class Comparisons {
 public:
  explicit Comparisons(const Snapshot& snapshot) : snapshot_(snapshot) {}

  /// The names whose signatures were looked at.
  const std::vector<NameId>& asked() const { return asked_; }

  /// The definition gives the name the meaning that it has anyway.
  bool is_its_convention(NameId name) {
    const std::optional<Convention> convention = snapshot_.names().traits(name).convention;
    const ir::LinkableDefinition* const definition = snapshot_.linkable(name);
    if (!convention || definition == nullptr || definition->signature.is_function) return false;
    if (!fits(definition->signature.result, convention_entry(*convention).type)) return false;
    ir::LinkableDefinition usual = *definition;
    usual.id = ir::free_name(0);
    usual.literal.reset();
    usual.graph = {};
    usual.graph.roots = {usual.graph.whole_convention(*convention)};
    const auto stated = values(*definition, nullptr);
    const auto meant = values(usual, &usual);
    return stated && meant && !first_difference(*stated, *meant);
  }

  /// What is to be said of a chain whose right sides differ.
  std::optional<Diagnostic> compare(const NumericQuestions::Chain& chain) {
    const std::optional<DefinitionId> id = snapshot_.find(chain.name);
    const ir::LinkableDefinition* const first = snapshot_.linkable(chain.name);
    if (!id || first == nullptr || !first->signature.is_callable) return std::nullopt;
    const std::optional<ir::LinkableDefinition> second = restatement(*id, chain.body);
    if (!second) return std::nullopt;
    const auto stated = values(*first, nullptr);
    const auto again = values(*second, &*second);
    if (!stated || !again) return std::nullopt;
    const std::optional<Difference> difference = first_difference(*stated, *again);
    if (!difference) return std::nullopt;
    const BlockId block = snapshot_.definition(*id).block;
    const Location where{.file = {}, .block = block, .span = snapshot_.parsed(block).span(chain.body)};
    const Type type = first->signature.result;
    return make_diagnostic(
        Code::RestatementDiffers, where,
        {shown(difference->geometry.light), shown(difference->geometry.view), shown_value(difference->second, type),
         shown_name(first->canonical), shown_value(difference->first, type)});
  }

 private:
  /// As if the later right side were the only one.
  std::optional<ir::LinkableDefinition> restatement(DefinitionId id, NodeId body) {
    const Definition definition = snapshot_.definition(id);
    const CheckedRestatement again = snapshot_.check_restatement({id, body});
    asked_.insert(asked_.end(), again.asked.begin(), again.asked.end());
    const Signature& signature = again.checked.signature;
    // The graphs of instances are kept by their names, so a second meaning of this name would mix with the first.
    if (!again.checked.instance_calls.empty()) return std::nullopt;
    if (!again.checked.sound || signature.parameters != definition.checked->signature.parameters) return std::nullopt;
    if (!fits(signature.result, definition.checked->signature.result)) return std::nullopt;
    ir::LinkableDefinition linkable = *snapshot_.linkable(definition.name);
    linkable.id = ir::free_name(0);
    linkable.literal.reset();
    linkable.graph = ir::lower_definition(snapshot_.parsed(definition.block), again.syntax,
                                          snapshot_.names_of(definition.block), again.checked);
    return linkable;
  }

  /// For all sample geometries; a function is called with some arguments. `added`: a definition that the document does
  /// not have.
  std::optional<std::vector<Triple>> values(const ir::LinkableDefinition& definition,
                                            const ir::LinkableDefinition* added) {
    const ir::LinkableDefinition call = sample_call(definition);
    const auto lookup = [&](const Instance& use) -> const ir::LinkableDefinition* {
      if (use.function == call.id) return &call;
      return added != nullptr && use.function == added->id ? added : snapshot_.linkable(use);
    };
    const Result<ir::Program> program = ir::link(lookup, call.id, {});
    if (!program) return std::nullopt;
    Result<ir::Graph> graph = ir::flatten(*program);
    if (!graph || graph->size() > kMostValues) return std::nullopt;
    const std::vector<Triple> parameters = eval::parameter_values(*program);
    const eval::ReferenceEvaluator evaluator(*std::move(graph));
    std::vector<Triple> found;
    for (const Geometry& geometry : sample_geometries()) {
      const std::optional<Triple> value = evaluator.evaluate(geometry, parameters, 0, budget_);
      if (!value) return std::nullopt;
      found.push_back(*value);
    }
    return found;
  }

  ir::LinkableDefinition sample_call(const ir::LinkableDefinition& callee) const {
    ir::LinkableDefinition call;
    call.id = ir::free_name(1);
    call.name = callee.name;
    call.canonical = callee.canonical;
    call.signature.result = callee.signature.result;
    std::vector<ir::ValueId> arguments;
    for (uint32_t i = 0; i < callee.signature.parameters.size(); ++i) {
      const Type type = callee.signature.parameters[i];
      const uint32_t entries = is_aggregate(type) ? type_components(type) : 1;
      for (uint32_t k = 0; k < entries; ++k) {
        arguments.push_back(sample_argument(call.graph, is_aggregate(type) ? Type::Real : type, i + k));
      }
    }
    const ir::Op op = callee.signature.is_function ? ir::Op::Call : ir::Op::Reference;
    call.graph.roots = {call.graph.leaf(op, callee.signature.result, callee.id.value, arguments)};
    return call;
  }

  /// A number between 0 and 1 that changes with a direction, or a direction.
  static ir::ValueId sample_argument(ir::Graph& graph, Type type, uint32_t position) {
    const ir::ValueId direction = graph.whole_convention(position % 2 == 0 ? Convention::OmegaI : Convention::OmegaO);
    if (type == Type::Vector) return direction;
    const ir::ValueId cosine = graph.add(ir::Op::Dot, {graph.whole_convention(Convention::Normal), direction});
    const ir::ValueId scaled = graph.add(ir::Op::Multiply, {graph.constant(0.5), cosine});
    const ir::ValueId number = graph.add(ir::Op::Add, {graph.constant(0.2 + 0.07 * (position % 4)), scaled});
    if (type == Type::Real) return number;
    return graph.add(ir::Op::MakeVector, {number, graph.constant(0.5), graph.constant(0.3)});
  }

  static std::optional<Difference> first_difference(const std::vector<Triple>& a, const std::vector<Triple>& b) {
    for (size_t i = 0; i < a.size(); ++i) {
      if (is_finite(a[i]) && is_finite(b[i]) && differ(a[i], b[i])) {
        return Difference{sample_geometries()[i], a[i], b[i]};
      }
    }
    return std::nullopt;
  }

  const Snapshot& snapshot_;
  std::vector<NameId> asked_;
  eval::StepBudget budget_{kMostSteps};
};

/// By how the names are written: their numbers depend on the order in which they were typed.
template <typename Question, typename NameOf>
void sort_by_name(std::vector<Question>& questions, const NameTable& names, const NameOf& name_of) {
  std::ranges::stable_sort(questions, {}, [&](const Question& question) { return names.text(name_of(question)); });
}

NumericFindings::Dependency dependency(const Snapshot& snapshot, NameId name) {
  const std::optional<DefinitionId> id = snapshot.find(name);
  return {name, id ? snapshot.definition(*id).checked : nullptr};
}

std::vector<NumericFindings::Dependency> dependencies(const Snapshot& snapshot, const NumericQuestions& questions,
                                                      std::vector<NameId> looked_at) {
  std::vector<NameId>& names = looked_at;
  for (const NumericQuestions::Chain& chain : questions.chains) names.push_back(chain.name);
  names.insert(names.end(), questions.conventions.begin(), questions.conventions.end());
  if (questions.integrated.valid()) names.push_back(questions.integrated);
  std::vector<NumericFindings::Dependency> all;
  for (const NameId name : snapshot.needs_of(names)) all.push_back(dependency(snapshot, name));
  return all;
}

std::optional<Diagnostic> inexact_integral(const Snapshot& snapshot, NameId root, const std::stop_token& stop) {
  const std::string name(snapshot.names().text(root));
  const std::optional<double> error = integral_error(snapshot, name, stop);
  if (!error) return std::nullopt;
  const DefinitionId id = *snapshot.find(root);
  const BlockId block = snapshot.definition(id).block;
  const Location where{.file = {}, .block = block, .span = snapshot.parsed(block).span(snapshot.syntax(id).name)};
  return make_diagnostic(Code::InexactIntegral, where, {shown_name(name), fmt::format("{:.0e}", *error)});
}

}  // namespace

NameId redefined_convention(const Snapshot& snapshot, const Diagnostic& diagnostic) {
  if (diagnostic.code != Code::ConventionRedefined) return {};
  const DefinitionRange range = snapshot.definitions_of(diagnostic.where.block);
  for (DefinitionId id = range.first; id < range.end; ++id.value) {
    const Span name = snapshot.parsed(diagnostic.where.block).span(snapshot.syntax(id).name);
    if (name == diagnostic.where.span) return snapshot.definition(id).name;
  }
  return {};
}

NumericQuestions numeric_questions(const Snapshot& snapshot, std::string_view root) {
  NumericQuestions questions;
  for (const RestatedDefinition& restated : snapshot.restatements(kMostChains)) {
    questions.chains.push_back({snapshot.definition(restated.definition).name, restated.body});
  }
  for (const Diagnostic& diagnostic : snapshot.diagnostics()) {
    const NameId name = redefined_convention(snapshot, diagnostic);
    if (name.valid()) questions.conventions.push_back(name);
  }
  sort_by_name(questions.chains, snapshot.names(), [](const NumericQuestions::Chain& chain) { return chain.name; });
  sort_by_name(questions.conventions, snapshot.names(), [](NameId name) { return name; });
  if (snapshot.holds_integrals()) {
    const std::optional<DefinitionId> id = snapshot.find(root.empty() ? snapshot.root_name() : std::string(root));
    const bool is_told = id && !snapshot.allows(Code::InexactIntegral, snapshot.definition(*id).block);
    if (is_told) questions.integrated = snapshot.definition(*id).name;
  }
  return questions;
}

bool NumericFindings::hold_for(const Snapshot& snapshot, const NumericQuestions& asked) const {
  return questions == asked && std::ranges::all_of(dependencies, [&](const Dependency& known) {
           return dependency(snapshot, known.name).definition == known.definition;
         });
}

std::optional<NumericFindings> find_numerically(const Snapshot& snapshot, NumericQuestions questions,
                                                const std::stop_token& stop) {
  NumericFindings found;
  Comparisons comparisons(snapshot);
  for (const NameId name : questions.conventions) {
    if (comparisons.is_its_convention(name)) found.usual.push_back(name);
  }
  for (const NumericQuestions::Chain& chain : questions.chains) {
    if (stop.stop_requested()) return std::nullopt;
    if (auto diagnostic = comparisons.compare(chain)) found.findings.push_back({chain.name, *std::move(diagnostic)});
  }
  if (questions.integrated.valid()) {
    auto hint = inexact_integral(snapshot, questions.integrated, stop);
    if (hint) found.findings.push_back({questions.integrated, *std::move(hint)});
  }
  if (stop.stop_requested()) return std::nullopt;
  found.dependencies = dependencies(snapshot, questions, comparisons.asked());
  found.questions = std::move(questions);
  return found;
}

}  // namespace texbrdf::features
