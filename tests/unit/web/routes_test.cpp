#include "web/routes.h"

#include <gtest/gtest.h>

namespace texbrdf::web {
namespace {

using Kind = Route::Kind;
using Method = RequestHead::Method;

class RoutesTest : public testing::Test {
 protected:
  RequestHead get(std::string_view target) const {
    RequestHead head;
    head.method = Method::Get;
    head.target = target;
    head.hosts = {"127.0.0.1:4321"};
    return head;
  }
  RequestHead post(std::string_view target) const {
    RequestHead head = get(target);
    head.method = Method::Post;
    head.content_type = "application/json";
    return head;
  }
  Route route(const RequestHead& head) const { return find_route(head, site_); }
  unsigned refusal(const RequestHead& head) const {
    const Route found = route(head);
    return found.kind == Kind::Refused ? found.status : 0;
  }

  Site site_{
      .port = 4321, .token = "secret", .pages = {{"", "text/html", "first"}, {"main.js", "text/javascript", "code"}}};
};

TEST_F(RoutesTest, PagesStandBehindTheToken) {
  ASSERT_EQ(route(get("/secret/")).kind, Kind::Page);
  EXPECT_EQ(route(get("/secret/")).page->body, "first");
  ASSERT_EQ(route(get("/secret/main.js")).kind, Kind::Page);
  EXPECT_EQ(route(get("/secret/main.js")).page->body, "code");
  EXPECT_EQ(route(get("/secret/events")).kind, Kind::Events);
}

TEST_F(RoutesTest, WithoutTheTokenThereIsNothing) {
  for (const char* target : {"/", "/main.js", "/events", "/secreT/", "/secret", "/favicon.ico", "*", ""}) {
    EXPECT_EQ(refusal(get(target)), 404U) << target;
  }
  EXPECT_EQ(refusal(post("/wrong/messages/1")), 404U);
}

TEST_F(RoutesTest, WhatIsNotThereIsNotFound) {
  for (const char* target : {"/secret/other", "/secret/../main.js", "/secret/main.js?x", "/secret/events/"}) {
    EXPECT_EQ(refusal(get(target)), 404U) << target;
  }
}

TEST_F(RoutesTest, ANameOfAnotherSiteIsRefusedEvenWithTheToken) {
  RequestHead head = get("/secret/");
  head.hosts = {"evil.example:4321"};
  EXPECT_EQ(refusal(head), 403U);
  head.hosts = {};
  EXPECT_EQ(refusal(head), 403U);
  head.hosts = {"127.0.0.1:4321", "evil.example:4321"};
  EXPECT_EQ(refusal(head), 403U);
  head.hosts = {"localhost:4321"};
  EXPECT_EQ(refusal(head), 0U);
}

TEST_F(RoutesTest, AnotherOriginIsRefusedEvenWithTheToken) {
  RequestHead head = post("/secret/messages/1");
  head.origin = "http://evil.example";
  EXPECT_EQ(refusal(head), 403U);
  head.origin = "null";
  EXPECT_EQ(refusal(head), 403U);
  head.origin = "http://127.0.0.1:4321";
  EXPECT_EQ(refusal(head), 0U);
}

TEST_F(RoutesTest, MessagesSayWhoseTheyAre) {
  const Route found = route(post("/secret/messages/17"));
  ASSERT_EQ(found.kind, Kind::Message);
  EXPECT_EQ(found.client, 17U);
  for (const char* target : {"/secret/messages/", "/secret/messages/x", "/secret/messages/1x", "/secret/messages/-1",
                             "/secret/messages/99999999999999999999"}) {
    EXPECT_EQ(refusal(post(target)), 404U) << target;
  }
}

TEST_F(RoutesTest, FormsOfOtherSitesCannotPost) {
  RequestHead head = post("/secret/messages/1");
  head.content_type = "text/plain";
  EXPECT_EQ(refusal(head), 415U);
  EXPECT_EQ(refusal(get("/secret/messages/1")), 405U);
  EXPECT_EQ(refusal(post("/secret/")), 405U);
  head = get("/secret/events");
  head.method = Method::Other;
  EXPECT_EQ(refusal(head), 405U);
}

}  // namespace
}  // namespace texbrdf::web
