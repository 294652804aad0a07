#include "scene/distance.h"

#include <cmath>

#include "support.h"
#include "support/random_scene.h"

// Shaders on the driver against the reference in double.

namespace texbrdf {
namespace {

constexpr int kPlaces = 1000;
/// Of single precision, relative to the size of the numbers: the distance and the place.
constexpr double kTolerance = 2e-4;

bool has_code_of_users(const scene::Scene& scene) {
  return !scene.user_primitives.empty();
}

class Driver {
 public:
  Driver() : worker_(test::worker_options()) {}

  void expect_agreement(const scene::Scene& scene, test::RandomScene& random, const std::string& what) {
    const scene::Distances reference(scene);
    std::vector<eval::Geometry> geometries(kPlaces);
    for (eval::Geometry& geometry : geometries) {
      const glm::dvec3 place = random.place();
      geometry.light = {place.x, place.y, place.z};
    }
    const auto result = worker_.evaluate(test::distance_model(scene), geometries);
    const auto* fault = std::get_if<render::RenderFault>(&result);
    ASSERT_EQ(fault, nullptr) << what << ": " << fault->message;
    const auto& values = std::get<0>(result);
    double worst = 0;
    for (int i = 0; i < kPlaces; ++i) {
      const auto& p = geometries[static_cast<std::size_t>(i)].light;
      const double expected = reference.at({p[0], p[1], p[2]});
      const double size = 3 + std::abs(expected);
      const double error = std::abs(static_cast<double>(values[static_cast<std::size_t>(i)][0]) - expected) / size;
      ASSERT_LE(error, kTolerance) << what << " at " << p[0] << ", " << p[1] << ", " << p[2] << ": "
                                   << values[static_cast<std::size_t>(i)][0] << ", expected " << expected;
      worst = std::max(worst, error);
    }
    worst_ = std::max(worst_, worst);
  }
  double worst() const { return worst_; }

 private:
  render::RenderWorker worker_;
  double worst_ = 0;
};

TEST(SceneDistances, OfTheExamplesAreThoseOfTheReference) {
  Driver driver;
  test::RandomScene random(3);
  for (const std::string& name : test::example_scenes()) {
    const scene::Scene scene = test::load_example(name);
    if (!has_code_of_users(scene)) driver.expect_agreement(scene, random, name);
  }
  RecordProperty("worst", std::to_string(driver.worst()));
}

TEST(SceneDistances, OfRandomTreesAreThoseOfTheReference) {
  Driver driver;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    test::RandomScene random(seed, true);
    const scene::Scene scene = random.make();
    driver.expect_agreement(scene, random, "seed " + std::to_string(seed));
  }
  RecordProperty("worst", std::to_string(driver.worst()));
}

/// `count` objects of all bounded kinds in a cube.
scene::Scene crowd(std::size_t count) {
  scene::Scene scene;
  test::Random random(1);
  std::vector<const scene::ObjectEntry*> kinds;
  for (const scene::ObjectEntry& entry : scene::object_entries()) {
    const bool is_bounded = entry.kind != scene::ObjectKind::Plane && entry.kind != scene::ObjectKind::InfiniteCylinder;
    if (entry.object_class == scene::ObjectClass::Primitive && is_bounded) kinds.push_back(&entry);
  }
  for (uint32_t i = 0; i < count; ++i) {
    const scene::ObjectEntry& entry = *random.one_of(kinds);
    scene::Node node;
    node.kind = entry.kind;
    node.data = with_defaults(entry, {});
    node.transform.position = {random.real(-10, 10), random.real(-10, 10), random.real(-10, 10)};
    node.transform.rotation = {random.real(-3, 3), 0, random.real(-3, 3)};
    scene.nodes.push_back(node);
    scene.roots.push_back({i});
  }
  return scene;
}

/// The driver compiles this in seconds; four times as many take longer than the worker has.
TEST(SceneDistances, OfACrowdAreThoseOfTheReference) {
  Driver driver;
  test::RandomScene random(5);
  driver.expect_agreement(crowd(256), random, "a crowd");
}

}  // namespace
}  // namespace texbrdf
