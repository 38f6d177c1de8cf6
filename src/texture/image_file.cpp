// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "texture/image_file.h"
#include "io/read/text_words.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#ifdef SHAPE_CORRESPONDENCE_WITH_IMAGES
#include <csetjmp>
#include <cstdio> // before jpeglib.h, which needs it
#include <memory>

#include <jpeglib.h>
#include <png.h>
#endif

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr std::string_view png_begin("\x89PNG\r\n\x1a\n", 8), jpeg_begin("\xff\xd8\xff", 3);

} // namespace

bool is_png(std::string_view bytes) { return begins_with(bytes, png_begin); }

std::string fault_of_image(std::string_view bytes)
{
  return is_png(bytes) || begins_with(bytes, jpeg_begin) ? "" : "is not a PNG or JPEG image";
}

void Image_budget::take(std::size_t width, std::size_t height, std::size_t scans)
{
  constexpr std::size_t most_in_row = 8192; // limit for width and height
  const std::string size = "has " + std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0 || width > most_in_row || height > most_in_row)
    throw Invalid_input(size + "; at most " + std::to_string(most_in_row) + " in each direction are read");
  if (width * height > pixels)
    throw Invalid_input(size + ", more than are left of the " + std::to_string(Image_budget().pixels) +
                        " that the images of a model may have; make them smaller");
  if (width * height * scans > scanned)
    throw Invalid_input(size + " in " + std::to_string(scans) +
                        " scans, which take too long to read; save it as a JPEG that is "
                        "not progressive");
  pixels -= width * height;
  scanned -= width * height * scans;
}

#ifdef SHAPE_CORRESPONDENCE_WITH_IMAGES

namespace {

Image decoded_png(const std::string& bytes, Image_budget& budget)
{
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto fail = [&] { throw Invalid_input(std::string("is damaged (") + png.message + ")"); };
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) fail();
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&png, png_image_free);
  budget.take(png.width, png.height, 1);
  png.format = PNG_FORMAT_RGBA;
  Image image{int(png.width), int(png.height), std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr)) fail();
  return image;
}

struct Jpeg_errors
{
  jpeg_error_mgr manager;
  std::jmp_buf place;
};

void leave_jpeg(j_common_ptr decoder) { std::longjmp(reinterpret_cast<Jpeg_errors*>(decoder->err)->place, 1); }

void say_nothing(j_common_ptr, int) {}

/// The number of scans of a JPEG; each begins with a marker that does not occur in its data.
std::size_t number_of_scans(std::string_view bytes)
{
  std::size_t result = 0;
  for (std::size_t at = 0; (at = bytes.find("\xFF\xDA", at)) != std::string_view::npos; at += 2)
    ++result;
  return result;
}

/// Decodes the pixels, or only the size if `image.pixels` is empty. \return whether the data are valid. No object with
/// a destructor may live here, since longjmp() skips destructors
bool decode_jpeg(const std::string& bytes, Image& image)
{
  jpeg_decompress_struct decoder;
  Jpeg_errors errors;
  decoder.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = leave_jpeg;
  errors.manager.emit_message = say_nothing;
  if (setjmp(errors.place)) {
    jpeg_destroy_decompress(&decoder);
    return false;
  }
  jpeg_create_decompress(&decoder);
  jpeg_mem_src(&decoder, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&decoder, TRUE);
  if (image.pixels.empty()) {
    image.width = int(decoder.image_width);
    image.height = int(decoder.image_height);
  } else {
    decoder.out_color_space = JCS_EXT_RGBA;
    jpeg_start_decompress(&decoder);
    while (decoder.output_scanline < decoder.output_height) {
      JSAMPROW row = image.pixels.data() + std::size_t(decoder.output_scanline) * std::size_t(image.width) * 4;
      jpeg_read_scanlines(&decoder, &row, 1);
    }
    jpeg_finish_decompress(&decoder);
  }
  jpeg_destroy_decompress(&decoder);
  return true;
}

Image decoded_jpeg(const std::string& bytes, Image_budget& budget)
{
  Image image;
  const auto decode = [&] {
    if (!decode_jpeg(bytes, image)) throw Invalid_input("is damaged");
  };
  decode(); // reads the size
  budget.take(std::size_t(image.width), std::size_t(image.height), number_of_scans(bytes));
  image.pixels.resize(std::size_t(image.width) * std::size_t(image.height) * 4);
  decode();
  return image;
}

} // namespace

Image decoded_image(const std::string& bytes, Image_budget& budget)
{
  if (const std::string fault = fault_of_image(bytes); !fault.empty()) throw Invalid_input(fault);
  return is_png(bytes) ? decoded_png(bytes, budget) : decoded_jpeg(bytes, budget);
}

std::string png_of(const Image& image)
{
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(image.width);
  png.height = png_uint_32(image.height);
  png.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
    throw Invalid_input(std::string("the image cannot be written (") + png.message + ")");
  bytes.resize(size);
  return bytes;
}

#else

namespace {

[[noreturn]] void fail()
{
  throw Invalid_input("is an image, and the program was built without libpng and libjpeg (see README.md)");
}

} // namespace

Image decoded_image(const std::string&, Image_budget&) { fail(); }

std::string png_of(const Image&) { fail(); }

#endif

} // namespace CGAL::Shape_correspondence::IO
