// Documents with a BRDF as shaders.
#include <fmt/format.h>

#include "analysis/document.h"
#include "emit/emit.h"
#include "files/follow_includes.h"
#include "scene_json/part_reader.h"
#include "semantics/names.h"

namespace texbrdf::scene_json {
namespace {

scene::Property property_of(const ir::Parameter& parameter, std::string name) {
  const bool is_real = type_components(parameter.type) == 1;
  return {std::move(name), is_real ? scene::PropertyType::Float : scene::PropertyType::Float3, {}, parameter.value};
}

/// Errors where they stand; the other severities are for editors.
void report_errors(const Snapshot& snapshot, const std::vector<Diagnostic>& diagnostics,
                   const std::vector<std::string>& paths, Problems& problems) {
  for (const Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity != Severity::Error) continue;
    const FilePlace place = snapshot.place(snapshot.absolute(diagnostic.where));
    problems.add(paths[place.file.value], snapshot.text(place.file), {}, place.span,
                 fmt::format("{} [{}]", message(diagnostic), code_name(diagnostic.code)));
  }
}

}  // namespace

std::optional<scene::ShaderId> PartReader::document(const std::string& path, const std::string& root,
                                                    const Origin& where) {
  const auto key = std::pair(path, root);
  if (const auto known = documents_.find(key); known != documents_.end()) return known->second;
  return documents_[key] = read_document(path, root, where);
}

std::optional<scene::ShaderId> PartReader::read_document(const std::string& path, const std::string& root,
                                                         const Origin& where) {
  const auto fail = [&](std::string message) {
    problems_.add(*where.file, where.id, std::move(message));
    return std::nullopt;
  };
  const std::optional<SourceText> text = table_.text(path);
  if (!text) return fail(fmt::format("the document {} {}", FileTable::shown(path, *where.file), table_.why_not(path)));
  const std::optional<std::string> canonical = root.empty() ? std::string() : canonical_name(root);
  if (!canonical) return fail(fmt::format("`root` takes a name, got `{}`", root));
  if (scene_.shaders.size() >= scene::kMaxShaders)
    return fail(fmt::format("a scene has at most {} shaders", scene::kMaxShaders));

  Document document(*text, language_of_path(path));
  std::vector<std::string> paths = {path};
  files::follow_includes(document, paths, table_);
  const Snapshot& snapshot = document.snapshot();
  const Result<ir::Program> program = snapshot.program(*canonical);
  if (!program) {
    report_errors(snapshot, snapshot.diagnostics(*canonical), paths, problems_);
    return fail(fmt::format("the document gives no BRDF: {}", program.error()));
  }
  const emit::Target* glsl = emit::find_target("glsl");
  require(glsl != nullptr, "there is no target glsl");
  const Result<emit::EmittedCode> code = glsl->emit(*program, {.parameters = emit::ParameterStyle::Uniform});
  if (!code) return fail(code.error());

  scene::Shader shader{path.substr(path.rfind('/') + 1), scene::ShaderKind::Brdf, {}, code->text, {path, {}, 0}};
  const std::vector<std::string> names = emit::parameter_identifiers(*program);
  const scene::ShaderId id{static_cast<uint32_t>(scene_.shaders.size())};
  for (std::size_t i = 0; i < program->parameters.size(); ++i) {
    shader.properties.push_back(property_of(program->parameters[i], names[i]));
    spellings_[id.value].push_back(program->parameters[i].canonical);
  }
  scene_.shaders.push_back(std::move(shader));
  return id;
}

}  // namespace texbrdf::scene_json
