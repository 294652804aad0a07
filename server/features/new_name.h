#pragma once

#include <string>
#include <string_view>

#include "semantics/name_traits.h"
#include "source/result.h"

namespace texbrdf::features {

/// What somebody typed to be a name.
struct NewName {
  std::string text;       ///< without white space around it
  std::string canonical;  ///< see `canonical_form`
  NameTraits traits;
};

/// Why it is no name that a document may define, in one line for a person, where it is none.
Result<NewName> read_new_name(std::string_view typed);

}  // namespace texbrdf::features
