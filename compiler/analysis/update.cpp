#include "analysis/update.h"

#include <algorithm>

#include "analysis/changed_blocks.h"
#include "analysis/changed_names.h"
#include "analysis/check_changes.h"
#include "analysis/definition_heights.h"
#include "analysis/directional_names.h"
#include "analysis/needed_names.h"
#include "analysis/root_choice.h"
#include "analysis/settle_readings.h"
#include "source/shared_pool.h"

namespace texbrdf {
namespace {

/// More changes than one in so many are not put in one by one: the list is built anew.
constexpr size_t kFewest = 8;

class Update {
 public:
  Update(EngineState& state, const TouchedBlocks& touched, const OccurrencesByName& before)
      : state_(state), is_all_new_(touched.all), touched_(touched), before_(before), blocks_(state.segments) {}

  UpdateResult run() {
    const std::vector<BlockChange> changes = read_changed_blocks(state_, touched_, blocks_, result_.counters);
    names_ = update_names(state_, changes, is_all_new_);
    settle_readings(state_, blocks_, names_, result_.counters);
    if (is_all_new_) list_mentioned();
    note_mentions();
    OrderChange order = order_definitions(state_, blocks_, names_.reordered);
    std::vector<NameId> rearranged = names_.reordered;
    rearranged.insert(rearranged.end(), order.knotted.begin(), order.knotted.end());
    if (is_all_new_) {
      check_all(state_, blocks_, order.order, result_.counters);
      store_blocks();
    } else {
      std::vector<NameId> to_check = std::move(order.knotted);
      to_check.insert(to_check.end(), names_.to_check.begin(), names_.to_check.end());
      check_changes(state_, blocks_, to_check, result_.counters);
      mark_definitions();
      store_blocks();
    }
    store_names();
    update_directional(state_, rearranged);
    choose_root(state_);
    find_needed();
    result_.other_definitions = !names_.listed.empty();
    return std::move(result_);
  }

 private:
  void list_mentioned() {
    is_mentioned_.resize(state_.names->size());
    for (const WorkingBlock& block : blocks_.all()) {
      for (NameId name : block.analysed->mentions) is_mentioned_[name.value] = true;
    }
  }

  void note_mentions() {
    for (NameId name : names_.reordered) {
      std::vector<NameId>& mentions = state_.name_states[name.value].mentions;
      const std::optional<DefinitionKey> key = state_.in_force(name);
      if (!key) {
        mentions.clear();
      } else {
        const std::span<const NameId> now = blocks_.analysed(key->block)->mentions_of(key->index_in_block);
        mentions.assign(now.begin(), now.end());
      }
    }
  }

  void find_needed() {
    state_.needed = nullptr;
    const bool may_demote = state_.segments.measure().demotable > 0 || !state_.cycles->empty();
    if (!may_demote) return;
    const NameId root = state_.names->find(state_.root.name_or_f());
    if (!root.valid()) return;
    const auto mentions_of = [&](NameId name) { return std::span(state_.name_states[name.value].mentions); };
    state_.needed = std::make_shared<const std::vector<bool>>(
        needed_names(state_.name_states.size(), root, checked(root), mentions_of));
  }

  const CheckedDefinition* checked(NameId name) const {
    const std::optional<DefinitionKey> key = state_.in_force(name);
    if (!key) return nullptr;
    const auto place = find_block(state_.segments, key->block);
    return place.item == nullptr ? nullptr : &place.item->block->definitions[key->index_in_block].record->checked;
  }

  void mark_definitions() {
    for (WorkingBlock& block : blocks_.all()) mark_block(block);
    for (NameId name : names_.listed) mark_first(name);
    for (NameId name : names_.mentioned) mark_first(name);
  }

  void mark_block(WorkingBlock& block) const {
    for (uint32_t i = 0; i < block.definitions.size(); ++i)
      mark(block.definitions[i], {block.label, i}, *block.analysed);
  }

  void mark(PlacedDefinition& definition, const DefinitionKey& key, const AnalysedBlock& block) const {
    const NameId name = block.defined(key.index_in_block);
    definition.in_force = state_.in_force(name) == key;
    definition.is_used = definition.in_force && is_used(name);
  }

  bool is_used(NameId name) const {
    return state_.lists_users ? !state_.occurrences[name.value].users.empty() : is_mentioned_[name.value];
  }

  // Of the definitions that did not change only the first can have come into force or out of it.
  void mark_first(NameId name) {
    state_.occurrences[name.value].definitions.visit_from(0, [&](const DefinitionKey& key, const DefinitionKey&) {
      if (blocks_.find(key.block) != nullptr) return true;
      PlacedDefinition marked = find_block(state_.segments, key.block).item->block->definitions[key.index_in_block];
      const PlacedDefinition before = marked;
      mark(marked, key, *blocks_.analysed(key.block));
      const bool is_same = marked.in_force == before.in_force && marked.is_used == before.is_used;
      if (!is_same) mark_block(blocks_.open(key.block));
      return false;
    });
  }

  /// Takes the block's content: it is not asked for any more.
  std::shared_ptr<const PlacedBlock> placed(WorkingBlock& block) {
    if (is_all_new_) mark_block(block);
    PlacedBlock placed{.label = block.label, .extent = block.extent, .analysed = nullptr, .definitions = {}};
    placed.reports = count_reports(block);
    placed.demotable = count_demotable(block);
    for (uint32_t i = 0; i < block.definitions.size(); ++i) {
      const PlacedDefinition& definition = block.definitions[i];
      if (definition.in_force && !definition.is_used) ++placed.unused;
      const NameTraits& traits = state_.names->traits(block.analysed->defined(i));
      if (definition.in_force && is_root_candidate(traits, definition.record->checked)) ++placed.candidates;
    }
    placed.directives = static_cast<uint32_t>(block.analysed->directives.size());
    placed.expansion = block.analysed->parsed.expansion.get();
    placed.integrals = count_integrals(*block.analysed);
    placed.analysed = std::move(block.analysed);
    placed.definitions = std::move(block.definitions);
    return placed_.make(std::move(placed));
  }

  static uint32_t count_integrals(const AnalysedBlock& block) {
    return static_cast<uint32_t>(std::ranges::count_if(block.names.binders, [&](const Binder& binder) {
      return block.parsed.tree.node(binder.node).kind == NodeKind::Integral;
    }));
  }

  uint32_t count_reports(const WorkingBlock& block) const {
    size_t reports = block.analysed->parsed.diagnostics.size();
    for (uint32_t i = 0; i < block.definitions.size(); ++i) {
      const PlacedDefinition& definition = block.definitions[i];
      const bool is_convention = state_.names->traits(block.analysed->defined(i)).convention.has_value();
      reports += definition.record->checked.diagnostics.size();
      if (!definition.in_force || is_convention) ++reports;
    }
    return static_cast<uint32_t>(reports);
  }

  uint32_t count_demotable(const WorkingBlock& block) const {
    int64_t demotable = 0;
    const ParsedBlock& parsed = block.analysed->parsed;
    for (const DefinitionSyntax& definition : parsed.definitions) {
      const auto reported =
          std::span(parsed.diagnostics)
              .subspan(definition.first_diagnostic, definition.end_diagnostic - definition.first_diagnostic);
      demotable += std::ranges::count_if(reported, is_demotable);
    }
    for (const PlacedDefinition& definition : block.definitions) {
      demotable += std::ranges::count_if(definition.record->checked.diagnostics, is_demotable);
      if (!definition.in_force) ++demotable;
    }
    return static_cast<uint32_t>(demotable);
  }

  void store_blocks() {
    placed_ = SharedPool<PlacedBlock>(blocks_.all().size());
    if (is_all_new_) {
      store_new_blocks();
    } else if (blocks_.all().size() > state_.segments.size() / kFewest) {
      store_many_blocks();
    } else {
      store_few_blocks();
    }
  }

  void store_new_blocks() {
    state_.segments.change_all([&](Segment& segment) {
      if (segment.block) segment.block = placed(*blocks_.find(segment.block->label));
    });
  }

  void store_few_blocks() {
    for (WorkingBlock& block : blocks_.all()) {
      const auto place = find_block(state_.segments, block.label);
      Segment segment = *place.item;
      segment.block = placed(block);
      state_.segments = state_.segments.with(place.index, 1, std::span(&segment, 1));
    }
  }

  void store_many_blocks() {
    std::vector<Segment> segments;
    segments.reserve(state_.segments.size());
    state_.segments.visit_from(0, [&](const Segment& segment, const Segment::Measure&) {
      segments.push_back(segment);
      if (!segment.block) return true;
      if (WorkingBlock* block = blocks_.find(segment.block->label)) segments.back().block = placed(*block);
      return true;
    });
    state_.segments = SegmentSequence(std::move(segments));
  }

  void store_names() {
    const size_t changed = names_.listed.size() + names_.mentioned.size();
    const bool is_first_listing = state_.lists_users && !listed_users_;
    if (is_first_listing || changed > before_.size() / kFewest) {
      result_.occurrences = OccurrencesByName(std::span(std::as_const(state_.occurrences)));
      return;
    }
    const std::span all(state_.occurrences);
    result_.occurrences = before_.with(before_.size(), 0, all.subspan(before_.size()));
    for (NameId name : names_.listed) store_name(name);
    for (NameId name : names_.mentioned) store_name(name);
  }

  void store_name(NameId name) {
    result_.occurrences = result_.occurrences.with(name.value, 1, std::span(&state_.occurrences[name.value], 1));
  }

  EngineState& state_;
  const bool is_all_new_;
  const TouchedBlocks& touched_;
  const OccurrencesByName& before_;
  const bool listed_users_ = state_.lists_users;  // before
  WorkingBlocks blocks_;
  ChangedNames names_;
  std::vector<bool> is_mentioned_;  // by NameId, where all blocks are new
  SharedPool<PlacedBlock> placed_{1};
  UpdateResult result_;
};

}  // namespace

UpdateResult update(EngineState& state, const TouchedBlocks& touched, const OccurrencesByName& before) {
  return Update(state, touched, before).run();
}

}  // namespace texbrdf
