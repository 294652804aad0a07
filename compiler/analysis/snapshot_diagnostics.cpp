#include <algorithm>
#include <unordered_map>
#include <utility>

#include "analysis/snapshot_state.h"
#include "semantics/nearest_name.h"

namespace texbrdf {
namespace {

// Steps of comparing names (some nanoseconds each): reading the diagnostics stays quick in a document where
// everything is undefined; the names beyond it get no suggestion.
constexpr uint64_t kMaxComparisonSteps = 2'000'000;

constexpr size_t kMaxToldOfCycle = 12;

void put_into_block(Diagnostic& diagnostic, BlockId block) {
  diagnostic.where.block = block;
  for (RelatedPlace& place : diagnostic.related) place.where.block = block;
  for (Fix& fix : diagnostic.fixes) {
    for (Edit& edit : fix.edits) edit.where.block = block;
  }
}

Location place_of_name(const Snapshot::State& state, uint32_t definition) {
  const ListedDefinition& listed = state.list.definitions[definition];
  const ParsedBlock& block = *state.blocks[listed.block].parsed;
  return {.file = {}, .block = {listed.block}, .span = block.span(block.definitions[listed.index_in_block].name)};
}

/// Suggests names for undefined ones; the candidates are prepared when the first is asked for.
class Suggestions {
 public:
  explicit Suggestions(const Snapshot::State& state) : state_(state) {}

  /// The definition whose undefined names come next.
  void enter(const CheckedDefinition& inside) {
    parameters_ = {};
    for (const CheckedParameter& parameter : inside.parameters) {
      if (parameter.name.valid()) parameters_.add(state_.names->text(parameter.name));
    }
  }

  void add_to(Diagnostic& undefined) {
    const std::string& wanted = undefined.arguments[0];
    std::optional<std::string> nearest = parameters_.find(wanted, steps_);
    if (!nearest) nearest = nearest_in_document(wanted);
    if (!nearest) return;
    undefined.arguments[2] = "; did you mean `" + *nearest + "`?";
    undefined.fixes.push_back({.title = "replace by `" + *nearest + "`", .edits = {{undefined.where, *nearest}}});
  }

 private:
  std::optional<std::string> nearest_in_document(const std::string& wanted) {
    const auto known = answers_.find(wanted);
    if (known != answers_.end()) return known->second;
    if (document_.empty()) prepare();
    return answers_[wanted] = document_.find(wanted, steps_);
  }

  void prepare() {
    for (uint32_t i = 0; i < state_.list.definitions.size(); ++i) {
      const NameId name = state_.list.definitions[i].name;
      if (state_.list.find(name) == i) document_.add(state_.names->text(name));
    }
    for (const ConventionEntry& entry : conventions()) {
      for (std::string_view spelling : entry.spellings) document_.add(spelling);
    }
  }

  const Snapshot::State& state_;
  NearestName parameters_;
  NearestName document_;
  uint64_t steps_ = kMaxComparisonSteps;
  std::unordered_map<std::string, std::optional<std::string>> answers_;
};

class Collector {
 public:
  explicit Collector(const Snapshot::State& state) : state_(state), suggestions_(state) {}

  std::vector<Diagnostic> run() {
    uint32_t definition = 0;
    for (uint32_t block = 0; block < state_.blocks.size(); ++block) {
      take(state_.blocks[block].parsed->diagnostics, BlockId{block});
      for (; definition < state_.list.block_ends[block]; ++definition) take_definition(definition);
    }
    for (const std::vector<uint32_t>& cycle : state_.list.order.cycles) report_cycle(cycle);
    std::ranges::sort(all_, {}, [](const Diagnostic& d) { return std::pair(d.where, d.code); });
    return std::move(all_);
  }

 private:
  std::string name_text(uint32_t definition) const {
    return shown_name(state_.names->text(state_.list.definitions[definition].name));
  }

  Location name_place(uint32_t definition) const { return place_of_name(state_, definition); }

  void take(const std::vector<Diagnostic>& diagnostics, BlockId block) {
    for (const Diagnostic& diagnostic : diagnostics) {
      all_.push_back(diagnostic);
      put_into_block(all_.back(), block);
    }
  }

  void take_definition(uint32_t index) {
    const CheckedDefinition& checked = state_.checked.records[index]->checked;
    const size_t first = all_.size();
    take(checked.diagnostics, BlockId{state_.list.definitions[index].block});
    if (all_.size() > first) suggestions_.enter(checked);
    for (size_t i = first; i < all_.size(); ++i) {
      if (all_[i].code == Code::UndefinedName) suggestions_.add_to(all_[i]);
    }
    report_definition(index);
  }

  void report_definition(uint32_t index) {
    const NameId name = state_.list.definitions[index].name;
    const uint32_t first = state_.list.find(name);
    if (first == kNoDefinition) return;
    if (first != index) {
      all_.push_back(make_diagnostic(Code::Redefinition, name_place(index), {name_text(index)}));
      all_.back().related.push_back({name_place(first), "first defined here"});
    } else if (const std::optional<Convention> convention = state_.names->traits(name).convention) {
      const std::string meaning(convention_entry(*convention).meaning);
      all_.push_back(make_diagnostic(Code::ConventionRedefined, name_place(index), {name_text(index), meaning}));
    }
  }

  void report_cycle(const std::vector<uint32_t>& cycle) {
    const std::span<const uint32_t> told = std::span(cycle).first(std::min(cycle.size(), kMaxToldOfCycle));
    std::string path;
    for (uint32_t index : told) path += "`" + name_text(index) + "` → ";
    if (told.size() < cycle.size()) path += "… → ";
    Diagnostic diagnostic = make_diagnostic(Code::CircularDefinition, name_place(cycle.front()),
                                            {path + "`" + name_text(cycle.front()) + "`"});
    for (uint32_t index : told.subspan(1)) {
      diagnostic.related.push_back({name_place(index), "`" + name_text(index) + "` is on the way"});
    }
    all_.push_back(std::move(diagnostic));
  }

  const Snapshot::State& state_;
  Suggestions suggestions_;
  std::vector<Diagnostic> all_;
};

// A document without blocks is none of ours, and a block whose left side could not be read may have been the root.
bool may_miss_root(const Snapshot::State& state) {
  if (state.blocks.empty()) return false;
  return std::ranges::none_of(state.blocks, [](const Block& block) { return block.parsed->definitions.empty(); });
}

}  // namespace

bool is_brdf(const Signature& signature) {
  const bool is_value = signature.result == Type::Real || is_triple(signature.result);
  if (!signature.is_function) return is_value;
  return is_value && signature.parameters.size() == 2 && std::ranges::all_of(signature.parameters, is_triple);
}

std::vector<Diagnostic> document_diagnostics(const Snapshot::State& state) {
  return Collector(state).run();
}

std::optional<Diagnostic> root_diagnostic(const Snapshot::State& state, std::string_view root) {
  const uint32_t index = state.list.find(state.names->find(root));
  if (index == kNoDefinition) {
    if (!may_miss_root(state)) return std::nullopt;
    const auto last = static_cast<uint32_t>(state.list.definitions.size() - 1);
    return make_diagnostic(Code::MissingRoot, place_of_name(state, last), {std::string(root)});
  }
  const Signature& signature = state.checked.facts[state.list.definitions[index].name.value].signature;
  if (signature.result == Type::Error || is_brdf(signature)) return std::nullopt;
  return make_diagnostic(Code::RootShape, place_of_name(state, index), {std::string(root), signature_text(signature)});
}

}  // namespace texbrdf
