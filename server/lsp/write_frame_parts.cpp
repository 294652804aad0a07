#include "lsp/write_frame_parts.h"

namespace texbrdf::lsp {

void write_bad_pixels(JsonWriter& out, const render::BadPixelCounts& counts) {
  out.key("badPixels");
  out.begin_object();
  out.member("nan", counts[render::BadPixel::NotANumber]);
  out.member("infinite", counts[render::BadPixel::Infinite]);
  out.member("negative", counts[render::BadPixel::Negative]);
  out.end_object();
}

void write_samples(JsonWriter& out, uint32_t drawn, uint32_t all) {
  out.key("samples");
  out.begin_object();
  out.member("drawn", drawn);
  out.member("all", all);
  out.end_object();
}

}  // namespace texbrdf::lsp
