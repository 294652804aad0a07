#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texbrdf {

/// Finds the name that somebody may have meant. Decoration, backslash and braces weigh less than letters:
/// `pi` is near `\pi`, `rho_d` near `\rho_d`.
class NearestName {
 public:
  /// Candidates are canonical forms; the earlier of two that are equally near is taken.
  void add(std::string_view candidate);
  /// Takes the work done off `steps`; nothing where they do not suffice.
  std::optional<std::string> find(std::string_view wanted, uint64_t& steps) const;
  bool empty() const { return candidates_.empty(); }

 private:
  struct Candidate {
    std::string spelling;
    std::string letters;
    uint64_t which;  ///< a bit for each letter that occurs
  };
  std::vector<Candidate> candidates_;
};

}  // namespace texbrdf
