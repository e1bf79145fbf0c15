// Images to PNG files and back: the one writer and the one reader of the house, whoever drew the pixels.
//
// The same image always gives the same bytes: no time stamp, no program name. An image without transparency
// is stored as RGB, which other programs read faster and show the same.
//
// Before it: Image. After it: a file on disk, or bytes for a notebook.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/image/image.h"

namespace seesaw {

/// The bytes of a PNG file that holds `image`. Throws Error for an image without pixels.
std::string png_bytes(const Image& image);

/// Writes the file as a whole or not at all. Throws FileError where it cannot, Error for an image without
/// pixels.
void write_png(const std::filesystem::path& path, const Image& image);

/// The image in a PNG file of any color type; 16-bit files are rounded to 8. Throws FileError when the file
/// is missing, is not a PNG, is cut short or damaged (every chunk's checksum is verified), or when it
/// claims more than 32767 pixels a side or 2^27 in all; sizes are judged before memory is asked for.
Image read_png(const std::filesystem::path& path);

/// As read_png, for bytes already in memory; `name` stands in for the path in messages.
Image image_from_png(std::string_view bytes, const std::string& name = "PNG");

}  // namespace seesaw
