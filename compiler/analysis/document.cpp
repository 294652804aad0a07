#include "analysis/document.h"

#include <algorithm>

#include "analysis/changed_names.h"
#include "analysis/engine_state.h"
#include "analysis/rescan.h"
#include "analysis/snapshot_state.h"
#include "analysis/update.h"

namespace texbrdf {
namespace {

/// Names that nobody uses any more stay in the table; when there are so many times more than definitions, all is
/// built anew.
constexpr size_t kMaxNamesPerDefinition = 64;
constexpr size_t kFewNames = 100'000;

}  // namespace

struct Document::State {
  EngineState engine;
  TouchedBlocks touched;  // since the last snapshot
  NameIndex name_index;
  std::shared_ptr<NameSuggestions> suggestions;
  uint64_t scanned = 0;  // blocks, since the last snapshot
  Counters counters;
  bool is_current = false;  // the snapshot is that of the text
  std::optional<Snapshot> snapshot;

  void start_anew(SourceText text) {
    engine = {};
    engine.text = std::move(text);
    engine.segments = scan_document(engine.text);
    touched = {.all = true, .before = {}};
    name_index = {};
    scanned = engine.segments.measure().blocks;
    is_current = false;
  }

  void edit(const TextEdit& edit) {
    Rescan result = rescan(engine.segments, engine.text, edit);
    if (result.relabelled) {
      start_anew(std::move(engine.text));
      return;
    }
    engine.segments = std::move(result.segments);
    scanned += result.added.size();
    if (!touched.all) touch(result);
    is_current = false;
  }

  void touch(const Rescan& result) {
    for (const auto& block : result.added) touched.before.try_emplace(block->label, nullptr);
    for (const auto& block : result.removed) {
      if (block->analysed) touched.before[block->label] = block;
    }
  }

  void bring_up_to_date() {
    const size_t names = engine.names->size();
    if (names > kFewNames && names > kMaxNamesPerDefinition * engine.segments.measure().definitions) {
      start_anew(std::move(engine.text));
    }
    UpdateResult result = update(engine, touched, name_index);
    touched = {};
    name_index = std::move(result.name_index);
    counters = result.counters;
    counters.blocks_scanned = std::exchange(scanned, 0);
    if (result.other_definitions || !suggestions) suggestions = std::make_shared<NameSuggestions>();
    publish();
  }

  void publish() {
    auto state = std::make_shared<Snapshot::State>();
    state->text = engine.text;
    state->segments = engine.segments;
    state->names = engine.names;
    state->name_index = name_index;
    state->lists_users = engine.lists_users;
    state->cycles = engine.cycles;
    state->root = engine.root;
    state->suggestions = suggestions;
    state->counters = counters;
    snapshot.emplace(std::move(state));
    is_current = true;
  }
};

Document::Document(std::string_view text) : state_(std::make_unique<State>()) {
  state_->start_anew(SourceText(text));
}
Document::~Document() = default;
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;

void Document::replace(Span span, std::string_view replacement) {
  SourceText& text = state_->engine.text;
  const uint32_t begin = std::min(span.begin, text.size());
  const uint32_t end = std::clamp(span.end, begin, text.size());
  const size_t room = SourceText::kMaxBytes - (text.size() - (end - begin));
  const std::string_view inserted = replacement.substr(0, room);
  text = text.with({begin, end}, inserted);
  state_->edit({begin, end - begin, static_cast<uint32_t>(inserted.size())});
}

void Document::set_text(std::string_view text) {
  const std::string old = state_->engine.text.bytes();
  const auto front = std::ranges::mismatch(old, text);
  const auto begin = static_cast<uint32_t>(front.in1 - old.begin());
  const auto back = std::mismatch(old.rbegin(), old.rend() - begin, text.rbegin(), text.rend() - begin);
  const auto same_behind = static_cast<uint32_t>(back.first - old.rbegin());
  replace({begin, static_cast<uint32_t>(old.size()) - same_behind},
          text.substr(begin, text.size() - same_behind - begin));
}

const SourceText& Document::text() const {
  return state_->engine.text;
}

const Snapshot& Document::snapshot() {
  if (!state_->is_current) state_->bring_up_to_date();
  return *state_->snapshot;
}

void Document::prepare_for_edits() {
  snapshot();
  if (state_->engine.lists_users) return;
  list_users(state_->engine);
  state_->name_index = NameIndex(state_->engine.occurrences);
  state_->publish();
}

}  // namespace texbrdf
