#include "lsp/progress.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace texbrdf::lsp {
namespace {

void notify(Outbox& outbox, std::string_view token, std::string_view kind, std::string_view title) {
  outbox.notify("$/progress", [&](JsonWriter& params) {
    params.begin_object();
    params.key("token");
    params.raw(token);
    params.key("value");
    params.begin_object();
    params.member("kind", kind);
    if (!title.empty()) params.member("title", title);
    params.end_object();
    params.end_object();
  });
}

}  // namespace

Progress::Progress(Outbox& outbox, std::string token, std::string_view title)
    : outbox_(outbox), token_(std::move(token)) {
  if (!token_.empty()) notify(outbox_, token_, "begin", title);
}

Progress::~Progress() {
  if (!token_.empty()) notify(outbox_, token_, "end", {});
}

std::string work_done_token(const nlohmann::json& params) {
  if (!params.is_object()) return {};
  const auto token = params.find("workDoneToken");
  const bool given = token != params.end() && (token->is_string() || token->is_number_integer());
  return given ? token->dump() : std::string{};
}

}  // namespace texbrdf::lsp
