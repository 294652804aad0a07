#include "objects/obj_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>

#include "support/read_file.h"

namespace texbrdf::objects {
namespace {

constexpr std::string_view kTriangle = "v 0 0 0\nv 2 0 0\nv 0 2 0\n";
constexpr std::string_view kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Mesh read(const std::string& text) {
  Result<Mesh> mesh = read_obj(text);
  EXPECT_TRUE(mesh) << mesh.error();
  return mesh ? *std::move(mesh) : Mesh{};
}

Mesh read(std::string_view head, std::string_view rest) {
  return read(std::string(head) + std::string(rest));
}

std::vector<glm::vec3> corners_of(const Mesh& mesh) {
  std::vector<glm::vec3> corners;
  for (const Triangle& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) corners.push_back(mesh.vertices[corner].position);
  }
  return corners;
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::vec3 first = mesh.vertices[a].position;
    area += glm::cross(glm::dvec3(mesh.vertices[b].position - first), glm::dvec3(mesh.vertices[c].position - first)).z;
  }
  return area / 2;
}

TEST(ObjFile, ReadsEveryFormOfACorner) {
  const std::vector<glm::vec3> expected{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  for (const char* rest :
       {"f 1 2 3\n", "vt 0 0\nf 1/1 2/1 3/1", "vn 0 0 1\nf 1//1 2//1 3//1", "vt 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 # end",
        "f -3 -2 -1\n", "vn 0 0 1\nf -3//-1 -2//-1 -1//-1\r\n", "f 1 \\\n2 \\\r\n 3",
        "o thing\ng a b\ns off\nf 1 2 3\n",
        "mtllib absent.mtl\nusemtl red\nt deep 9999999999/0/0 1\nl 1 2\np 1\nf 1 2 3"}) {
    EXPECT_EQ(corners_of(read(kTriangle, rest)), expected) << rest;
  }
}

TEST(ObjFile, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(read("f 1 2 3\n" + std::string(kTriangle)).triangles.size(), 1);
  EXPECT_EQ(read("f 1 2 3 4\n" + std::string(kSquare)).triangles.size(), 2);
}

TEST(ObjFile, NegativePlacesCountFromTheLineOn) {
  const Mesh mesh = read(kTriangle, "f -3 -2 -1\nv 0 0 5\nv 2 0 5\nv 0 2 5\nf -3 -2 -1\n");
  EXPECT_EQ(corners_of(mesh)[0].z, 0);
  EXPECT_EQ(corners_of(mesh)[3].z, 5);
}

TEST(ObjFile, NumbersHaveTheirUsualForms) {
  const Mesh mesh = read("v +.5 -1.e0 1E-1\nv 1 0 0 0.25\nv 0 1 0 1 0.5 0.5\nf 1 2 3\n");
  EXPECT_EQ(corners_of(mesh)[0], glm::vec3(0.5F, -1, 0.1F));
  EXPECT_EQ(corners_of(mesh)[1], glm::vec3(1, 0, 0));
}

TEST(ObjFile, CutsFacesWithoutChangingTheirArea) {
  EXPECT_NEAR(area_of(read(kSquare, "f 1 2 3 4\n")), 1, 1e-6);
  // An arrow: its corner 3 is inside of the triangle of the others.
  EXPECT_NEAR(area_of(read("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n")), 4, 1e-6);
  // A comb, from each of its corners on.
  const std::string comb = "v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 0 1 0\n";
  for (int first = 0; first < 10; ++first) {
    std::string face = "f";
    for (int i = 0; i < 10; ++i) face += " " + std::to_string((first + i) % 10 + 1);
    EXPECT_NEAR(area_of(read(comb, face)), 9, 1e-6) << face;
  }
}

TEST(ObjFile, CutsAFaceWithAHoleThatAnEdgeLeadsTo) {
  const std::string corners = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n";
  EXPECT_NEAR(area_of(read(corners, "f 1 2 3 4 1 5 6 7 8 5\n")), 8, 1e-6);
}

TEST(ObjFile, KeepsNormalsOfTheFileAndMakesThemUnit) {
  const Mesh mesh = read(kTriangle, "vn 0 3 4\nf 1//1 2//1 3//1\n");
  for (const Vertex& vertex : mesh.vertices)
    EXPECT_NEAR(glm::length(vertex.normal - glm::vec3(0, 0.6F, 0.8F)), 0, 1e-6);
}

TEST(ObjFile, FormsMissingNormalsFromTheFacesAroundWeightedByAngle) {
  // A corner of a cube whose three faces have one, two and one triangles there.
  const Mesh mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 0\nv 1 0 1\nf 1 3 5 2\nf 1 2 6 4\nf 1 4 3\n");
  const glm::vec3 expected = glm::normalize(glm::vec3(-1, -1, -1));
  for (const Vertex& vertex : mesh.vertices) {
    if (vertex.position == glm::vec3(0)) {
      EXPECT_NEAR(glm::length(vertex.normal - expected), 0, 1e-6);
    }
  }
}

TEST(ObjFile, ANormalOfNothingIsFormedToo) {
  const Mesh mesh = read(kTriangle, "vn 0 0 0\nf 1//1 2//1 3//1\n");
  for (const Vertex& vertex : mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
}

TEST(ObjFile, TrianglesWithoutAreaHaveSomeNormal) {
  const Mesh mesh = read(kTriangle, "v 1 1 1\nf 4 4 4\nf 1 2 2\n");
  for (const Vertex& vertex : mesh.vertices) EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-6);
}

TEST(ObjFile, TangentsGoWithGrowingU) {
  // u grows along +y; once as it is, once with mirrored coordinates, where u still does.
  for (const char* places : {"vt 0 0\nvt 0 1\nvt 1 0\n", "vt 0 1\nvt 0 0\nvt 1 1\n"}) {
    const Mesh mesh = read(kTriangle, std::string(places) + "f 1/1 2/2 3/3\n");
    for (const Vertex& vertex : mesh.vertices) EXPECT_NEAR(glm::length(vertex.tangent - glm::vec3(0, 1, 0)), 0, 1e-6);
  }
}

TEST(ObjFile, TangentsAreAtRightAnglesToNormals) {
  const Mesh mesh = read(kTriangle, "vt 0 0\nvt 1 0\nvt 0 1\nvn 1 2 3\nf 1/1/1 2/2/1 3/3/1\n");
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::dot(vertex.tangent, vertex.normal), 0, 1e-6);
    EXPECT_NEAR(glm::length(vertex.tangent), 1, 1e-6);
  }
}

TEST(ObjFile, WithoutTextureCoordinatesOrTheirAreaThereIsNoTangent) {
  for (const char* rest : {"f 1 2 3\n", "vt 0.5 0.5\nf 1/1 2/1 3/1\n"}) {
    for (const Vertex& vertex : read(kTriangle, rest).vertices) EXPECT_EQ(vertex.tangent, glm::vec3(0)) << rest;
  }
}

/// Each file of tests/data/objects/broken tells in its first line what is said of it.
TEST(ObjFile, TellsWhatIsWrongAndInWhichLine) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TEXBRDF_TEST_DATA "/objects/broken")) {
    const std::string text = test::read_file(entry.path());
    constexpr std::string_view kMark = "# expect: ";
    ASSERT_TRUE(text.starts_with(kMark)) << entry.path();
    const std::string expected = text.substr(kMark.size(), text.find('\n') - kMark.size());
    const Result<Mesh> mesh = read_obj(text);
    ASSERT_FALSE(mesh) << entry.path();
    EXPECT_TRUE(mesh.error().find(expected) != std::string::npos) << entry.path() << ": " << mesh.error();
    ++files;
  }
  EXPECT_GE(files, 25);
}

}  // namespace
}  // namespace texbrdf::objects
