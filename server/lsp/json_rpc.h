#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "lsp/json_writer.h"

namespace texbrdf::lsp {

/// The error codes in use of JSON-RPC and of the protocol.
enum class ErrorCode : int {
  ParseError = -32700,
  InvalidRequest = -32600,
  MethodNotFound = -32601,
  InvalidParams = -32602,
  InternalError = -32603,
  ServerNotInitialized = -32002,
  RequestCancelled = -32800,
  RequestFailed = -32803,
};

struct ResponseError {
  ErrorCode code;
  std::string message;
};

/// What a client sent, as far as JSON-RPC looks at it.
struct IncomingMessage {
  enum class Kind : uint8_t { Request, Notification, Response, Broken };
  Kind kind = Kind::Broken;
  /// JSON text of the id, "null" where it is null or could not be read; empty for a notification.
  std::string id;
  std::string method;
  std::shared_ptr<nlohmann::json> params;  ///< object, array or null; never nullptr for requests and notifications
  /// Of a Response; nullptr where it is an error, which is then `problem`.
  std::shared_ptr<nlohmann::json> result;
  ResponseError problem{};  ///< of a Broken one
};

/// Never fails: what is no JSON or no message is Broken. Nesting and the number of values are limited, so that the
/// memory taken is bounded. A lone surrogate escape, which editors send, is read as U+FFFD.
IncomingMessage parse_message(std::string_view body);

/// Up to where the result stands; the caller writes it and ends the object.
void begin_response(JsonWriter& out, std::string_view id);
/// Up to where the parameters stand; the caller writes them and ends the object.
void begin_notification(JsonWriter& out, std::string_view method);
std::string error_text(std::string_view id, const ResponseError& error);

/// The id in the parameters of `$/cancelRequest`, as JSON text; nothing where there is none.
std::optional<std::string> cancelled_id(const nlohmann::json& params);

}  // namespace texbrdf::lsp
