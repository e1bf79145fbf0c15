#include "core/image/png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/base/random.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using ::testing::HasSubstr;

Image noise(int width, int height, bool opaque) {
  Random random(7);
  Image image(width, height);
  for (std::uint8_t& byte : image.bytes()) byte = static_cast<std::uint8_t>(random.bits());
  if (opaque)
    for (std::size_t i = 3; i < image.bytes().size(); i += 4) image.bytes()[i] = 255;
  return image;
}

class PngFile : public ::testing::Test {
 protected:
  ScratchFolder folder_;
};

std::string message_of(std::string_view bytes) {
  try {
    image_from_png(bytes, "x.png");
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Image, PixelsAreRowByRowFromTheTopLeft) {
  Image image(3, 2, hex("#102030"));
  image.set(2, 1, hex("#40506070"));
  EXPECT_EQ(image.bytes().size(), 24u);
  EXPECT_EQ(image.bytes()[20], 0x40);
  EXPECT_EQ(image.bytes()[23], 0x70);
  EXPECT_EQ(image.at(0, 0), hex("#102030"));
  EXPECT_TRUE(Image().empty());
}

TEST_F(PngFile, EveryPixelComesBack) {
  for (const bool opaque : {false, true}) {
    const Image image = noise(37, 23, opaque);
    write_png(folder_ / "a.png", image);
    EXPECT_EQ(read_png(folder_ / "a.png"), image);
  }
  const Image dot(1, 1, hex("#D55E00"));
  EXPECT_EQ(image_from_png(png_bytes(dot)), dot);
}

TEST(Png, SameImageSameBytes) { EXPECT_EQ(png_bytes(noise(50, 40, true)), png_bytes(noise(50, 40, true))); }

TEST(Png, OpaqueImagesAreStoredWithoutAlpha) {
  EXPECT_EQ(png_bytes(noise(4, 4, true))[25], 2);   // color type of the IHDR chunk: RGB
  EXPECT_EQ(png_bytes(noise(4, 4, false))[25], 6);  // RGBA
}

TEST(Png, RefusesAnImageWithoutPixels) { EXPECT_THROW(png_bytes(Image()), Error); }

TEST_F(PngFile, MissingFileSaysSo) {
  const auto path = folder_ / "missing.png";
  try {
    read_png(path);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), path.string());
  }
}

TEST(Png, WhatIsNotAPngSaysSo) {
  EXPECT_THAT(message_of("GIF89a, really"), HasSubstr("not a PNG"));
  EXPECT_THAT(message_of(""), HasSubstr("empty"));
  EXPECT_THAT(message_of("x"), HasSubstr("x.png"));
}

TEST(Png, EveryTruncationIsNoticed) {
  const std::string whole = png_bytes(noise(20, 20, true));
  for (std::size_t length = 8; length < whole.size(); ++length)
    EXPECT_THAT(message_of(std::string_view(whole).substr(0, length)), HasSubstr("cut short")) << length;
}

TEST(Png, EveryFlippedBitIsNoticed) {
  const std::string whole = png_bytes(noise(6, 6, true));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    EXPECT_NE(message_of(damaged), "no error") << at;
  }
}

// A header that claims `width` x `height` pixels, with a right checksum, and nothing after it.
std::string header_only(unsigned width, unsigned height) {
  std::string bytes = png_bytes(Image(1, 1, hex("#000000"))).substr(0, 33);
  const auto put = [&](std::size_t at, unsigned value) {
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i) & 0xFF);
  };
  put(16, width);
  put(20, height);
  unsigned c = 0xFFFFFFFFu;
  for (std::size_t i = 12; i < 29; ++i) {
    c ^= static_cast<unsigned char>(bytes[i]);
    for (int k = 0; k < 8; ++k) c = c & 1 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
  }
  put(29, ~c);
  return bytes;
}

TEST(Png, AbsurdSizesAreRefusedFromTheHeaderAlone) {
  EXPECT_THAT(message_of(header_only(4000000000u, 4000000000u)), HasSubstr("4000000000 x 4000000000"));
  EXPECT_THAT(message_of(header_only(0, 5)), HasSubstr("refused"));
  EXPECT_THAT(message_of(header_only(32000, 32000)), HasSubstr("refused"));
  EXPECT_THAT(message_of(header_only(100, 100)), HasSubstr("cut short"));
}

TEST_F(PngFile, AFolderThatIsNotThereIsAFileError) {
  EXPECT_THROW(write_png(folder_ / "no" / "such" / "a.png", noise(2, 2, true)), FileError);
}

}  // namespace
}  // namespace seesaw
