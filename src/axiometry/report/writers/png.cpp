// SPDX-License-Identifier: Apache-2.0
#include <cairo.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/report/drawing/picture.h"
#include "axiometry/report/pdf/cairo_painter.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/writer.h"

namespace axiometry::report {
namespace png {
namespace {

constexpr double dots_per_inch = 200.0;
constexpr double points_per_inch = 72.0;

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

std::string big_endian(std::uint32_t x) {
  return {static_cast<char>(x >> 24), static_cast<char>(x >> 16), static_cast<char>(x >> 8), static_cast<char>(x)};
}

/// CRC-32 of PNG chunks (ISO 3309, reflected polynomial).
std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

/// Between the header chunk, always 33 bytes from the start, and the pixels.
std::string with_chunk(std::string png, std::string_view type, std::string_view data) {
  constexpr std::size_t after_header = 33;
  if (png.size() <= after_header) return png;
  const std::string chunk = std::string(type).append(data);
  return png.insert(after_header,
                    big_endian(static_cast<std::uint32_t>(data.size())) + chunk + big_endian(crc32(chunk)));
}

/// The resolution, which Cairo does not write: with it a word processor places the picture in its true size.
std::string with_resolution(std::string png) {
  constexpr char unit_is_metre = 1;
  if (png.find("pHYs") != std::string::npos) return png;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dots_per_inch / 0.0254));
  return with_chunk(std::move(png), "pHYs", big_endian(per_metre) + big_endian(per_metre) + unit_is_metre);
}

/// A name and a text, separated by a zero byte.
std::string with_text(std::string png, std::string_view name, std::string_view text) {
  return with_chunk(std::move(png), "tEXt", std::string(name).append(1, '\0').append(text));
}

Result<std::string> painted(const Figure& page) {
  const double scale = dots_per_inch / points_per_inch;
  const std::unique_ptr<cairo_surface_t, Destroy> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(page.width * scale)),
                                 static_cast<int>(std::ceil(page.height * scale))));
  const std::unique_ptr<cairo_t, Destroy> cairo(cairo_create(surface.get()));
  cairo_set_source_rgb(cairo.get(), 1.0, 1.0, 1.0);
  cairo_paint(cairo.get());
  cairo_scale(cairo.get(), scale, scale);
  paint(page, cairo.get());
  std::string png;
  cairo_status_t status = cairo_status(cairo.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_write_to_png_stream(surface.get(), append, &png);
  if (status != CAIRO_STATUS_SUCCESS) {
    return fail(fmt::format("the picture could not be drawn: {}", cairo_status_to_string(status)));
  }
  return with_resolution(std::move(png));
}

Result<std::string> write(const Subject& subject, const Options& options) {
  AXIOMETRY_TRY(std::string png, painted(picture(subject, options)));
  if (subject.trail_head.empty()) return png;
  return with_text(std::move(png), trail_head_name, subject.trail_head);
}

Result<std::string> set(const Document& document, const Options& options) {
  return painted(picture(translated(document, options)));
}

}  // namespace
}  // namespace png

extern const Writer png_writer;
const Writer png_writer = {
    .extension = "png",
    .title = "All figures as one picture, 200 dots per inch on white",
    .write = png::write,
    .set = png::set,
};

}  // namespace axiometry::report
