#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "features/hover.h"
#include "lsp/client_process.h"
#include "lsp/dispatcher.h"
#include "lsp/documents.h"
#include "lsp/json_rpc.h"
#include "lsp/json_writer.h"
#include "lsp/log.h"
#include "lsp/positions.h"
#include "lsp/protocol.h"
#include "lsp/write_results.h"

namespace texbrdf::lsp {

/// Messages counted for `texbrdf/stats`.
struct Traffic {
  uint64_t requests = 0;
  uint64_t notifications = 0;
  uint64_t cancelled = 0;
  uint64_t errors = 0;  ///< error replies
  uint64_t published = 0;
};

/// Everything between one client's `initialize` and `exit`: what it can do, its open documents, and a handler for each
/// method. Knows neither bytes nor the order in which messages are handled.
class Session {
 public:
  enum class Phase : uint8_t { Created, Running, ShutDown, Exited };

  /// All have to outlive the session.
  Session(Log& log, ClientProcess& client_process, std::string_view version, std::string_view docs_url)
      : log_(log), client_process_(client_process), program_version_(version), docs_url_(docs_url) {}

  /// The dispatch table: one line a method (methods.cpp).
  void bind_methods(Dispatcher& bind);

  Phase phase() const { return phase_; }
  /// 0 where `shutdown` came before the end.
  int exit_status() const { return shut_down_ ? 0 : 1; }
  Traffic& traffic() { return traffic_; }

  /// The parameters of the next `publishDiagnostics` to send. Precondition: has_publications().
  void write_next_publication(JsonWriter& out);
  bool has_publications() { return !closed_.empty() || documents_.next_unpublished() != nullptr; }

 private:
  using Outcome = std::optional<ResponseError>;

  // lifecycle.cpp
  Outcome initialize(const InitializeParams& params, JsonWriter& result);
  Outcome shutdown(const NoParams& params, JsonWriter& result);
  std::string initialized(const NoParams& params);
  std::string exit(const NoParams& params);
  void greet_client();
  void write_capabilities(JsonWriter& out) const;

  // text_sync.cpp
  std::string did_open(const DidOpenParams& params);
  std::string did_change(const DidChangeParams& params);
  std::string did_save(const DocumentParams& params);
  std::string did_close(const DocumentParams& params);
  void apply(const ContentChange& change, Document& document) const;

  // queries.cpp
  Outcome hover(const PositionParams& params, JsonWriter& result);
  Outcome definition(const PositionParams& params, JsonWriter& result);
  Outcome references(const ReferenceParams& params, JsonWriter& result);
  Outcome document_symbol(const DocumentParams& params, JsonWriter& result);
  Outcome stats(const NoParams& params, JsonWriter& result);

  static ResponseError not_open(std::string_view uri);

  Log& log_;
  ClientProcess& client_process_;
  std::string_view program_version_;
  std::string_view docs_url_;
  Phase phase_ = Phase::Created;
  bool shut_down_ = false;
  InitializeParams client_;
  ColumnUnit unit_ = ColumnUnit::Utf16;
  features::Markup hover_markup_ = features::Markup::Markdown;
  Documents documents_;
  std::vector<std::string> closed_;  ///< URIs whose diagnostics are to be taken away
  Traffic traffic_;
};

}  // namespace texbrdf::lsp
