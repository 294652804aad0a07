#include "preview/preview_service.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "analysis/document.h"
#include "preview/cpu_frame.h"
#include "support/read_png.h"

namespace texbrdf::preview {
namespace {

/// Long enough for a loaded machine with sanitizers; reached only where something is wrong.
constexpr std::chrono::seconds kDeadline{60};

std::string equation(const std::string& text) {
  return "\\begin{equation}\n" + text + "\n\\end{equation}\n";
}

/// What a client would have got.
class Client {
 public:
  void show(const std::string& equations, int64_t version, std::map<std::string, std::vector<double>> values = {}) {
    Document document(equations);
    service_.show(1, {document.snapshot(), ++model_, version, "", kView, std::move(values)});
  }
  /// What is shown already, in another light.
  void turn_light(const std::string& equations, int64_t version) {
    Document document(equations);
    service_.show(1, {document.snapshot(), model_, version, "", {.size = 33, .theta = 10}, {}});
  }
  /// What is shown already, made of something else.
  void show_object(const std::string& equations, const ObjectLook& object) {
    Document document(equations);
    service_.show(1, {document.snapshot(), model_, 1, "", kView, {}, object});
  }
  /// Another preview, of a larger picture.
  void show_beside(const std::string& equations) {
    Document document(equations);
    service_.show(2, {document.snapshot(), ++model_, 1, "", {.size = 512}, {}});
  }
  void acknowledge() { service_.acknowledge(1); }
  bool has_state() {
    collect();
    return !states_.empty();
  }

  /// The next frame; nothing where none comes in time.
  std::optional<Frame> next_frame() {
    return wait_for([this] { return take(frames_); });
  }
  std::optional<SceneState> next_state() {
    return wait_for([this] { return take(states_); });
  }
  std::optional<Frame> frame_that_is_there() {
    collect();
    return take(frames_);
  }

  static constexpr render::SphereView kView{.size = 33};

 private:
  template <typename Item>
  static std::optional<Item> take(std::vector<Item>& items) {
    if (items.empty()) return std::nullopt;
    std::optional<Item> first = std::move(items.front());
    items.erase(items.begin());
    return first;
  }

  void collect() {
    for (Event& event : service_.take_events()) {
      if (auto* frame = std::get_if<Frame>(&event)) frames_.push_back(std::move(*frame));
      if (auto* state = std::get_if<SceneState>(&event)) states_.push_back(std::move(*state));
    }
  }

  template <typename Next>
  auto wait_for(const Next& next) -> decltype(next()) {
    const auto deadline = std::chrono::steady_clock::now() + kDeadline;
    for (;;) {
      {
        const std::lock_guard lock(mutex_);
        is_awake_ = false;
      }
      collect();
      if (auto item = next()) return item;
      std::unique_lock lock(mutex_);
      if (!wakes_.wait_until(lock, deadline, [this] { return is_awake_; })) return std::nullopt;
    }
  }

  void wake() {
    {
      const std::lock_guard lock(mutex_);
      is_awake_ = true;
    }
    wakes_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable wakes_;
  bool is_awake_ = false;
  uint64_t model_ = 0;
  std::vector<Frame> frames_;
  std::vector<SceneState> states_;
  PreviewService service_{[this] { wake(); },
                          render::WorkerOptions{.executable = "/nowhere/texbrdf", .environment = {}}};
};

std::vector<uint8_t> pixels(const Frame& frame) {
  const auto image = test::PngReader(frame.png).read();
  EXPECT_TRUE(image);
  return image ? image->pixels : std::vector<uint8_t>();
}

std::vector<uint8_t> expected_pixels(const std::string& equations) {
  Document document(equations);
  const auto model = cpu_model(*document.snapshot().program("f"));
  render::SphereCache cache;
  return draw_on_cpu(*model, Client::kView, cache).image.pixels;
}

TEST(PreviewService, DrawsTheScene) {
  Client client;
  client.show(equation("f = 0.3"), 7);
  const auto state = client.next_state();
  ASSERT_TRUE(state);
  EXPECT_EQ(state->version, 7);
  EXPECT_EQ(state->problem, "");
  const auto frame = client.next_frame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->version, 7);
  EXPECT_EQ(frame->device, Device::Cpu);
  EXPECT_EQ(frame->size, 33u);
  EXPECT_TRUE(frame->is_current);
  EXPECT_EQ(pixels(*frame), expected_pixels(equation("f = 0.3")));
}

TEST(PreviewService, SendsNoFrameBeforeTheLastOneWasShown) {
  Client client;
  client.show(equation("f = 0.5"), 1);
  ASSERT_TRUE(client.next_state());
  ASSERT_TRUE(client.next_frame());
  constexpr int64_t kLast = 20;
  for (int64_t version = 2; version <= kLast; ++version) {
    client.show(equation("f = 0." + std::to_string(version)), version);
  }
  for (int64_t version = 1; version < kLast;) {
    const auto state = client.next_state();
    ASSERT_TRUE(state);
    EXPECT_GT(state->version, version);
    version = state->version;
    EXPECT_FALSE(client.frame_that_is_there());
  }
  for (int64_t version = 1; version < kLast;) {
    client.acknowledge();
    const auto frame = client.next_frame();
    ASSERT_TRUE(frame);
    EXPECT_GE(frame->version, version);
    version = frame->version;
    if (version == kLast) {
      EXPECT_EQ(pixels(*frame), expected_pixels(equation("f = 0.20")));
    }
  }
}

TEST(PreviewService, AGpuThatFailsFirstTakesNoPictureAway) {
  for (int i = 0; i < 100; ++i) {
    Client client;
    client.show(equation("f = 0.5"), 1);
    ASSERT_TRUE(client.next_frame());
  }
}

/// Functions that call the one before twice: the last is 2^14 times as long as the first when it is written out.
std::string slow_equations() {
  std::string text = equation("g_{0}(x) = x * \\cos{\\theta_h}");
  for (int i = 1; i <= 14; ++i) {
    const std::string before = "g_{" + std::to_string(i - 1) + "}";
    text += equation("g_{" + std::to_string(i) + "}(x) = " + before + "(x + 0.1) + " + before + "(x * 0.9)");
  }
  return text + equation("f = g_{14}(\\cos{\\theta_i})");
}

TEST(PreviewService, ASlowPictureIsGivenUpWhereAnotherIsWaitedFor) {
  Client client;
  client.show_beside(slow_equations());
  const auto slow = client.next_state();
  ASSERT_TRUE(slow);
  ASSERT_EQ(slow->problem, "");
  client.show(equation("f = 0.3"), 1);
  const auto frame = client.next_frame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->preview, 1);
}

TEST(PreviewService, WhatCannotBeDrawnLeavesTheLastPicture) {
  Client client;
  client.show(equation("f = 0.5"), 1);
  ASSERT_TRUE(client.next_state());
  ASSERT_TRUE(client.next_frame());
  client.acknowledge();
  client.show(equation("f = 0.5 + z"), 2);
  const auto state = client.next_state();
  ASSERT_TRUE(state);
  EXPECT_EQ(state->version, 2);
  EXPECT_NE(state->problem, "");
  std::optional<Frame> frame = client.next_frame();
  while (frame && frame->version == 1) {
    client.acknowledge();
    frame = client.next_frame();
  }
  ASSERT_TRUE(frame);
  EXPECT_FALSE(frame->is_current);
  EXPECT_EQ(pixels(*frame), expected_pixels(equation("f = 0.5")));
}

TEST(PreviewService, AnotherLightDoesNotLinkAgainWhatCannotBeDrawn) {
  Client client;
  client.show(equation("f = 0.5"), 1);
  ASSERT_TRUE(client.next_state());
  ASSERT_TRUE(client.next_frame());
  client.show(equation("f = 0.5 + z"), 2);
  ASSERT_NE(client.next_state()->problem, "");
  client.turn_light(equation("f = 0.5 + z"), 3);
  for (int64_t version = 1; version < 3;) {
    client.acknowledge();
    const auto frame = client.next_frame();
    ASSERT_TRUE(frame);
    version = frame->version;
    EXPECT_EQ(frame->is_current, version == 1);
  }
  EXPECT_FALSE(client.has_state()) << "each linking is told";
}

TEST(PreviewService, WhatIsMendedIsDrawnAgain) {
  Client client;
  client.show(equation("f = 0.5 + z"), 1);
  ASSERT_NE(client.next_state()->problem, "");
  client.turn_light(equation("f = 0.5 + z"), 2);
  client.show(equation("f = 0.25"), 3);
  const auto state = client.next_state();
  ASSERT_TRUE(state);
  EXPECT_EQ(state->problem, "");
  const auto frame = client.next_frame();
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->is_current);
  EXPECT_EQ(pixels(*frame), expected_pixels(equation("f = 0.25")));
}

TEST(PreviewService, ValuesTakeThePlaceOfThoseInTheDocument) {
  Client client;
  client.show(equation("c = 0.1") + equation("f = c + 0*1"), 1, {{"c", {0.4}}, {"gone", {1}}});
  const auto frame = client.next_frame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(pixels(*frame), expected_pixels(equation("c = 0.4") + equation("f = c + 0*1")));
}

TEST(PreviewService, EndsWhileItDraws) {
  for (int i = 0; i < 20; ++i) {
    Client client;
    client.show(equation("f = 0.5"), 1);
    client.show(equation("f = 0.6"), 2);
  }
}

ObjectLook furnace(uint32_t samples) {
  ObjectLook look;
  look.shape = "teapot";
  look.light.light = "furnace";
  look.samples = samples;
  return look;
}

TEST(PreviewService, PicturesOfObjectsBecomeBetterUntilAllSamplesAreDrawn) {
  Client client;
  client.show(equation("f = 0.3*1"), 1);
  ASSERT_TRUE(client.next_frame());
  client.acknowledge();
  client.show_object(equation("f = 0.3*1"), furnace(40));
  uint32_t last = 0;
  while (last < 40) {
    const auto frame = client.next_frame();
    ASSERT_TRUE(frame);
    client.acknowledge();
    if (frame->all_samples == 0) continue;  // of the sphere
    EXPECT_GT(frame->samples, last);
    EXPECT_EQ(frame->all_samples, 40);
    last = frame->samples;
  }
  EXPECT_EQ(last, 40);
}

TEST(PreviewService, ASceneThatChangesBeginsAnew) {
  Client client;
  client.show(equation("f = 0.3*1"), 1);
  client.show_object(equation("f = 0.3*1"), furnace(65'000));
  std::optional<Frame> frame = client.next_frame();
  while (frame && frame->samples < 2) {
    client.acknowledge();
    frame = client.next_frame();
  }
  ASSERT_TRUE(frame);
  client.acknowledge();
  client.show_object(equation("f = 0.3*1"), furnace(2));
  while (frame && frame->all_samples != 2) {
    frame = client.next_frame();
    client.acknowledge();
  }
  ASSERT_TRUE(frame);
  EXPECT_LE(frame->samples, 2);
}

TEST(PreviewService, AnObjectInTheDirectionalLightIsDrawnOnce) {
  Client client;
  client.show(equation("f = 0.3*1"), 1);
  ObjectLook look;
  look.shape = "teapot";
  client.show_object(equation("f = 0.3*1"), look);
  std::optional<Frame> frame = client.next_frame();
  client.acknowledge();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->all_samples, 0);
}

TEST(PreviewService, AFileThatCannotBeReadIsToldUntilAnotherIsNamed) {
  Client client;
  client.show(equation("f = 0.3*1"), 1);
  ASSERT_TRUE(client.next_state());
  ObjectLook look;
  look.shape = "/nowhere/cup.obj";
  client.show_object(equation("f = 0.3*1"), look);
  std::optional<SceneState> state = client.next_state();
  ASSERT_TRUE(state);
  EXPECT_EQ(state->problem, "cannot read /nowhere/cup.obj");
  client.show_object(equation("f = 0.3*1"), furnace(1));
  state = client.next_state();
  ASSERT_TRUE(state);
  EXPECT_EQ(state->problem, "");
}

}  // namespace
}  // namespace texbrdf::preview
