#include "analysis/changed_blocks.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "source/shared_pool.h"

namespace texbrdf {
namespace {

class Reader {
 public:
  Reader(const EngineState& state, const TouchedBlocks& touched, WorkingBlocks& blocks, Counters& counters)
      : state_(state),
        touched_(touched),
        blocks_(blocks),
        counters_(counters),
        analysed_(touched.all ? state.segments.measure().blocks : touched.before.size()) {}

  std::vector<BlockChange> run() { return touched_.all ? read_all() : read_touched(); }

 private:
  std::vector<BlockChange> read_all() {
    const uint32_t count = state_.segments.measure().blocks;
    blocks_.reserve(count);
    std::vector<BlockChange> changes;
    changes.reserve(count);
    const std::string document = state_.text.bytes();
    state_.segments.visit_from(0, [&](const Segment& segment, const Segment::Measure& before) {
      if (!segment.block) return true;
      const std::string_view text = std::string_view(document).substr(before.bytes, segment.size);
      changes.push_back({segment.block->label, nullptr, open(*segment.block, text, nullptr)});
      return true;
    });
    return changes;
  }

  std::vector<BlockChange> read_touched() {
    std::vector<BlockLabel> labels;
    labels.reserve(touched_.before.size());
    for (const auto& [label, block] : touched_.before) labels.push_back(label);
    std::ranges::sort(labels);
    blocks_.reserve(labels.size());
    std::vector<BlockChange> changes;
    changes.reserve(labels.size());
    for (BlockLabel label : labels) {
      const PlacedBlock* before = touched_.before.find(label)->second.get();
      BlockChange change{label, before ? before->analysed.get() : nullptr, nullptr};
      const auto place = find_block(state_.segments, label);
      if (place.item != nullptr) {
        const std::string text = state_.text.slice({place.before.bytes, place.before.bytes + place.item->size});
        change.after = open(*place.item->block, text, before);
      }
      changes.push_back(change);
    }
    return changes;
  }

  const AnalysedBlock* open(const PlacedBlock& block, std::string_view text, const PlacedBlock* before) {
    WorkingBlock working{.label = block.label, .extent = block.extent, .analysed = nullptr, .definitions = {}};
    std::shared_ptr<const MacroExpansion> expansion = expand_macros(text, block.extent, state_.macros);
    if (const PlacedBlock* same = find_same(text, block.extent, expansion.get(), before)) {
      working.analysed = same->analysed;
      working.definitions = same->definitions;
    } else {
      working.analysed = analysed_.make(analyse_block(text, block.extent, *state_.names, analysed_.memory(),
                                                      analysed_.dense_memory(), std::move(expansion)));
      working.definitions.resize(working.analysed->parsed.definitions.size());
      ++counters_.blocks_parsed;
    }
    const AnalysedBlock* const analysed = working.analysed.get();
    blocks_.add(std::move(working));
    return analysed;
  }

  const PlacedBlock* find_same(std::string_view text, const BlockExtent& extent, const MacroExpansion* expansion,
                               const PlacedBlock* before) {
    if (before != nullptr && before->analysed->is_same(text, extent, expansion)) return before;
    if (touched_.before.size() <= 1) return nullptr;
    if (!listed_) list_gone();
    const auto found = gone_.find(text);
    return found != gone_.end() && found->second->analysed->is_same(text, extent, expansion) ? found->second : nullptr;
  }

  void list_gone() {
    listed_ = true;
    for (const auto& [label, block] : touched_.before) {
      if (block) gone_.emplace(block->analysed->parsed.source(), block.get());
    }
  }

  const EngineState& state_;
  const TouchedBlocks& touched_;
  WorkingBlocks& blocks_;
  Counters& counters_;
  SharedPool<AnalysedBlock> analysed_;
  bool listed_ = false;
  std::unordered_map<std::string_view, const PlacedBlock*> gone_;
};

}  // namespace

std::vector<BlockChange> read_changed_blocks(const EngineState& state, const TouchedBlocks& touched,
                                             WorkingBlocks& blocks, Counters& counters) {
  return Reader(state, touched, blocks, counters).run();
}

}  // namespace texbrdf
