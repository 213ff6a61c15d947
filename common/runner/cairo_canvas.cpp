#include "common/runner/cairo_canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace clapotis {
namespace {

constexpr const char* font = "DejaVu Sans";  // has the Greek letters of the course

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int count) {
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), count);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

Point checked(Point size) {
  const auto allowed = [](double side) { return side >= 1 && side <= 32767; };  // of cairo's images
  if (allowed(size.x) && allowed(size.y)) return {std::ceil(size.x), std::ceil(size.y)};
  throw std::invalid_argument("a picture cannot be " + std::to_string(size.x) + " x " +
                              std::to_string(size.y) + " pixels: each side must be from 1 to 32767");
}

cairo_surface_t* make_surface(PictureFormat format, Point size, std::string& bytes) {
  if (format == PictureFormat::svg)
    return cairo_svg_surface_create_for_stream(append, &bytes, size.x, size.y);
  if (format == PictureFormat::pdf)
    return cairo_pdf_surface_create_for_stream(append, &bytes, size.x, size.y);
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.x), static_cast<int>(size.y));
}

void use_colour(cairo_t* cairo, Colour c) {
  cairo_set_source_rgba(cairo, double(c.red), double(c.green), double(c.blue), double(c.opacity));
}

[[noreturn]] void refuse(const std::filesystem::path& file, std::errc reason) {
  throw std::system_error(std::make_error_code(reason), "cannot write picture " + file.string());
}

[[noreturn]] void refuse(const std::filesystem::path& file, int error,
                         const std::filesystem::path& leftover) {
  std::error_code ignored;
  std::filesystem::remove(leftover, ignored);
  throw std::system_error(error == 0 ? EIO : error, std::generic_category(),
                          "cannot write picture " + file.string());
}

void write_whole(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::path part = file;
  part += '.';
  part += std::to_string(getpid());
  part += ".part";
  errno = 0;
  std::ofstream out(part, std::ios::binary);
  if (!out) refuse(file, errno, {});
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();  // a full disk may show itself only here
  if (!out) refuse(file, errno, part);
  std::error_code error;
  std::filesystem::rename(part, file, error);
  if (error) refuse(file, error.value(), part);
}

}  // namespace

PictureFormat picture_format(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  if (extension == ".png") return PictureFormat::png;
  if (extension == ".svg") return PictureFormat::svg;
  if (extension == ".pdf") return PictureFormat::pdf;
  throw std::invalid_argument("cannot tell the format of picture " + file.string() +
                              ": its name must end in .png, .svg or .pdf");
}

CairoCanvas::CairoCanvas(std::filesystem::path file, Point size)
    : file_(std::move(file)),
      format_(picture_format(file_)),
      size_(checked(size)),
      surface_(make_surface(format_, size_, bytes_), cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), cairo_destroy) {
  if (cairo_status(cairo_.get()) != CAIRO_STATUS_SUCCESS) refuse(file_, std::errc::not_enough_memory);
  cairo_select_font_face(cairo_.get(), font, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options,
                                    CAIRO_HINT_STYLE_NONE);  // the same widths on paper and on a screen
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cairo_.get(), options);
  cairo_font_options_destroy(options);
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
}

CairoCanvas::CairoCanvas(Point size) : CairoCanvas("image.png", size) {}

CairoCanvas::~CairoCanvas() = default;

std::span<const unsigned char> CairoCanvas::pixels() {
  cairo_surface_flush(surface_.get());
  const auto rows = static_cast<std::size_t>(cairo_image_surface_get_height(surface_.get()));
  const auto row = static_cast<std::size_t>(cairo_image_surface_get_stride(surface_.get()));
  return {cairo_image_surface_get_data(surface_.get()), rows * row};
}

void CairoCanvas::save() {
  auto status = cairo_status(cairo_.get());
  const auto note = [&status](cairo_status_t next) {
    status = status == CAIRO_STATUS_SUCCESS ? next : status;
  };
  if (format_ == PictureFormat::png) note(cairo_surface_write_to_png_stream(surface_.get(), append, &bytes_));
  cairo_surface_finish(surface_.get());
  note(cairo_surface_status(surface_.get()));
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::system_error(
        std::make_error_code(std::errc::io_error),
        "cannot encode picture " + file_.string() + " (" + cairo_status_to_string(status) + ")");
  }
  write_whole(file_, bytes_);
}

void CairoCanvas::rectangle(const Box& box, Colour fill) {
  use_colour(cairo_.get(), fill);
  cairo_rectangle(cairo_.get(), box.corner.x, box.corner.y, box.extent.x, box.extent.y);
  cairo_fill(cairo_.get());
}

void CairoCanvas::discs(std::span<const Disc> discs) {
  cairo_t* cairo = cairo_.get();
  constexpr double turn = 2 * std::numbers::pi;
  for (const Disc& disc : discs) {
    use_colour(cairo, disc.colour);
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, disc.centre.x, disc.centre.y, disc.radius, 0, turn);
    if (disc.hole > 0) {
      cairo_new_sub_path(cairo);
      cairo_arc_negative(cairo, disc.centre.x, disc.centre.y, disc.hole, turn, 0);
    }
    cairo_fill(cairo);
  }
}

void CairoCanvas::line(std::span<const Point> points, Colour colour, double width) {
  use_colour(cairo_.get(), colour);
  cairo_set_line_width(cairo_.get(), width);
  for (const Point p : points) cairo_line_to(cairo_.get(), p.x, p.y);
  cairo_stroke(cairo_.get());
}

void CairoCanvas::segments(std::span<const Point> ends, Colour colour, double width) {
  use_colour(cairo_.get(), colour);
  cairo_set_line_width(cairo_.get(), width);
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    cairo_move_to(cairo_.get(), ends[k].x, ends[k].y);
    cairo_line_to(cairo_.get(), ends[k + 1].x, ends[k + 1].y);
  }
  cairo_stroke(cairo_.get());
}

void CairoCanvas::text(Point at, std::string_view utf8, double height, Colour colour, Align align) {
  const double width = align == Align::left ? 0 : text_width(utf8, height);
  use_colour(cairo_.get(), colour);
  cairo_set_font_size(cairo_.get(), height);
  cairo_move_to(cairo_.get(), at.x - (align == Align::centre ? width / 2 : width), at.y);
  cairo_show_text(cairo_.get(), std::string(utf8).c_str());
  cairo_new_path(cairo_.get());
}

double CairoCanvas::text_width(std::string_view utf8, double height) const {
  cairo_text_extents_t extents;
  cairo_set_font_size(cairo_.get(), height);
  cairo_text_extents(cairo_.get(), std::string(utf8).c_str(), &extents);
  return extents.x_advance;
}

void CairoCanvas::clip(const Box& box) {
  cairo_save(cairo_.get());
  cairo_rectangle(cairo_.get(), box.corner.x, box.corner.y, box.extent.x, box.extent.y);
  cairo_clip(cairo_.get());
}

void CairoCanvas::unclip() { cairo_restore(cairo_.get()); }

}  // namespace clapotis
