#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texbrdf::web {

/// One of the pages that is there: each stream of events is one.
using ClientId = uint64_t;

struct Page {
  std::string path;  ///< behind the token; empty: the first
  std::string content_type;
  std::string body;
};

struct Site {
  uint16_t port = 0;
  std::string token;
  std::vector<Page> pages;
};

/// What is asked for, as far as it decides who is let in.
struct RequestHead {
  enum class Method : uint8_t { Get, Post, Other };
  Method method = Method::Other;
  std::string_view target;
  std::vector<std::string_view> hosts;  ///< each header of that name
  std::optional<std::string_view> origin;
  std::string_view content_type;
};

struct Route {
  enum class Kind : uint8_t { Refused, Page, Events, Message };
  Kind kind = Kind::Refused;
  unsigned status = 200;       ///< of a refusal
  const Page* page = nullptr;  ///< of a Page
  ClientId client = 0;         ///< of a Message: who sends it
};

Route find_route(const RequestHead& head, const Site& site);

}  // namespace texbrdf::web
