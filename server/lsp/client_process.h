#pragma once

#include <cstdint>
#include <functional>
#include <utility>

namespace texbrdf::lsp {

/// Whether a process exists; also true where it may not be signalled.
bool process_exists(int64_t process_id);

/// The process that the client said it is. A client in another process namespace cannot be seen from here: only one
/// that was seen can go away.
class ClientProcess {
 public:
  explicit ClientProcess(std::function<bool(int64_t)> exists) : exists_(std::move(exists)) {}

  /// False where there is no such process to be seen.
  bool watch(int64_t process_id) {
    id_ = process_id;
    seen_ = process_id > 0 && exists_(process_id);
    return seen_;
  }
  bool is_gone() const { return seen_ && !exists_(id_); }

 private:
  std::function<bool(int64_t)> exists_;
  int64_t id_ = 0;
  bool seen_ = false;
};

}  // namespace texbrdf::lsp
