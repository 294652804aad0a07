#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "scene/scene_shader.h"
#include "scene_support.h"

// Scenes in the worker: tiles, programs that are kept, and what may go wrong.

namespace texbrdf::render {
namespace {

using namespace std::chrono_literals;
using test::expect_scene;
using test::kUnitSphere;
using test::scene_job;
using test::scene_source;

SceneRequest request_of(const SceneJob& job) {
  return {job.source, job.state, job.look, {job.width, job.height, 0, 0, job.width, job.height}, {}};
}

SceneAnswer expect_answer(const std::variant<SceneAnswer, RenderFault>& result) {
  if (const auto* fault = std::get_if<RenderFault>(&result)) {
    ADD_FAILURE() << fault->message;
    return {};
  }
  return std::get<SceneAnswer>(result);
}

RenderFault expect_fault(const std::variant<SceneAnswer, RenderFault>& result) {
  const auto* fault = std::get_if<RenderFault>(&result);
  if (fault == nullptr) ADD_FAILURE() << "there is a picture";
  return fault == nullptr ? RenderFault{} : *fault;
}

TEST(SceneWorker, MovingAnythingCompilesNothing) {
  RenderWorker worker(test::worker_options());
  SceneRequest request = request_of(scene_job(scene_source(kUnitSphere)));
  EXPECT_TRUE(expect_answer(worker.trace(request)).compiled);
  request.state.camera.position = {1, 2, 3};
  request.state.lights.emplace_back(scene::PointLight{});
  request.state.environment.ambient = {1, 1, 1};
  request.state.settings.max_steps = 10;
  request.sample = scene_sample(7);
  EXPECT_FALSE(expect_answer(worker.trace(request)).compiled);
  for (const SceneView view : {SceneView::Normals, SceneView::Depth, SceneView::Steps}) {
    request.look.view = view;
    EXPECT_FALSE(expect_answer(worker.trace(request)).compiled);
  }
  request.look.shadows = Shadows::Soft;
  EXPECT_TRUE(expect_answer(worker.trace(request)).compiled);
  request.look.shadows = Shadows::Hard;
  EXPECT_FALSE(expect_answer(worker.trace(request)).compiled) << "the first program is kept";
}

TEST(SceneWorker, ADynamicObjectMovesWithAUniform) {
  scene::Scene scene;
  scene::Node ball;
  ball.kind = scene::ObjectKind::Sphere;
  ball.data[0] = 0.5;
  ball.dynamic = scene::Dynamic{"ball", {}};
  scene.nodes = {ball};
  scene.roots = {scene::NodeId{0}};
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(make_scene_shader(scene).source);
  job.look.view = SceneView::Depth;
  SceneRequest request = request_of(job);
  request.state.frames = scene_frames(scene);
  const auto is_seen = [&](const SceneAnswer& answer, std::size_t column) {
    return answer.values[(std::size_t{32} * 64 + column) * 3] > 0;
  };
  const SceneAnswer before = expect_answer(worker.trace(request));
  EXPECT_TRUE(is_seen(before, 32));
  EXPECT_FALSE(is_seen(before, 50));
  scene.nodes[0].transform.position = {1, 0, 0};
  request.state.frames = scene_frames(scene);
  const SceneAnswer after = expect_answer(worker.trace(request));
  EXPECT_FALSE(after.compiled);
  EXPECT_FALSE(is_seen(after, 32));
  EXPECT_TRUE(is_seen(after, 50));
}

/// A ball whose function has the slope 1.5.
scene::Scene steep_ball(double told_lipschitz) {
  scene::Scene scene;
  scene::UserPrimitive steep;
  steep.name = "steep";
  steep.code = "float steep(vec3 p, Primitive3D primitive) { return 1.5 * (length(p) - primitive.data[0]); }";
  steep.place = {"steep.primitive.json", "code", 1};
  steep.lipschitz = told_lipschitz;
  scene.user_primitives = {steep};
  scene::Node ball;
  ball.kind = scene::ObjectKind::UserPrimitive;
  ball.user_primitive = scene::UserPrimitiveId{0};
  ball.data[0] = 1;
  scene.nodes = {ball};
  scene.roots = {scene::NodeId{0}};
  return scene;
}

TEST(SceneWorker, APrimitiveThatLiesAboutItsLipschitzBoundIsLoud) {
  RenderWorker worker(test::worker_options());
  const auto middle = [&](double told) {
    SceneJob job = scene_job(make_scene_shader(steep_ball(told)).source, 32);
    job.look.view = SceneView::Lipschitz;
    const Picture picture = test::expect_scene_picture(worker, job);
    const uint8_t* pixel = picture.image.at(16, 16);
    return std::array<int, 3>{pixel[0], pixel[1], pixel[2]};
  };
  const auto honest = middle(1.5);
  EXPECT_EQ(honest[0], honest[2]);
  EXPECT_LE(honest[0], 64);
  const auto lying = middle(1);
  EXPECT_EQ(lying[0], 255);
  EXPECT_EQ(lying[2], 0);
}

TEST(SceneWorker, TilesMakeTheWholePicture) {
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(scene_source(kUnitSphere));
  job.width = 70;
  job.height = 50;
  job.look.view = SceneView::Normals;
  SceneRequest request = request_of(job);
  const std::vector<float> whole = expect_answer(worker.trace(request)).values;
  for (const SceneTile& tile : {SceneTile{70, 50, 0, 0, 35, 20}, SceneTile{70, 50, 33, 17, 37, 33}}) {
    request.tile = tile;
    const std::vector<float> part = expect_answer(worker.trace(request)).values;
    ASSERT_EQ(part.size(), tile.pixel_count() * 3);
    for (std::size_t row = 0; row < tile.height; ++row) {
      for (std::size_t i = 0; i < std::size_t{tile.width} * 3; ++i) {
        const std::size_t at = ((tile.y + row) * 70 + tile.x) * 3 + i;
        ASSERT_EQ(part[row * tile.width * 3 + i], whole[at]) << row << ", " << i;
      }
    }
  }
}

TEST(SceneWorker, DrawsOtherPicturesInBetween) {
  RenderWorker worker(test::worker_options());
  const ShaderModel model{"vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return 0.5 + 0.5 * N; }\n", {}};
  const SceneRequest request = request_of(scene_job(scene_source(kUnitSphere)));
  const GpuPicture sphere = test::expect_picture(worker.draw(model, {.size = 32}));
  const SceneAnswer scene = expect_answer(worker.trace(request));
  EXPECT_EQ(test::expect_picture(worker.draw(model, {.size = 32})).picture.image.pixels, sphere.picture.image.pixels);
  EXPECT_EQ(expect_answer(worker.trace(request)).values, scene.values);
}

TEST(SceneWorker, ProgressIsToldAndCanStopThePicture) {
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(scene_source(kUnitSphere), 300);
  job.samples = 2;
  std::vector<uint64_t> told;
  const auto drawn = draw_scene(worker, job, [&](uint64_t done, uint64_t all) {
    EXPECT_EQ(all, 2U * 300 * 300);
    told.push_back(done);
    return true;
  });
  EXPECT_TRUE(std::holds_alternative<ScenePicture>(drawn));
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_EQ(told.back(), 2U * 300 * 300);
  uint32_t calls = 0;
  const auto stopped = draw_scene(worker, job, [&](uint64_t, uint64_t) { return ++calls < 2; });
  EXPECT_TRUE(std::holds_alternative<ScenePicture>(stopped));
  EXPECT_EQ(calls, 2U);
}

/// llvmpipe cuts all loops off after 65 535 rounds, so each takes long.
TEST(SceneWorker, AHangMeetsTheDeadlineAndTheNextPictureIsDrawn) {
  WorkerOptions options = test::worker_options();
  options.deadline = 6s;  // enough for the next picture on a busy machine
  RenderWorker worker(options);
  SceneJob job = scene_job(
      "float slow(float x) { return sin(sin(sin(sin(sin(sin(sin(sin(x)))))))); }\n"
      "float slower(float x) { return slow(slow(slow(slow(slow(slow(slow(slow(x)))))))); }\n"
      "float endless(vec3 p) {\n"
      "  float x = p.x;\n"
      "  for (int i = 0; i < 65000; ++i) for (int j = 0; j < 65000; ++j) for (int k = 0; k < 65000; ++k)\n"
      "    x = slower(x + float(i ^ j ^ k));\n"
      "  return x;\n"
      "}\n" +
          scene_source("endless(p)"),
      256);
  const auto hanging = draw_scene(worker, job, [](uint64_t, uint64_t) { return true; });
  const auto* fault = std::get_if<RenderFault>(&hanging);
  ASSERT_NE(fault, nullptr);
  EXPECT_EQ(fault->kind, RenderFaultKind::Deadline);
  expect_scene(worker, scene_job(scene_source(kUnitSphere)));
}

TEST(SceneWorker, ASourceThatIsNoneIsToldWithItsNumbers) {
  RenderWorker worker(test::worker_options());
  const SceneJob job = scene_job("#line 41 3\nfloat f = absent;\n" + scene_source(kUnitSphere));
  const RenderFault fault = expect_fault(worker.trace(request_of(job)));
  EXPECT_EQ(fault.kind, RenderFaultKind::Shader);
  EXPECT_NE(fault.message.find(" 3:41: 'absent' : undeclared identifier"), std::string::npos) << fault.message;
}

TEST(SceneWorker, WithoutOpenGlThereIsNoRenderer) {
  RenderWorker worker(test::worker_options({"TEXBRDF_EGL=none"}));
  const RenderFault fault = expect_fault(worker.trace(request_of(scene_job(scene_source(kUnitSphere)))));
  EXPECT_EQ(fault.kind, RenderFaultKind::NoRenderer);
}

TEST(SceneWorker, WhatCannotBeDrawnIsRefusedWithoutAWorker) {
  RenderWorker worker(test::worker_options());
  const SceneRequest good = request_of(scene_job(scene_source(kUnitSphere)));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(SceneRequest&)>> mistakes{
      [](SceneRequest& r) { r.tile.picture_width = 0; },
      [](SceneRequest& r) { r.tile.picture_height = 4097; },
      [](SceneRequest& r) { r.tile.x = 1; },
      [](SceneRequest& r) { r.tile.height = UINT32_MAX; },
      [](SceneRequest& r) { r.tile = {4096, 4096, 0, 0, 4096, 4096}; },
      [](SceneRequest& r) { r.state.camera.target = r.state.camera.position; },
      [](SceneRequest& r) { r.state.camera.position[1] = kNan; },
      [](SceneRequest& r) { r.state.camera.field_of_view = 180; },
      [](SceneRequest& r) { r.state.camera.up = {0, 0, 0}; },
      [](SceneRequest& r) { r.state.lights.resize(17); },
      [](SceneRequest& r) { r.state.lights = {scene::DirectionalLight{{0, 0, 0}, {1, 1, 1}}}; },
      [](SceneRequest& r) { r.state.environment.ambient[0] = kNan; },
      [](SceneRequest& r) { r.state.settings.max_steps = 0; },
      [](SceneRequest& r) { r.state.settings.max_distance = kNan; },
      [](SceneRequest& r) { r.state.settings.surface_threshold = 0; },
      [](SceneRequest& r) { r.state.frames = {1}; },
      [](SceneRequest& r) { r.look.light_size = 0; },
      [](SceneRequest& r) { r.look.occlusion_radius = -1; },
  };
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    SceneRequest request = good;
    mistakes[i](request);
    EXPECT_EQ(expect_fault(worker.trace(request)).kind, RenderFaultKind::Request) << i;
    EXPECT_EQ(worker.process_id(), -1);
  }
}

}  // namespace
}  // namespace texbrdf::render
