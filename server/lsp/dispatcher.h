#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "lsp/json_rpc.h"
#include "lsp/json_writer.h"
#include "lsp/read_params.h"
#include "source/internal_error.h"

namespace texbrdf::lsp {

/// The methods that are answered, each bound in one line to a member function of its target. The function's
/// parameter decides how the message is read; a handler sees only well-formed parameters.
class Dispatcher {
 public:
  using Request = std::function<std::optional<ResponseError>(nlohmann::json& params, JsonWriter& result)>;
  /// Returns why the notification was not taken, empty where it was.
  using Notification = std::function<std::string(nlohmann::json& params)>;

  template <typename Target, typename Params>
  void request(const char* method, Target& target,
               std::optional<ResponseError> (Target::*handler)(const Params&, JsonWriter&)) {
    add(requests_, method, Request([&target, handler](nlohmann::json& json, JsonWriter& result) {
          Params params;
          if (std::string problem = read_params(json, params); !problem.empty()) {
            return std::optional<ResponseError>({ErrorCode::InvalidParams, std::move(problem)});
          }
          return (target.*handler)(params, result);
        }));
  }

  template <typename Target, typename Params>
  void notification(const char* method, Target& target, std::string (Target::*handler)(const Params&)) {
    add(notifications_, method, Notification([&target, handler](nlohmann::json& json) {
          Params params;
          std::string problem = read_params(json, params);
          return problem.empty() ? (target.*handler)(params) : problem;
        }));
  }

  const Request* find_request(std::string_view method) const { return find(requests_, method); }
  const Notification* find_notification(std::string_view method) const { return find(notifications_, method); }

 private:
  template <typename Handler>
  using Table = std::unordered_map<std::string, Handler>;

  template <typename Handler>
  static void add(Table<Handler>& table, const char* method, Handler handler) {
    require(table.emplace(method, std::move(handler)).second, "a method is bound twice");
  }
  template <typename Handler>
  static const Handler* find(const Table<Handler>& table, std::string_view method) {
    const auto found = table.find(std::string(method));
    return found == table.end() ? nullptr : &found->second;
  }

  Table<Request> requests_;
  Table<Notification> notifications_;
};

}  // namespace texbrdf::lsp
