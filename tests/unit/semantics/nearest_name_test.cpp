#include "semantics/nearest_name.h"

#include <gtest/gtest.h>

namespace texbrdf {
namespace {

TEST(NearestName, FindsWhatWasMeant) {
  NearestName names;
  for (const char* name : {"\\pi", "\\rho_d", "\\rho_{\\text{diffuse}}", "roughness", "x", "X_1", "\\theta_h"})
    names.add(name);
  const std::pair<const char*, std::optional<std::string>> cases[] = {
      {"pi", "\\pi"},
      {"rho_d", "\\rho_d"},
      {"\\rho_{\\text{difuse}}", "\\rho_{\\text{diffuse}}"},
      {"rougness", "roughness"},
      {"\\text{Roughness}", "roughness"},
      {"roughenss", "roughness"},
      {"X", "x"},
      {"x_1", "X_1"},
      {"y", std::nullopt},
      {"\\theta_x", "\\theta_h"},
      {"completely_different", std::nullopt},
      {"", std::nullopt},
  };
  for (const auto& [wanted, expected] : cases) {
    uint64_t steps = 10'000;
    EXPECT_EQ(names.find(wanted, steps), expected) << wanted;
    EXPECT_LT(steps, 10'000u);
  }
}

TEST(NearestName, LeavesHugeNamesAlone) {
  NearestName names;
  names.add(std::string(100'000, 'a'));
  uint64_t steps = 1000;
  EXPECT_EQ(names.find(std::string(99'999, 'a'), steps), std::nullopt);
}

TEST(NearestName, StopsWhenTheWorkIsUsedUp) {
  NearestName names;
  names.add("roughness");
  uint64_t steps = 50;
  EXPECT_EQ(names.find("roughnes", steps), std::nullopt);
  steps = 500;
  EXPECT_EQ(names.find("roughnes", steps), "roughness");
}

}  // namespace
}  // namespace texbrdf
