#include "preview/object_painter.h"

#include <algorithm>
#include <utility>

namespace texbrdf::preview {

namespace {

constexpr std::size_t kMostKept = 4;
/// In one go, so that another preview need not wait long.
constexpr uint32_t kMostAtOnce = 16;

Result<std::string> read(const std::string& path) {
  std::optional<std::string> bytes = files::read_file(path);
  if (!bytes) return Failure{"cannot read " + path};
  return *std::move(bytes);
}

}  // namespace

ObjectPainter::Outcome ObjectPainter::draw(const Job& job, const TableEvaluator& evaluate,
                                           const std::function<bool()>& is_wanted) {
  const Result<ObjectPicture*> found = picture_of(job);
  if (!found) return Failure{found.error()};
  ObjectPicture& picture = **found;
  const uint32_t all = picture.is_exact() ? 1 : job.look.samples;
  if (picture.samples() < all) {
    const uint32_t count = std::min(std::clamp(picture.samples(), 1U, kMostAtOnce), all - picture.samples());
    bool is_given_up = false;
    const auto still_wanted = [&] {
      is_given_up = is_given_up || !is_wanted();
      return !is_given_up;
    };
    const auto fault = picture.add(count, evaluate, still_wanted);
    if (fault || is_given_up) kept_.pop_front();  // a part of the samples is missing
    if (fault) return *fault;
    if (is_given_up) return GivenUp{};
  }
  const bool is_exact = picture.is_exact();
  return Drawn{picture.picture(), is_exact ? 0 : picture.samples(), is_exact ? 0 : all};
}

Result<ObjectPicture*> ObjectPainter::picture_of(const Job& job) {
  const auto found = std::ranges::find_if(kept_, [&](const Kept& kept) {
    return kept.preview == job.preview && kept.serial == job.serial && kept.size == job.view.size;
  });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return &kept_.front().picture;
  }
  for (const std::string& problem : {job.look.shape_problem, job.look.light_problem}) {
    if (!problem.empty()) return Failure{problem};
  }
  const auto mesh = mesh_of(job.look.shape);
  if (!mesh) return Failure{mesh.error()};
  const auto environment = environment_of(job.look.light);
  if (!environment) return Failure{environment.error()};
  std::erase_if(kept_, [&](const Kept& kept) { return kept.preview == job.preview; });
  if (kept_.size() == kMostKept) kept_.pop_back();
  ObjectScene scene;
  scene.view = job.view;
  scene.object = {*mesh, job.look.orbit};
  scene.environment = *environment;
  kept_.push_front({job.preview, job.serial, job.view.size, ObjectPicture(std::move(scene))});
  return &kept_.front().picture;
}

Result<std::shared_ptr<const objects::Mesh>> ObjectPainter::mesh_of(const std::string& shape) {
  const files::FileStamp stamp = files::stamp_of(shape);
  if (mesh_ && mesh_->shape == shape && mesh_->stamp == stamp) return mesh_->mesh;
  auto mesh = find_mesh(shape, read);
  if (mesh) mesh_ = MeshOfFile{shape, stamp, *mesh};
  return mesh;
}

Result<std::shared_ptr<const lighting::Environment>> ObjectPainter::environment_of(const LightChoice& choice) {
  const files::FileStamp stamp = files::stamp_of(choice.light);
  if (light_ && light_->choice == choice && light_->stamp == stamp) return light_->environment;
  auto environment = find_environment(choice, read);
  if (environment) light_ = LightOfFile{choice, stamp, *environment};
  return environment;
}

}  // namespace texbrdf::preview
