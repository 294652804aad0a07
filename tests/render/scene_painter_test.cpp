#include "preview/scene_painter.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "render/png.h"
#include "scene_support.h"

namespace texbrdf::test {
namespace {

using preview::SceneEvent;
using preview::SceneFrame;
using preview::ScenePainter;
using preview::SceneShot;
using preview::SceneTrouble;

/// Of a machine that does much else.
constexpr std::chrono::seconds kPatience{120};

SceneShot shot_of(std::string source, uint32_t size = 32) {
  const render::SceneJob job = scene_job(std::move(source), size);
  return {.shader = std::make_shared<const scene::SceneShader>(scene::SceneShader{job.source, {}, {}}),
          .state = job.state,
          .look = job.look,
          .display = {},
          .width = size,
          .height = size};
}

class ScenePainterTest : public testing::Test {
 protected:
  ScenePainterTest()
      : painter_(
            [this] {
              const std::lock_guard lock(mutex_);
              is_awake_ = true;
              awake_.notify_all();
            },
            worker_options()) {}

  SceneEvent next_event() {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (waiting_.empty()) {
      waiting_ = painter_.take_events();
      std::unique_lock lock(mutex_);
      if (waiting_.empty() && !awake_.wait_until(lock, end, [this] { return is_awake_; })) {
        ADD_FAILURE() << "nothing is drawn";
        return SceneTrouble{};
      }
      is_awake_ = false;
    }
    SceneEvent event = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
    return event;
  }

  SceneFrame next_frame() {
    SceneEvent event = next_event();
    if (const auto* trouble = std::get_if<SceneTrouble>(&event)) {
      ADD_FAILURE() << trouble->fault.message;
      return {};
    }
    const SceneFrame frame = std::get<SceneFrame>(std::move(event));
    painter_.acknowledge(frame.preview);
    return frame;
  }

  ScenePainter& painter() { return painter_; }

 private:
  std::mutex mutex_;
  std::condition_variable awake_;
  bool is_awake_ = false;
  std::vector<SceneEvent> waiting_;
  ScenePainter painter_;
};

TEST_F(ScenePainterTest, AtRestAPictureGetsAllItsSamples) {
  painter().show(7, shot_of(scene_source(kUnitSphere)));
  SceneFrame frame = next_frame();
  uint32_t samples = 0;
  while (frame.samples < preview::kMostPreviewSamples && !HasFailure()) {
    EXPECT_EQ(frame.preview, 7);
    EXPECT_GT(frame.samples, samples);
    EXPECT_EQ(frame.samples & (frame.samples - 1), 0U) << frame.samples;
    samples = frame.samples;
    frame = next_frame();
  }
  EXPECT_EQ(frame.samples, preview::kMostPreviewSamples);
  EXPECT_EQ(frame.width, 32U);
  EXPECT_TRUE(painter().take_events().empty());
}

TEST_F(ScenePainterTest, TheLastPictureIsWhatTheCommandLineDraws) {
  const SceneShot shot = shot_of(scene_source(kUnitSphere));
  painter().show(1, shot);
  SceneFrame frame = next_frame();
  while (frame.samples < preview::kMostPreviewSamples && !HasFailure()) frame = next_frame();
  render::RenderWorker worker(worker_options());
  render::SceneJob job = scene_job(shot.shader->source, 32);
  job.samples = preview::kMostPreviewSamples;
  EXPECT_EQ(frame.png, render::encode_png(expect_scene_picture(worker, job).image, render::PngEffort::Fast));
}

TEST_F(ScenePainterTest, NothingIsSentBeforeTheClientHasShownTheLast) {
  painter().show(1, shot_of(scene_source(kUnitSphere)));
  const SceneEvent first = next_event();
  ASSERT_TRUE(std::holds_alternative<SceneFrame>(first));
  painter().show(2, shot_of(scene_source("length(p) - 0.5")));
  while (next_frame().samples < preview::kMostPreviewSamples && !HasFailure()) {
  }
  painter().acknowledge(1);
  EXPECT_EQ(next_frame().preview, 1);
}

TEST_F(ScenePainterTest, ANewShotTakesThePlaceOfTheOld) {
  painter().show(1, shot_of(scene_source(kUnitSphere)));
  next_frame();
  SceneShot other = shot_of(scene_source(kUnitSphere));
  other.look.view = render::SceneView::Normals;
  other.version = 5;
  painter().show(1, other);
  SceneFrame frame = next_frame();
  while (frame.version != 5 && !HasFailure()) frame = next_frame();
  EXPECT_EQ(frame.view, render::SceneView::Normals);
}

TEST_F(ScenePainterTest, AShaderThatIsNoneIsToldOfWithWhatItWas) {
  const SceneShot shot = shot_of(scene_source("length(p) - wrong"));
  painter().show(1, shot);
  const SceneEvent event = next_event();
  ASSERT_TRUE(std::holds_alternative<SceneTrouble>(event));
  const auto& trouble = std::get<SceneTrouble>(event);
  EXPECT_EQ(trouble.shader, shot.shader);
  EXPECT_EQ(trouble.fault.kind, render::RenderFaultKind::Shader);
  EXPECT_NE(trouble.fault.message.find("wrong"), std::string::npos) << trouble.fault.message;
  painter().show(1, shot_of(scene_source(kUnitSphere)));
  EXPECT_EQ(next_frame().preview, 1);
}

TEST_F(ScenePainterTest, WhatIsClosedIsNotDrawn) {
  painter().show(1, shot_of(scene_source(kUnitSphere)));
  painter().close(1);
  painter().show(2, shot_of(scene_source(kUnitSphere)));
  EXPECT_EQ(next_frame().preview, 2);
  for (const SceneEvent& event : painter().take_events()) {
    EXPECT_EQ(std::visit([](const auto& told) { return told.preview; }, event), 2);
  }
}

}  // namespace
}  // namespace texbrdf::test
