#include "web/access.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace texbrdf::web {
namespace {

TEST(Access, ATokenIsLongAndNeverTheSame) {
  std::set<std::string> seen;
  for (int i = 0; i < 100; ++i) {
    const auto token = make_token();
    ASSERT_TRUE(token);
    EXPECT_EQ(token->size(), 22U);
    EXPECT_TRUE(std::ranges::all_of(*token, [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; }))
        << *token;
    EXPECT_TRUE(seen.insert(*token).second);
  }
}

TEST(Access, SecretsAreTheSameOnlyWhole) {
  EXPECT_TRUE(is_same_secret("abcd", "abcd"));
  EXPECT_FALSE(is_same_secret("abcx", "abcd"));
  EXPECT_FALSE(is_same_secret("xbcd", "abcd"));
  EXPECT_FALSE(is_same_secret("abc", "abcd"));
  EXPECT_FALSE(is_same_secret("abcde", "abcd"));
  EXPECT_FALSE(is_same_secret("", "abcd"));
}

TEST(Access, OnlyNamesOfThisMachineAreItsHost) {
  EXPECT_TRUE(is_own_host("127.0.0.1:4321", 4321));
  EXPECT_TRUE(is_own_host("localhost:4321", 4321));
  EXPECT_TRUE(is_own_host("localhost", 80));
  for (const char* host : {"", "127.0.0.1", "localhost", "127.0.0.1:432", "127.0.0.1:43210", "localhost:4322",
                           "evil.example:4321", "localhost.evil.example:4321", "127.0.0.1:4321.evil.example",
                           "[::1]:4321", "0.0.0.0:4321", "127.0.0.2:4321", "127.1:4321", " localhost:4321"}) {
    EXPECT_FALSE(is_own_host(host, 4321)) << host;
  }
}

TEST(Access, OnlyThisServerIsItsOrigin) {
  EXPECT_TRUE(is_own_origin("http://127.0.0.1:4321", 4321));
  EXPECT_TRUE(is_own_origin("http://localhost:4321", 4321));
  for (const char* origin : {"", "null", "https://127.0.0.1:4321", "http://127.0.0.1", "http://localhost:80",
                             "http://evil.example:4321", "127.0.0.1:4321", "http://127.0.0.1:4321/"}) {
    EXPECT_FALSE(is_own_origin(origin, 4321)) << origin;
  }
}

TEST(Access, APathStandsBehindTheToken) {
  EXPECT_EQ(path_behind_token("/secret/", "secret"), "");
  EXPECT_EQ(path_behind_token("/secret/a/b", "secret"), "a/b");
  for (const char* target : {"", "/", "secret/", "/secret", "/Secret/", "/secret2/", "/secre/", "//secret/",
                             "/x/secret/", "http://127.0.0.1/secret/", "/%73ecret/"}) {
    EXPECT_FALSE(path_behind_token(target, "secret")) << target;
  }
  EXPECT_FALSE(path_behind_token("//", ""));
}

}  // namespace
}  // namespace texbrdf::web
