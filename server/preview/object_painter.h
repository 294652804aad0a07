#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <variant>

#include "files/file_source.h"
#include "preview/object_look.h"
#include "preview/object_picture.h"

namespace texbrdf::preview {

/// Draws objects for previews, each time a little better, on one device. Keeps the pictures that were drawn last, and
/// the files that they were drawn of.
class ObjectPainter {
 public:
  /// What is drawn: another serial is another picture.
  struct Job {
    int64_t preview = 0;
    uint64_t serial = 0;
    const ObjectLook& look;
    render::SphereView view;
  };
  struct Drawn {
    render::Picture picture;
    uint32_t samples = 0;
    uint32_t all_samples = 0;  ///< 0 where none are taken: the picture is what it will be
  };
  /// Nobody wants it any more.
  struct GivenUp {};
  using Outcome = std::variant<Drawn, GivenUp, render::RenderFault, Failure>;

  /// Adds samples, about as many as there are, to the picture of the job. A Failure is about its files.
  Outcome draw(const Job& job, const TableEvaluator& evaluate, const std::function<bool()>& is_wanted);

 private:
  struct Kept {
    int64_t preview;
    uint64_t serial;
    uint32_t size;
    ObjectPicture picture;
  };
  struct MeshOfFile {
    std::string shape;
    files::FileStamp stamp;
    std::shared_ptr<const objects::Mesh> mesh;
  };
  struct LightOfFile {
    LightChoice choice;
    files::FileStamp stamp;
    std::shared_ptr<const lighting::Environment> environment;
  };

  Result<ObjectPicture*> picture_of(const Job& job);
  Result<std::shared_ptr<const objects::Mesh>> mesh_of(const std::string& shape);
  Result<std::shared_ptr<const lighting::Environment>> environment_of(const LightChoice& choice);

  std::list<Kept> kept_;  // the last used first
  std::optional<MeshOfFile> mesh_;
  std::optional<LightOfFile> light_;
};

}  // namespace texbrdf::preview
