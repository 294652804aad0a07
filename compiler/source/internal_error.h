#pragma once

#include <stdexcept>
#include <string>

namespace texbrdf {

/// A broken invariant of ours, never a mistake of the user. Only the LSP dispatcher and main catch it.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws InternalError with `what` unless `condition` holds.
inline void require(bool condition, const char* what) {
  if (!condition) throw InternalError(what);
}

}  // namespace texbrdf
