#pragma once

#include <string>
#include <string_view>

#include "lsp/outbox.h"

namespace texbrdf::lsp {

/// Tells the client that work has begun, and at the end of its own life that it is done.
class Progress {
 public:
  /// `token` is JSON text; an empty one tells nothing.
  Progress(Outbox& outbox, std::string token, std::string_view title);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

 private:
  Outbox& outbox_;
  std::string token_;
};

/// The `workDoneToken` of a request's parameters as JSON text, empty where there is none.
std::string work_done_token(const nlohmann::json& params);

}  // namespace texbrdf::lsp
