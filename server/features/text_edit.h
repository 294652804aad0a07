#pragma once

#include <string>

#include "source/span.h"

namespace texbrdf::features {

/// A change to a document; `span` is absolute and empty for an insertion.
struct TextEdit {
  Span span;
  std::string text;
};

}  // namespace texbrdf::features
