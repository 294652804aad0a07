#include "render/sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace texbrdf::render {
namespace {

using Vector = std::array<double, 3>;

Vector at(const SphereGeometry::Vectors& vectors, std::size_t i) {
  return {vectors[0][i], vectors[1][i], vectors[2][i]};
}
double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class Sizes : public testing::TestWithParam<uint32_t> {
 protected:
  SphereGeometry geometry() const { return make_sphere_geometry({.size = GetParam()}); }
};

TEST_P(Sizes, FramesAreRightHandedAndOrthonormal) {
  const SphereGeometry geometry = this->geometry();
  for (std::size_t i = 0; i < geometry.point_count(); ++i) {
    const Vector n = at(geometry.normals, i);
    const Vector x = at(geometry.tangents, i);
    const Vector y = at(geometry.bitangents, i);
    EXPECT_NEAR(dot(n, n), 1, 1e-6);
    EXPECT_NEAR(dot(x, x), 1, 1e-6);
    EXPECT_NEAR(dot(y, y), 1, 1e-6);
    EXPECT_NEAR(dot(x, n), 0, 1e-6);
    const Vector expected = cross(n, x);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(y[c], expected[c], 1e-6);
    EXPECT_EQ(x[1], 0) << "X is normalize((0,1,0) × N)";
    EXPECT_GT(x[0], 0);
  }
}

TEST_P(Sizes, NoSampleLiesOnTheSilhouetteOrInTheDark) {
  const SphereGeometry geometry = this->geometry();
  for (std::size_t i = 0; i < geometry.point_count(); ++i) {
    EXPECT_GT(geometry.normals[2][i], 0);
    EXPECT_GT(geometry.cosines[i], 0);
  }
}

TEST_P(Sizes, TheDiscHasTheAreaOfNinetyPerCent) {
  const SphereGeometry geometry = this->geometry();
  double area = 0;
  for (const uint8_t alpha : geometry.alpha) area += alpha / 255.0;
  const double radius = 0.45 * GetParam();
  EXPECT_NEAR(area, std::numbers::pi * radius * radius, 0.3 + radius * 0.04);
}

INSTANTIATE_TEST_SUITE_P(Sphere, Sizes, testing::Values(7, 20, 64, 101, 256));

TEST(Sphere, TheSmallestPictureIsOnePixel) {
  const SphereGeometry geometry = make_sphere_geometry({.size = 1});
  EXPECT_EQ(geometry.alpha.size(), 1U);
  EXPECT_EQ(geometry.point_count(), 1U);
}

TEST(Sphere, TheLightIsUpAndToTheLeftByDefault) {
  const SphereGeometry geometry = make_sphere_geometry({});
  EXPECT_LT(geometry.light[0], 0);
  EXPECT_GT(geometry.light[1], 0);
  EXPECT_NEAR(geometry.light[2], std::cos(33.8941 * std::numbers::pi / 180), 1e-6);
}

TEST(Sphere, TheFirstRowIsTheTop) {
  const SphereGeometry geometry = make_sphere_geometry({.size = 64, .theta = 0});
  EXPECT_GT(geometry.normals[1].front(), 0.9);
  EXPECT_LT(geometry.normals[1].back(), -0.9);
}

TEST(Sphere, TheMiddlePixelLooksStraightAtTheViewer) {
  const SphereGeometry geometry = make_sphere_geometry({.size = 65, .theta = 0});
  const auto middle = std::find(geometry.pixels.begin(), geometry.pixels.end(), 32U * 65 + 32);
  ASSERT_NE(middle, geometry.pixels.end());
  const auto i = static_cast<std::size_t>(middle - geometry.pixels.begin());
  EXPECT_EQ(at(geometry.normals, i), (Vector{0, 0, 1}));
  EXPECT_EQ(at(geometry.tangents, i), (Vector{1, 0, 0}));
  EXPECT_EQ(at(geometry.bitangents, i), (Vector{0, 1, 0}));
}

TEST(Sphere, ALightFromBehindLeavesNoPoint) {
  const SphereGeometry geometry = make_sphere_geometry({.size = 32, .theta = 180});
  EXPECT_EQ(geometry.point_count(), 0U);
  EXPECT_EQ(geometry.alpha[16 * 32 + 16], 255);
}

TEST(SurfacePoint, IsThatOfThePicture) {
  for (const SphereView& view : {SphereView{.size = 33}, SphereView{.size = 64, .theta = 80, .phi = 10, .zoom = 0.5},
                                 SphereView{.size = 50, .theta = 10, .zoom = 3}}) {
    const SphereGeometry geometry = make_sphere_geometry(view);
    ASSERT_GT(geometry.point_count(), 0U);
    for (std::size_t i = 0; i < geometry.point_count(); ++i) {
      const auto point = surface_point(view, sample_place(view, geometry.pixels[i]));
      ASSERT_TRUE(point);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(geometry.normals[c][i], point->normal[c], 1e-6);
        EXPECT_NEAR(geometry.tangents[c][i], point->tangent[c], 1e-6);
        EXPECT_NEAR(geometry.bitangents[c][i], point->bitangent[c], 1e-6);
      }
    }
  }
}

TEST(SurfacePoint, IsWhereAPersonSeesIt) {
  const auto right = surface_point({}, {0.5 + 0.45 * 0.6, 0.5});
  ASSERT_TRUE(right);
  EXPECT_NEAR(right->normal[0], 0.6, 1e-15);
  EXPECT_NEAR(right->normal[2], 0.8, 1e-15);
  EXPECT_NEAR(right->tangent[0], 0.8, 1e-15);
  EXPECT_NEAR(right->tangent[2], -0.6, 1e-15);
  EXPECT_NEAR(right->bitangent[1], 1, 1e-15);
  const auto top = surface_point({.zoom = 2}, {0.5, 0.5 - 0.9 * 0.6});
  ASSERT_TRUE(top) << "outside of the picture the sphere goes on";
  EXPECT_NEAR(top->normal[1], 0.6, 1e-15);
}

TEST(SurfacePoint, IsNotBesideTheSphereNorOnItsEdge) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const PicturePlace place : {PicturePlace{0, 0}, PicturePlace{0.96, 0.5}, PicturePlace{0.5, -3},
                                   PicturePlace{NAN, 0.5}, PicturePlace{0.5, kInfinity}, PicturePlace{1e300, 1e300}}) {
    EXPECT_FALSE(surface_point({}, place)) << place.x << " " << place.y;
  }
  EXPECT_FALSE(surface_point({.zoom = 0.5}, {0.5, 0.74}));
  EXPECT_TRUE(surface_point({.zoom = 1}, {0.5, 0.74}));
}

TEST(SphereCache, KeepsTheGeometryUntilSizeOrLightChange) {
  SphereCache cache;
  const std::size_t points = cache.geometry({.size = 32}).point_count();
  const float* kept = cache.geometry({.size = 32}).cosines.data();
  EXPECT_EQ(cache.geometry({.size = 32, .gamma = 1, .exposure = 2}).cosines.data(), kept);
  EXPECT_NE(cache.geometry({.size = 32, .theta = 0}).point_count(), points);
  EXPECT_EQ(cache.geometry({.size = 16}).size, 16U);
  EXPECT_EQ(cache.geometry({.size = 32}).point_count(), points);
}

TEST(SphereView, FaultsAreTold) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(find_fault(SphereView{}));
  for (const SphereView& view : {SphereView{.size = 0}, SphereView{.size = kMaxPictureSize + 1},
                                 SphereView{.theta = kInfinity}, SphereView{.phi = -kInfinity}, SphereView{.gamma = 0},
                                 SphereView{.gamma = NAN}, SphereView{.exposure = 61}, SphereView{.exposure = NAN}}) {
    EXPECT_TRUE(find_fault(view));
  }
}

}  // namespace
}  // namespace texbrdf::render
