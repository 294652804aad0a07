#include "preview/object_choice.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "lighting/hdr_file.h"
#include "objects/obj_file.h"
#include "objects/teapot.h"

namespace texbrdf::preview {

namespace {

using MeshPointer = std::shared_ptr<const objects::Mesh>;
using EnvironmentPointer = std::shared_ptr<const lighting::Environment>;

Result<MeshPointer> fitted(objects::Mesh mesh) {
  fit_into_unit_sphere(mesh);
  return MeshPointer(std::make_shared<const objects::Mesh>(std::move(mesh)));
}

Result<MeshPointer> read_mesh(const std::string& path, const FileReader& read) {
  const Result<std::string> bytes = read(path);
  if (!bytes) return Failure{bytes.error()};
  Result<objects::Mesh> mesh = objects::read_obj(*bytes);
  if (!mesh) return Failure{fmt::format("{}: {}", path, mesh.error())};
  return fitted(*std::move(mesh));
}

EnvironmentPointer environment_of(lighting::EnvironmentMap map) {
  return std::make_shared<const lighting::Environment>(std::move(map));
}

Result<EnvironmentPointer> read_environment(const std::string& path, const FileReader& read) {
  const Result<std::string> bytes = read(path);
  if (!bytes) return Failure{bytes.error()};
  Result<lighting::EnvironmentMap> map = lighting::read_hdr(*bytes);
  if (!map) return Failure{fmt::format("{}: {}", path, map.error())};
  return environment_of(*std::move(map));
}

}  // namespace

Result<MeshPointer> find_mesh(const std::string& object, const FileReader& read) {
  if (object == "sphere") return MeshPointer();
  if (object == "teapot") return fitted(objects::make_teapot());
  if (object.ends_with(".obj")) return read_mesh(object, read);
  return Failure{fmt::format("an object is sphere, teapot or a file FILE.obj, not '{}'", object)};
}

Result<EnvironmentPointer> find_environment(const LightChoice& choice, const FileReader& read) {
  if (const auto fault = find_fault(choice.sky)) return Failure{*fault};
  if (choice.light == "directional") return EnvironmentPointer();
  if (choice.light == "furnace") {
    return EnvironmentPointer(std::make_shared<const lighting::Environment>(lighting::Environment::furnace()));
  }
  if (choice.light == "sky") return environment_of(make_sky(choice.sky));
  if (choice.light.ends_with(".hdr")) return read_environment(choice.light, read);
  return Failure{fmt::format("light is directional, sky, furnace or a file FILE.hdr, not '{}'", choice.light)};
}

objects::Orbit standard_orbit(const std::string& object) {
  return object == "teapot" ? objects::Orbit{-30, 20} : objects::Orbit{};
}

}  // namespace texbrdf::preview
