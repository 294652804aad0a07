#include "render/protocol.h"

#include <gtest/gtest.h>

#include <random>

#include "render/scene_protocol.h"

namespace texbrdf::render {
namespace {

ShaderModel model() {
  return {"vec3 brdf()", {{"m", 1, {0.25F, 0, 0}}, {"rho", 3, {1, 2, 3}}}};
}

SceneRequest scene_request() {
  SceneRequest request{"vec2 scene_distance()", {}, {}, {64, 32, 1, 2, 3, 4}, {{0.25F, 0.5F}, {0.75F, 0}}};
  request.state.camera.position = {1, 2, 3};
  request.state.lights = {scene::DirectionalLight{{1, 0, 0}, {4, 5, 6}}, scene::PointLight{{7, 8, 9}, {1, 2, 3}}};
  request.state.environment.background = {0.5, 0.25, 0.125};
  request.state.settings.max_steps = 77;
  request.state.frames = {1, 2, 3, 4};
  request.look = {SceneView::Lipschitz, Shadows::Soft, 3, true, 0.5};
  return request;
}

std::vector<Message> samples() {
  EvaluateRequest evaluate{model(), {}};
  for (auto& list : evaluate.geometry) list = {1, 2, 3};
  DrawAnswer drawn;
  drawn.picture.image = {2, 1, {1, 2, 3, 4, 5, 6, 7, 8}};
  drawn.picture.bad_pixels[BadPixel::Infinite] = 7;
  return {encode(Greeting{true, "llvmpipe"}),
          encode(DrawRequest{model(), {}}),
          encode(evaluate),
          encode(drawn),
          encode(EvaluateAnswer{{1, 2, 3}}),
          encode(Refusal{RefusalKind::Shader, "no"}),
          encode(scene_request()),
          encode(SceneAnswer{{1, 2, 3}, 4, true})};
}

bool any_decodes(const Message& message) {
  return decode<Greeting>(message) || decode<DrawRequest>(message) || decode<EvaluateRequest>(message) ||
         decode<DrawAnswer>(message) || decode<EvaluateAnswer>(message) || decode<Refusal>(message) ||
         decode<SceneRequest>(message) || decode<SceneAnswer>(message);
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

TEST(Protocol, ScenesSurviveTheTrip) {
  const SceneRequest sent = scene_request();
  const auto request = decode<SceneRequest>(encode(sent));
  ASSERT_TRUE(request);
  EXPECT_EQ(request->source, sent.source);
  EXPECT_EQ(request->look, sent.look);
  EXPECT_EQ(request->tile, sent.tile);
  EXPECT_EQ(request->sample.pixel, sent.sample.pixel);
  EXPECT_EQ(request->sample.ambient, sent.sample.ambient);
  EXPECT_EQ(request->state.frames, sent.state.frames);
  EXPECT_EQ(request->state.camera.position, sent.state.camera.position);
  EXPECT_EQ(request->state.environment.background, sent.state.environment.background);
  EXPECT_EQ(request->state.settings.max_steps, 77U);
  ASSERT_EQ(request->state.lights.size(), 2U);
  EXPECT_EQ(std::get<scene::DirectionalLight>(request->state.lights[0]).colour, (scene::Triple{4, 5, 6}));
  EXPECT_EQ(std::get<scene::PointLight>(request->state.lights[1]).position, (scene::Triple{7, 8, 9}));
  const auto answer = decode<SceneAnswer>(encode(SceneAnswer{{1, 2, 3}, 4, true}));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->values, (std::vector<float>{1, 2, 3}));
  EXPECT_EQ(answer->milliseconds, 4);
  EXPECT_TRUE(answer->compiled);
}

TEST(Protocol, ScenesOutOfRangeAreRefused) {
  SceneRequest request = scene_request();
  request.look.view = static_cast<SceneView>(5);
  EXPECT_FALSE(decode<SceneRequest>(encode(request)));
  request = scene_request();
  request.look.shadows = static_cast<Shadows>(3);
  EXPECT_FALSE(decode<SceneRequest>(encode(request)));
  request = scene_request();
  request.sample.pixel[1] = 1;
  EXPECT_FALSE(decode<SceneRequest>(encode(request)));
  request = scene_request();
  request.state.lights.resize(17);
  EXPECT_FALSE(decode<SceneRequest>(encode(request)));
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
    Message message{static_cast<uint32_t>(random() % 10), {}};
    message.payload.resize(random() % 400);
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
