#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

#include "analysis/segment.h"
#include "semantics/names.h"
#include "semantics/nearest_name.h"

namespace texbrdf {

/// The names that somebody may have meant by one that is not defined. Kept as long as the document defines the same
/// names in the same order. Any thread may ask.
class NameSuggestions {
 public:
  /// Nothing where no name is near.
  std::optional<std::string> nearest(const std::string& wanted, const SegmentSequence& segments,
                                     const NameTable& names);

 private:
  void list_candidates(const SegmentSequence& segments, const NameTable& names);

  std::mutex mutex_;
  bool is_listed_ = false;
  NearestName candidates_;
  std::unordered_map<std::string, std::optional<std::string>> answers_;
};

}  // namespace texbrdf
