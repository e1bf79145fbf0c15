#include "core/image/png.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "core/base/error.h"
#include "core/base/file.h"

// stb is private to this file (static), so that no other copy of it in a program can answer for ours.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb_image.h>
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace seesaw {
namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::uint32_t longest_side = 32767;
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 27;

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

// The checksum of the PNG specification, appendix D. stb does not look at it, and would decode damage
// silently.
std::uint32_t checksum(std::string_view bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int k = 0; k < 8; ++k) c = c & 1 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
      entries[n] = c;
    }
    return entries;
  }();
  std::uint32_t c = 0xFFFFFFFFu;
  for (const char byte : bytes) c = table[(c ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (c >> 8);
  return c ^ 0xFFFFFFFFu;
}

// Walks the chunks from the signature to IEND; throws at the first thing that is not as it should be.
void check_structure(std::string_view bytes, const std::string& name) {
  if (bytes.size() < signature.size() || bytes.substr(0, signature.size()) != signature)
    throw FileError(name, bytes.empty() ? "empty file, expected a PNG" : "not a PNG file (wrong signature)");
  bool first = true;
  for (std::size_t at = signature.size();;) {
    if (bytes.size() - at < 12) throw FileError(name, "cut short: the PNG ends before its IEND chunk");
    const std::size_t length = big_endian(bytes, at);
    if (length > bytes.size() - at - 12) throw FileError(name, "cut short: the PNG ends inside a chunk");
    const std::string_view kind = bytes.substr(at + 4, 4);
    if (checksum(bytes.substr(at + 4, 4 + length)) != big_endian(bytes, at + 8 + length))
      throw FileError(name, "damaged: the checksum of a PNG chunk does not match");
    if (first) {
      if (kind != "IHDR" || length != 13)
        throw FileError(name, "damaged: a PNG must begin with its IHDR chunk");
      const std::uint32_t width = big_endian(bytes, at + 8), height = big_endian(bytes, at + 12);
      if (width == 0 || height == 0 || width > longest_side || height > longest_side ||
          std::uint64_t{width} * height > most_pixels)
        throw FileError(name, "refused: it claims " + std::to_string(width) + " x " + std::to_string(height) +
                                  " pixels (1 to 32767 a side, 2^27 in all)");
      first = false;
    }
    if (kind == "IEND") return;
    at += 12 + length;
  }
}

void append(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

std::string png_bytes(const Image& image) {
  if (image.empty()) throw Error("an image without pixels cannot be written as PNG");
  const std::vector<std::uint8_t>& rgba = image.bytes();
  bool opaque = true;
  for (std::size_t i = 3; i < rgba.size() && opaque; i += 4) opaque = rgba[i] == 255;

  std::vector<std::uint8_t> rgb;
  if (opaque) {
    rgb.reserve(rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgba.size(); i += 4)
      rgb.insert(rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
  }
  const int channels = opaque ? 3 : 4;
  std::string bytes;
  if (!stbi_write_png_to_func(append, &bytes, image.width(), image.height(), channels,
                              opaque ? rgb.data() : rgba.data(), image.width() * channels))
    throw Error("the PNG encoder ran out of memory");
  return bytes;
}

void write_png(const std::filesystem::path& path, const Image& image) { write_file(path, png_bytes(image)); }

Image read_png(const std::filesystem::path& path) { return image_from_png(read_file(path), path.string()); }

Image image_from_png(std::string_view bytes, const std::string& name) {
  check_structure(bytes, name);
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&std::free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                            &width, &height, &channels, STBI_rgb_alpha),
      &std::free);
  if (!pixels)
    throw FileError(name, std::string("damaged: the PNG does not decode (") + stbi_failure_reason() + ")");
  Image image(width, height);
  std::memcpy(image.bytes().data(), pixels.get(), image.bytes().size());
  return image;
}

}  // namespace seesaw
