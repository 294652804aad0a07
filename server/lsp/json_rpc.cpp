#include "lsp/json_rpc.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "lsp/json_limits.h"
#include "lsp/json_writer.h"

namespace texbrdf::lsp {
namespace {

using nlohmann::json;

constexpr std::string_view kNullId = "null";

IncomingMessage broken(ErrorCode code, std::string message, std::string id = std::string(kNullId)) {
  IncomingMessage result;
  result.id = std::move(id);
  result.problem = {code, std::move(message)};
  return result;
}

json parse_tolerantly(std::string_view body) {
  json value = json::parse(body, nullptr, false);
  if (value.is_discarded()) value = json::parse(without_lone_surrogates(body), nullptr, false);
  return value;
}

bool is_id(const json& value) {
  return value.is_string() || value.is_number_integer() || value.is_null();
}

/// Only a message that can be told to be a response: it has no method, but an id and a result or an error.
bool is_response(const json& message) {
  return message.contains("id") && (message.contains("result") || message.contains("error"));
}

void read_outcome(json& response, IncomingMessage& out) {
  const auto error = response.find("error");
  if (error == response.end() || error->is_null()) {
    const auto result = response.find("result");
    out.result = std::make_shared<json>(result == response.end() ? json() : std::move(*result));
    return;
  }
  const json text = error->is_object() ? error->value("message", json()) : json();
  out.problem.message = text.is_string() ? text.get<std::string>() : "without a reason";
}

}  // namespace

IncomingMessage parse_message(std::string_view body) {
  if (auto excess = exceeds_json_limits(body)) return broken(ErrorCode::InvalidRequest, std::move(*excess));
  json message = parse_tolerantly(body);
  if (message.is_discarded()) return broken(ErrorCode::ParseError, "the message is not JSON");
  if (message.is_array()) return broken(ErrorCode::InvalidRequest, "batches are not part of the protocol");
  if (!message.is_object()) return broken(ErrorCode::InvalidRequest, "the message is not an object");

  IncomingMessage result;
  const auto id = message.find("id");
  if (id != message.end() && !is_id(*id)) return broken(ErrorCode::InvalidRequest, "`id` is no string or integer");
  if (id != message.end()) result.id = id->dump();
  const auto invalid = [&](const char* reason) {
    return broken(ErrorCode::InvalidRequest, reason, id != message.end() ? result.id : std::string(kNullId));
  };
  const auto version = message.find("jsonrpc");
  if (version == message.end() || !version->is_string() || version->get_ref<const std::string&>() != "2.0")
    return invalid("`jsonrpc` is not \"2.0\"");

  const auto method = message.find("method");
  if (method == message.end()) {
    if (!is_response(message)) return invalid("the message has no `method`");
    result.kind = IncomingMessage::Kind::Response;
    read_outcome(message, result);
    return result;
  }
  if (!method->is_string()) return invalid("`method` is not a string");
  result.kind = id == message.end() ? IncomingMessage::Kind::Notification : IncomingMessage::Kind::Request;
  result.method = std::move(method->get_ref<std::string&>());
  const auto params = message.find("params");
  result.params = std::make_shared<json>(params == message.end() ? json() : std::move(*params));
  if (!result.params->is_structured() && !result.params->is_null()) return invalid("`params` is no object or array");
  return result;
}

void begin_response(JsonWriter& out, std::string_view id) {
  out.begin_object();
  out.member("jsonrpc", "2.0");
  out.key("id");
  out.raw(id);
  out.key("result");
}

std::string error_text(std::string_view id, const ResponseError& error) {
  JsonWriter writer;
  writer.begin_object();
  writer.member("jsonrpc", "2.0");
  writer.key("id");
  writer.raw(id);
  writer.key("error");
  writer.begin_object();
  writer.member("code", static_cast<int>(error.code));
  writer.member("message", error.message);
  writer.end_object();
  writer.end_object();
  return writer.take();
}

void begin_notification(JsonWriter& out, std::string_view method) {
  out.begin_object();
  out.member("jsonrpc", "2.0");
  out.member("method", method);
  out.key("params");
}

std::optional<std::string> cancelled_id(const json& params) {
  if (!params.is_object()) return std::nullopt;
  const auto id = params.find("id");
  if (id == params.end() || !is_id(*id)) return std::nullopt;
  return id->dump();
}

}  // namespace texbrdf::lsp
