#include "render/protocol.h"

#include <gtest/gtest.h>

#include <random>

namespace texbrdf::render {
namespace {

ShaderModel model() {
  return {"vec3 brdf()", {{"m", 1, {0.25F, 0, 0}}, {"rho", 3, {1, 2, 3}}}};
}

std::vector<Message> samples() {
  EvaluateRequest evaluate{model(), {}};
  for (auto& list : evaluate.geometry) list = {1, 2, 3};
  DrawAnswer drawn;
  drawn.picture.image = {2, 1, {1, 2, 3, 4, 5, 6, 7, 8}};
  drawn.picture.bad_pixels[BadPixel::Infinite] = 7;
  return {
      encode(Greeting{true, "llvmpipe"}), encode(DrawRequest{model(), {}}),          encode(evaluate), encode(drawn),
      encode(EvaluateAnswer{{1, 2, 3}}),  encode(Refusal{RefusalKind::Shader, "no"})};
}

bool any_decodes(const Message& message) {
  return decode<Greeting>(message) || decode<DrawRequest>(message) || decode<EvaluateRequest>(message) ||
         decode<DrawAnswer>(message) || decode<EvaluateAnswer>(message) || decode<Refusal>(message);
}

TEST(Protocol, RequestsSurviveTheTrip) {
  const SphereView view{.size = 12, .theta = 1, .phi = 2, .gamma = 3, .exposure = 4};
  const auto drawn = decode<DrawRequest>(encode(DrawRequest{model(), view}));
  ASSERT_TRUE(drawn);
  EXPECT_EQ(drawn->view, view);
  EXPECT_EQ(drawn->model.source, "vec3 brdf()");
  ASSERT_EQ(drawn->model.uniforms.size(), 2U);
  EXPECT_EQ(drawn->model.uniforms[1].name, "rho");
  EXPECT_EQ(drawn->model.uniforms[1].components, 3U);
  EXPECT_EQ(drawn->model.uniforms[1].value, (std::array<float, 3>{1, 2, 3}));
  const auto refused = decode<Refusal>(encode(Refusal{RefusalKind::Renderer, "lost"}));
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->kind, RefusalKind::Renderer);
  EXPECT_EQ(refused->message, "lost");
}

TEST(Protocol, AnswersSurviveTheTrip) {
  const auto drawn = decode<DrawAnswer>(samples()[3]);
  ASSERT_TRUE(drawn);
  EXPECT_EQ(drawn->picture.image.pixels, (std::vector<uint8_t>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(drawn->picture.bad_pixels[BadPixel::Infinite], 7U);
  const auto values = decode<EvaluateAnswer>(samples()[4]);
  ASSERT_TRUE(values);
  EXPECT_EQ(values->values, (std::vector<float>{1, 2, 3}));
}

TEST(Protocol, EverySampleDecodesAsItsKindOnly) {
  for (Message message : samples()) {
    EXPECT_TRUE(any_decodes(message));
    message.kind = 99;
    EXPECT_FALSE(any_decodes(message));
  }
}

TEST(Protocol, CutOrLengthenedMessagesAreRefused) {
  for (const Message& message : samples()) {
    for (std::size_t size = 0; size < message.payload.size(); ++size) {
      Message cut = message;
      cut.payload.resize(size);
      EXPECT_FALSE(any_decodes(cut)) << message.kind << " cut to " << size;
    }
    Message longer = message;
    longer.payload.push_back(0);
    EXPECT_FALSE(any_decodes(longer));
  }
}

TEST(Protocol, RandomBytesAreAnsweredWithoutHarm) {
  std::mt19937 random(7);
  for (int round = 0; round < 20'000; ++round) {
    Message message{static_cast<uint32_t>(random() % 8), {}};
    message.payload.resize(random() % 80);
    for (uint8_t& byte : message.payload) byte = random() % 4 == 0 ? static_cast<uint8_t>(random()) : uint8_t{0};
    any_decodes(message);
  }
}

TEST(Protocol, SizesThatDoNotFitAreRefused) {
  DrawAnswer drawn;
  drawn.picture.image = {3, 1, {1, 2, 3, 4, 5, 6, 7, 8}};
  EXPECT_FALSE(decode<DrawAnswer>(encode(drawn)));
  EvaluateRequest evaluate{model(), {}};
  for (auto& list : evaluate.geometry) list = {1, 2, 3};
  evaluate.geometry[14].pop_back();
  EXPECT_FALSE(decode<EvaluateRequest>(encode(evaluate)));
  DrawRequest odd{model(), {}};
  odd.model.uniforms[0].components = 2;
  EXPECT_FALSE(decode<DrawRequest>(encode(odd)));
}

}  // namespace
}  // namespace texbrdf::render
