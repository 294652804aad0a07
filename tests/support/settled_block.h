#pragma once

#include "semantics/find_reading.h"

namespace texbrdf::test {

/// The block as it is read where the document makes of names what `known` says.
inline ParsedBlock settled_block(const ParsedBlock& plain, NameTable& table, const KnownNames& known) {
  return parse_block(plain.source(), plain.source_extent(), std::pmr::get_default_resource(),
                     find_reading(plain, read_names(plain, table), table, known).reading, plain.expansion);
}

}  // namespace texbrdf::test
