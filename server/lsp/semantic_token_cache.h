#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/snapshot.h"
#include "features/semantic_tokens.h"
#include "lsp/edited_region.h"
#include "lsp/token_run.h"

namespace texbrdf::lsp {

/// The semantic tokens that a client has of one document. They are kept by block, so bringing them up to date costs
/// what the edits since the last time touched, and no more than an addition for each other block.
class SemanticTokenCache {
 public:
  /// The tokens of one block.
  struct Entry {
    std::shared_ptr<const TokenRun> run;
    uint32_t count = 0;  ///< run->count, at hand for sums
    Position lead;       ///< of the first token, told from the last one of an earlier block
    bool is_same(const Entry& other) const {
      return count == other.count && lead == other.lead && (run == other.run || *run == *other.run);
    }
  };
  /// What an update changed: blocks from `first` on, and the lead of the first token behind them.
  struct Change {
    uint32_t first = 0;
    std::vector<Entry> before;
    uint32_t after_count = 0;
    std::optional<Position> lead_behind_before;  ///< where such a token is
  };
  /// One of the protocol's SemanticTokensEdit: places in the array of numbers as it was.
  struct Edit {
    uint64_t start = 0;
    uint64_t delete_count = 0;
    std::string data;  ///< JSON without brackets
  };

  /// To be told of every change of the text.
  void text_replaced(Span replaced, uint32_t text_size) { edited_.add(replaced, text_size); }
  void text_set() { edited_.add_whole_text(); }

  /// Makes the tokens those of the snapshot, under an id that no other state has.
  Change update(const Snapshot& snapshot, ColumnUnit unit, uint64_t result_id);
  /// All numbers, as JSON with brackets.
  std::string data() const;
  /// What turns the numbers before the last update, which made the change, into those now. In order.
  std::vector<Edit> edits(const Change& change) const;
  /// Of the last update; empty before the first.
  const std::string& result_id() const { return result_id_; }

 private:
  std::vector<Entry> encode(const Snapshot& snapshot, uint32_t first, uint32_t end, ColumnUnit unit,
                            const std::vector<Entry>& reusable) const;
  void place_leads(const Snapshot& snapshot, uint32_t first, uint32_t end, ColumnUnit unit);
  std::optional<uint32_t> next_with_tokens(uint32_t from) const;
  std::optional<uint32_t> last_with_tokens_before(uint32_t end) const;

  std::vector<Entry> entries_;  ///< by block of `shown_`
  std::optional<Snapshot> shown_;
  std::optional<features::HiddenConventions> hidden_;
  EditedRegion edited_;  ///< since `shown_`
  std::string result_id_;
};

}  // namespace texbrdf::lsp
