#pragma once

#include <cstdint>

#include "lsp/json_writer.h"
#include "render/bad_pixels.h"

namespace texbrdf::lsp {

// What the frames of documents and of scenes have in common (docs/lsp.md).

void write_bad_pixels(JsonWriter& out, const render::BadPixelCounts& counts);
void write_samples(JsonWriter& out, uint32_t drawn, uint32_t all);

}  // namespace texbrdf::lsp
