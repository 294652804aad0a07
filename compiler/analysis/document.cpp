#include "analysis/document.h"

#include <algorithm>

#include "analysis/changed_macros.h"
#include "analysis/changed_names.h"
#include "analysis/engine_state.h"
#include "analysis/rescan.h"
#include "analysis/snapshot_state.h"
#include "analysis/update.h"
#include "source/internal_error.h"
#include "source/text_change.h"

namespace texbrdf {
namespace {

/// Names that nobody uses any more stay in the table; when there are so many times more than definitions, all is
/// built anew.
constexpr size_t kMaxNamesPerDefinition = 64;
constexpr size_t kFewNames = 10'000;

}  // namespace

struct Document::State {
  EngineState engine;
  TouchedBlocks touched;  // since the last snapshot
  OccurrencesByName occurrences;
  std::shared_ptr<NameSuggestions> suggestions;
  uint64_t scanned = 0;  // blocks, since the last snapshot
  Counters counters;
  bool is_current = false;  // the state is checked, and the snapshots are of it
  std::shared_ptr<const std::vector<IncludeProblem>> include_problems =
      std::make_shared<const std::vector<IncludeProblem>>();
  std::vector<std::optional<Snapshot>> snapshots;  // by FileId; formed when they are asked for

  void start_anew(ProjectText text) {
    engine = {};
    engine.text = std::move(text);
    engine.segments = scan_files(engine.text);
    touched = {.all = true, .macros = true, .before = {}};
    occurrences = {};
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
    if (result.macros) touched.macros = true;
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
    if (touched.macros) update_macros(engine, touched);
    UpdateResult result = update(engine, touched, occurrences);
    touched = {};
    occurrences = std::move(result.occurrences);
    counters = result.counters;
    counters.blocks_scanned = std::exchange(scanned, 0);
    if (result.other_definitions || !suggestions) suggestions = std::make_shared<NameSuggestions>();
    is_current = true;
    forget_snapshots();
  }

  void forget_snapshots() {
    snapshots.clear();
    snapshots.resize(engine.text.file_count());
  }

  Snapshot seen_from(FileId file) const {
    auto state = std::make_shared<Snapshot::State>();
    state->text = engine.text;
    state->segments = engine.segments;
    state->view = FileView(engine.text, engine.segments, file);
    state->names = engine.names;
    state->occurrences = occurrences;
    state->lists_users = engine.lists_users;
    state->rereadings = engine.rereadings;
    state->cycles = engine.cycles;
    state->directional = engine.directional;
    state->root = engine.root;
    state->needed = engine.needed;
    state->include_problems = include_problems;
    state->suggestions = suggestions;
    state->counters = counters;
    return Snapshot(std::move(state));
  }
};

Document::Document(SourceText text, TextLanguage language) : state_(std::make_unique<State>()) {
  state_->start_anew(ProjectText(std::move(text), language));
}
Document::~Document() = default;
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;

void Document::replace(FileId file, Span span, std::string_view replacement) {
  ProjectText& all = state_->engine.text;
  const SourceText& text = all.file(file);
  const uint32_t begin = std::min(span.begin, text.size());
  const uint32_t end = std::clamp(span.end, begin, text.size());
  const size_t room = SourceText::kMaxBytes - std::min(SourceText::kMaxBytes, all.size() - (end - begin));
  const std::string_view inserted = replacement.substr(0, room);
  all.set(file, text.with({begin, end}, inserted));
  state_->edit({file, begin, end - begin, static_cast<uint32_t>(inserted.size())});
}

void Document::set_text(FileId file, std::string_view text) {
  const std::string old = this->text(file).bytes();
  const TextChange change = smallest_change(old, text);
  replace(file, change.span, change.replacement);
}

TextLanguage Document::language(FileId file) const {
  return state_->engine.text.language(file);
}

void Document::set_language(FileId file, TextLanguage language) {
  ProjectText& all = state_->engine.text;
  if (all.language(file) == language) return;
  all.set_language(file, language);
  state_->start_anew(std::move(all));
}

const SourceText& Document::text(FileId file) const {
  return state_->engine.text.file(file);
}

uint32_t Document::file_count() const {
  return state_->engine.text.file_count();
}

void Document::insert_file(FileId at, const SourceText& text, TextLanguage language) {
  EngineState& engine = state_->engine;
  require(at.value > 0 && at.value <= file_count(), "a file is put behind another");
  engine.segments = with_empty_file(engine.segments, engine.text, at);
  const bool has_room = text.size() < SourceText::kMaxBytes - std::min(SourceText::kMaxBytes, engine.text.size() + 1);
  const SourceText taken = has_room ? text : SourceText();
  engine.text.insert(at, taken, language);
  state_->edit({at, 0, 0, taken.size()});
}

void Document::remove_file(FileId file) {
  EngineState& engine = state_->engine;
  require(file.value > 0 && file.value < file_count(), "the first file stays");
  replace(file, {0, text(file).size()}, {});
  engine.text.remove(file);
  engine.segments = without_empty_file(engine.segments, engine.text, file);
}

std::vector<IncludeTarget> Document::includes(FileId file) const {
  const Span span = state_->engine.text.span(file);
  std::vector<IncludeTarget> targets;
  state_->engine.segments.visit_where([](const Segment::Measure& sum) { return sum.includes > 0; },
                                      [&](const Segment& segment, const Segment::Measure& before) {
                                        if (before.bytes < span.begin) return true;
                                        if (before.bytes >= span.end) return false;
                                        for (const Include& include : segment.remarks->includes)
                                          targets.push_back(include.target);
                                        return true;
                                      });
  return targets;
}

void Document::set_include_problems(std::vector<IncludeProblem> problems) {
  if (*state_->include_problems == problems) return;
  state_->include_problems = std::make_shared<const std::vector<IncludeProblem>>(std::move(problems));
  state_->forget_snapshots();
}

const Snapshot& Document::snapshot(FileId file) {
  if (!state_->is_current) state_->bring_up_to_date();
  std::optional<Snapshot>& snapshot = state_->snapshots[file.value];
  if (!snapshot) snapshot = state_->seen_from(file);
  return *snapshot;
}

void Document::prepare_for_edits() {
  if (!state_->is_current) state_->bring_up_to_date();
  if (state_->engine.lists_users) return;
  list_users(state_->engine);
  state_->occurrences = OccurrencesByName(state_->engine.occurrences);
  state_->forget_snapshots();
}

}  // namespace texbrdf
