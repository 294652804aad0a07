#include "lsp/previews.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace texbrdf::lsp {
namespace {

preview::Scene scene_of(const OpenPreview& preview, const Snapshot& snapshot, int64_t version) {
  return {snapshot, preview.model, version, preview.root, preview.view, preview.values, preview.object};
}

}  // namespace

std::string unknown_preview(int64_t id) {
  return fmt::format("there is no preview {}", id);
}

std::optional<std::string> change_view(const ViewChange& change, OpenPreview& preview) {
  constexpr int64_t kMinSize = 16;
  constexpr int64_t kMaxSize = 2048;
  render::SphereView view = preview.view;
  if (change.width || change.height) {
    const int64_t side = std::min(change.width.value_or(kMaxSize), change.height.value_or(kMaxSize));
    view.size = static_cast<uint32_t>(std::clamp(side, kMinSize, kMaxSize));
  }
  view.theta = change.theta.value_or(view.theta);
  view.phi = change.phi.value_or(view.phi);
  view.zoom = change.zoom.value_or(view.zoom);
  view.exposure = change.exposure.value_or(view.exposure);
  view.gamma = change.gamma.value_or(view.gamma);
  view.times_cosine = change.cosine.value_or(view.times_cosine);
  if (auto fault = render::find_fault(view)) return fault;
  preview.view = view;
  if (change.root && *change.root != preview.root) {
    preview.root = *change.root;
    preview.is_stale = true;
  }
  return std::nullopt;
}

void update_exact(OpenPreview& preview, const Snapshot& snapshot) {
  ExactValues& exact = preview.exact;
  if (exact.model == preview.model) return;
  exact.model = preview.model;
  Result<ir::Program> program = preview::scene_program(scene_of(preview, snapshot, 0));
  if (!program) return;
  Result<preview::ExactModel> model = preview::ExactModel::compile(*std::move(program));
  exact.problem = model ? std::string() : model.error();
  exact.source = model ? std::make_shared<const preview::ExactModel>(*std::move(model)) : nullptr;
}

int64_t Previews::open(OpenPreview preview) {
  if (!service_ && wake_) service_ = std::make_unique<preview::PreviewService>(wake_);
  preview.viewer = viewer_;
  const int64_t id = take_id();
  previews_.emplace(id, std::move(preview));
  return id;
}

OpenPreview* Previews::find(int64_t id) {
  const auto found = previews_.find(id);
  return found == previews_.end() || found->second.viewer != viewer_ ? nullptr : &found->second;
}

const OpenPreview* Previews::find_of_any(int64_t id) const {
  const auto found = previews_.find(id);
  return found == previews_.end() ? nullptr : &found->second;
}

bool Previews::are_many() const {
  constexpr std::size_t kMany = 256;
  return previews_.size() >= kMany;
}

void Previews::note_change() {
  for (auto& [id, preview] : previews_) preview.is_stale = true;
}

void Previews::close(int64_t id) {
  if (find(id) == nullptr) return;
  previews_.erase(id);
  if (service_) service_->close(id);
}

void Previews::close_all(std::string_view uri) {
  std::erase_if(previews_, [&](const auto& entry) {
    if (entry.second.uri != uri) return false;
    if (service_) service_->close(entry.first);
    return true;
  });
}

void Previews::close_all_of(ViewerId viewer) {
  std::erase_if(previews_, [&](const auto& entry) {
    if (entry.second.viewer != viewer) return false;
    if (service_) service_->close(entry.first);
    return true;
  });
}

void Previews::clear() {
  for (const auto& [id, preview] : previews_) {
    if (service_) service_->close(id);
  }
  previews_.clear();
}

void Previews::show(int64_t id, const OpenPreview& preview, const Snapshot& snapshot, int64_t version) {
  if (service_) service_->show(id, scene_of(preview, snapshot, version));
}

void Previews::acknowledge(int64_t id) {
  if (service_ && find(id) != nullptr) service_->acknowledge(id);
}

std::vector<preview::Event> Previews::take_events() {
  return service_ ? service_->take_events() : std::vector<preview::Event>();
}

std::vector<std::string> Previews::take_faults() {
  return service_ ? service_->take_faults() : std::vector<std::string>();
}

}  // namespace texbrdf::lsp
