#include "render/protocol.h"

#include <algorithm>
#include <utility>

#include "render/bytes.h"

namespace texbrdf::render {

namespace {

Message finish(MessageKind kind, ByteWriter& writer) {
  return {static_cast<uint32_t>(kind), writer.take()};
}

bool is(const Message& message, MessageKind kind) {
  return message.kind == static_cast<uint32_t>(kind);
}

template <typename T>
std::optional<T> if_complete(const ByteReader& reader, T value) {
  if (!reader.complete()) return std::nullopt;
  return value;
}

void put_model(ByteWriter& writer, const ShaderModel& model) {
  writer.put(std::string_view(model.source));
  writer.put(static_cast<uint32_t>(model.uniforms.size()));
  for (const Uniform& uniform : model.uniforms) {
    writer.put(std::string_view(uniform.name));
    writer.put(uniform.components);
    for (const float value : uniform.value) writer.put(value);
  }
}

/// Every uniform takes bytes, so `complete` fails long before a made-up count could fill the memory.
std::optional<ShaderModel> get_model(ByteReader& reader, std::size_t payload_bytes) {
  ShaderModel model;
  model.source = reader.get_text();
  const auto count = reader.get<uint32_t>();
  if (count > payload_bytes / sizeof(uint32_t)) return std::nullopt;
  for (uint32_t i = 0; i < count; ++i) {
    Uniform uniform;
    uniform.name = reader.get_text();
    uniform.components = reader.get<uint32_t>();
    for (float& value : uniform.value) value = reader.get<float>();
    if (uniform.components != 1 && uniform.components != 3) return std::nullopt;
    model.uniforms.push_back(std::move(uniform));
  }
  return model;
}

void put_view(ByteWriter& writer, const SphereView& view) {
  writer.put(view.size);
  writer.put(view.theta);
  writer.put(view.phi);
  writer.put(view.gamma);
  writer.put(view.exposure);
  writer.put(view.zoom);
  writer.put(uint8_t{view.times_cosine});
}

SphereView get_view(ByteReader& reader) {
  SphereView view;
  view.size = reader.get<uint32_t>();
  view.theta = reader.get<double>();
  view.phi = reader.get<double>();
  view.gamma = reader.get<double>();
  view.exposure = reader.get<double>();
  view.zoom = reader.get<double>();
  view.times_cosine = reader.get<uint8_t>() != 0;
  return view;
}

}  // namespace

Message encode(const Greeting& greeting) {
  ByteWriter writer;
  writer.put(static_cast<uint8_t>(greeting.has_renderer));
  writer.put(std::string_view(greeting.text));
  return finish(MessageKind::Greeting, writer);
}

Message encode(const DrawRequest& request) {
  ByteWriter writer;
  put_model(writer, request.model);
  put_view(writer, request.view);
  return finish(MessageKind::DrawRequest, writer);
}

Message encode(const EvaluateRequest& request) {
  ByteWriter writer;
  put_model(writer, request.model);
  for (const std::vector<float>& list : request.geometry) writer.put(std::span<const float>(list));
  return finish(MessageKind::EvaluateRequest, writer);
}

Message encode(const DrawAnswer& answer) {
  ByteWriter writer;
  const ImageRgba8& image = answer.picture.image;
  writer.put(image.width);
  writer.put(image.height);
  writer.put(std::span<const uint8_t>(image.pixels));
  for (const uint32_t count : answer.picture.bad_pixels.counts) writer.put(count);
  writer.put(answer.milliseconds);
  writer.put(static_cast<uint8_t>(answer.compiled));
  return finish(MessageKind::DrawAnswer, writer);
}

Message encode(const EvaluateAnswer& answer) {
  ByteWriter writer;
  writer.put(std::span<const float>(answer.values));
  return finish(MessageKind::EvaluateAnswer, writer);
}

Message encode(const Refusal& refusal) {
  ByteWriter writer;
  writer.put(static_cast<uint32_t>(refusal.kind));
  writer.put(std::string_view(refusal.message));
  return finish(MessageKind::Refusal, writer);
}

template <>
std::optional<Greeting> decode(const Message& message) {
  if (!is(message, MessageKind::Greeting)) return std::nullopt;
  ByteReader reader(message.payload);
  Greeting greeting;
  greeting.has_renderer = reader.get<uint8_t>() != 0;
  greeting.text = reader.get_text();
  return if_complete(reader, std::move(greeting));
}

template <>
std::optional<DrawRequest> decode(const Message& message) {
  if (!is(message, MessageKind::DrawRequest)) return std::nullopt;
  ByteReader reader(message.payload);
  std::optional<ShaderModel> model = get_model(reader, message.payload.size());
  if (!model) return std::nullopt;
  const SphereView view = get_view(reader);
  return if_complete(reader, DrawRequest{std::move(*model), view});
}

template <>
std::optional<EvaluateRequest> decode(const Message& message) {
  if (!is(message, MessageKind::EvaluateRequest)) return std::nullopt;
  ByteReader reader(message.payload);
  std::optional<ShaderModel> model = get_model(reader, message.payload.size());
  if (!model) return std::nullopt;
  EvaluateRequest request{std::move(*model), {}};
  for (std::vector<float>& list : request.geometry) list = reader.get_list<float>();
  const std::size_t count = request.geometry[0].size();
  const bool even = std::all_of(request.geometry.begin(), request.geometry.end(),
                                [count](const std::vector<float>& list) { return list.size() == count; });
  if (!even) return std::nullopt;
  return if_complete(reader, std::move(request));
}

template <>
std::optional<DrawAnswer> decode(const Message& message) {
  if (!is(message, MessageKind::DrawAnswer)) return std::nullopt;
  ByteReader reader(message.payload);
  DrawAnswer answer;
  ImageRgba8& image = answer.picture.image;
  image.width = reader.get<uint32_t>();
  image.height = reader.get<uint32_t>();
  image.pixels = reader.get_list<uint8_t>();
  for (uint32_t& count : answer.picture.bad_pixels.counts) count = reader.get<uint32_t>();
  answer.milliseconds = reader.get<double>();
  answer.compiled = reader.get<uint8_t>() != 0;
  if (image.width > kMaxPictureSize || image.height > kMaxPictureSize) return std::nullopt;
  if (image.pixels.size() != std::size_t{image.width} * image.height * 4) return std::nullopt;
  return if_complete(reader, std::move(answer));
}

template <>
std::optional<EvaluateAnswer> decode(const Message& message) {
  if (!is(message, MessageKind::EvaluateAnswer)) return std::nullopt;
  ByteReader reader(message.payload);
  EvaluateAnswer answer{reader.get_list<float>()};
  return if_complete(reader, std::move(answer));
}

template <>
std::optional<Refusal> decode(const Message& message) {
  if (!is(message, MessageKind::Refusal)) return std::nullopt;
  ByteReader reader(message.payload);
  const auto kind = reader.get<uint32_t>();
  if (kind > static_cast<uint32_t>(RefusalKind::Renderer)) return std::nullopt;
  Refusal refusal{static_cast<RefusalKind>(kind), reader.get_text()};
  return if_complete(reader, std::move(refusal));
}

}  // namespace texbrdf::render
