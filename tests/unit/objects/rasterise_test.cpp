#include "objects/rasterise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "objects/teapot.h"

namespace texbrdf::objects {
namespace {

/// A square from -1 to 1 at the depth z, its front towards the viewer or away.
Mesh square(float z, bool front = true) {
  Mesh mesh;
  const glm::vec3 normal(0, 0, front ? 1 : -1);
  for (const auto& [x, y] : {std::pair(-1.F, -1.F), {1.F, -1.F}, {1.F, 1.F}, {-1.F, 1.F}}) {
    mesh.vertices.push_back({{x, y, z}, normal, {1, 0, 0}});
  }
  mesh.triangles = front ? std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}} : std::vector<Triangle>{{0, 2, 1}, {0, 3, 2}};
  return mesh;
}

const glm::dmat3 kNotTurned = rotation_of({});

TEST(Rasterise, CoversWhatIsInsideAndNothingElse) {
  // A square of 8 pixels in the middle of 16.
  const Coverage coverage = rasterise(square(0), kNotTurned, 16, 4);
  for (uint32_t row = 0; row < 16; ++row) {
    for (uint32_t column = 0; column < 16; ++column) {
      const bool inside = row >= 4 && row < 12 && column >= 4 && column < 12;
      EXPECT_EQ(coverage.alpha[row * 16 + column], inside ? 255 : 0) << row << ' ' << column;
    }
  }
  EXPECT_EQ(coverage.fragments.size(), 64 * kRays);
  EXPECT_EQ(coverage.begins.size(), 16 * 16 + 1);
}

TEST(Rasterise, EdgesHaveTheCoveredPartOfTheirRays) {
  const Coverage coverage = rasterise(square(0), kNotTurned, 16, 4.5);  // from 3.5 to 12.5
  EXPECT_EQ(coverage.alpha[8 * 16 + 3], 128);
  EXPECT_EQ(coverage.alpha[3 * 16 + 8], 128);
  EXPECT_EQ(coverage.alpha[3 * 16 + 3], 64);
}

TEST(Rasterise, WhatIsNearerHidesTheRest) {
  for (const bool swapped : {false, true}) {
    Mesh both = square(swapped ? 1 : 0);
    const Mesh other = square(swapped ? 0 : 1);
    both.vertices.insert(both.vertices.end(), other.vertices.begin(), other.vertices.end());
    both.triangles.push_back({4, 5, 6});
    both.triangles.push_back({4, 6, 7});
    for (const Fragment& fragment : rasterise(both, kNotTurned, 16, 4).fragments) {
      EXPECT_EQ(fragment.triangle >= 2, !swapped);
    }
  }
}

/// A picture that is drawn in several bands.
TEST(Rasterise, BandsJoin) {
  const Coverage coverage = rasterise(square(0), kNotTurned, 700, 300);
  EXPECT_EQ(coverage.fragments.size(), 600 * 600 * kRays);
}

TEST(Rasterise, MeshesThatAreFarTooLargeFillThePicture) {
  const Coverage coverage = rasterise(square(0), kNotTurned, 8, 1e9);
  for (const uint8_t alpha : coverage.alpha) EXPECT_EQ(alpha, 255);
}

TEST(Orbit, YawTurnsCounterClockwiseSeenFromAboveAndPitchTipsTheTopForward) {
  EXPECT_NEAR(glm::length(rotation_of({90, 0}) * glm::dvec3(0, 0, 1) - glm::dvec3(1, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::length(rotation_of({0, 90}) * glm::dvec3(0, 1, 0) - glm::dvec3(0, 0, 1)), 0, 1e-12);
  EXPECT_NEAR(glm::length(rotation_of({90, 90}) * glm::dvec3(0, 0, 1) - glm::dvec3(1, 0, 0)), 0, 1e-12);
}

TEST(Frames, AreRightHandedOrthonormalAndTowardsTheViewer) {
  Mesh mesh = make_teapot(8);
  fit_into_unit_sphere(mesh);
  for (const Orbit& orbit : {Orbit{}, Orbit{-30, 20}, Orbit{100, -70}, Orbit{180, 90}}) {
    const glm::dmat3 rotation = rotation_of(orbit);
    for (const Fragment& fragment : rasterise(mesh, rotation, 64, 30).fragments) {
      const SurfaceFrame frame = frame_at(mesh, rotation, fragment);
      EXPECT_GE(frame.normal.z, kLeastCosine - 1e-9);
      EXPECT_NEAR(glm::length(frame.normal), 1, 1e-6);
      EXPECT_NEAR(glm::length(frame.tangent), 1, 1e-6);
      EXPECT_NEAR(glm::dot(frame.normal, frame.tangent), 0, 1e-6);
      EXPECT_NEAR(glm::length(frame.bitangent - glm::cross(frame.normal, frame.tangent)), 0, 1e-6);
    }
  }
}

TEST(Frames, ABackSideHasTheOppositeNormal) {
  const Mesh back = square(0, false);
  const Coverage coverage = rasterise(back, kNotTurned, 8, 2);
  ASSERT_FALSE(coverage.fragments.empty());
  EXPECT_NEAR(frame_at(back, kNotTurned, coverage.fragments[0]).normal.z, 1, 1e-9);
}

TEST(Frames, ADegenerateMeshHasFramesWithoutANumberThatIsNone) {
  Mesh mesh = square(0);
  for (Vertex& vertex : mesh.vertices) vertex.normal = glm::vec3(0);
  for (const Fragment& fragment : rasterise(mesh, kNotTurned, 8, 2).fragments) {
    EXPECT_NEAR(glm::length(frame_at(mesh, kNotTurned, fragment).normal), 1, 1e-9);
  }
}

TEST(Frames, OfAMereNormalAreThoseOfTheSphere) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 0.5, 0.7));
  const SurfaceFrame frame = frame_of_normal(kNotTurned, normal);
  const glm::dvec3 expected = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), normal));
  EXPECT_NEAR(glm::length(frame.tangent - expected), 0, 1e-12);
}

}  // namespace
}  // namespace texbrdf::objects
