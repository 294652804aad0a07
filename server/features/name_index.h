#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "semantics/names.h"

namespace texbrdf::features {

/// What of a spelling counts when names are looked for: letters without case, digits and signs. A leading backslash is
/// kept: `\rho_{d}` gives `\rho_d`, `\vec{\alpha` gives `\vecalpha`.
std::string search_key(std::string_view spelling);
/// The same for somebody who types only what is inside a decoration: `\vec{n}` gives `n`, `\rho_d` gives `rho_d`.
std::string bare_search_key(std::string_view spelling);

/// True where a name may be meant by one who has typed `key`, a search key, so far.
bool starts_with_key(std::string_view name, std::string_view key);

/// The names of a document, sorted to be looked for by how they begin. It outlives edits: a table of names only grows,
/// and whether a name is defined at the moment is asked of the snapshot.
class NameIndex {
 public:
  /// Takes in what came into the table since the last call; another table starts it anew.
  void update(const std::shared_ptr<const NameTable>& table);

  struct Matches {
    std::vector<NameId> names;  ///< in order of their keys
    bool complete = true;       ///< false where there are more than were asked for
  };
  /// The names whose search key starts so.
  Matches starting_with(std::string_view wanted, std::size_t most) const;

 private:
  struct Entry {
    uint32_t begin = 0;  ///< of its key
    uint32_t size = 0;
    NameId name;
  };
  std::string_view key(const Entry& entry) const { return std::string_view(keys_).substr(entry.begin, entry.size); }
  void add(std::string_view key, NameId name);
  void sort_added(std::size_t first);

  std::weak_ptr<const NameTable> table_;
  uint32_t known_ = 0;          ///< names of the table that are in
  std::string keys_;            ///< one after the other
  std::vector<Entry> entries_;  ///< sorted; a name that starts with a backslash has two
};

}  // namespace texbrdf::features
