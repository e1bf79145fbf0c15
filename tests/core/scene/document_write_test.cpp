// What is written: numbers to the bit, text to the letter, and nothing that could not be read again.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/scene/document_json.h"

namespace seesaw {
namespace {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// `x` after a trip through a file, by way of a coordinate and of a normal's value.
void expect_round_trip(double x) {
  Document<3> document;
  document.constraints.push_back({boundary<3>({x, 0, -x}, {0, 1, 0}, x, x)});
  const Constraint<3> c = parse_document<3>(to_json_text(document)).constraints.at(0).constraint;
  EXPECT_TRUE(same_bits(c.at[0], x)) << x;
  EXPECT_TRUE(same_bits(c.at[2], -x)) << x;
  EXPECT_TRUE(same_bits(c.normal->offset, x)) << x;
  EXPECT_TRUE(same_bits(c.normal->value, x)) << x;
}

TEST(DocumentWrite, NumbersReadBackToTheSameBits) {
  for (const double x : {0.0,
                         -0.0,
                         0.1,
                         1.0 / 3,
                         1e-308,
                         5e-324,
                         2.2250738585072011e-308,
                         1e15,
                         1e16,
                         1e17,
                         1e22,
                         1e23,
                         0x1p53,
                         0x1p53 + 2,
                         0x1p63,
                         0x1p64,
                         0x1.8p64,
                         123456789012345680000.0,
                         4.5e6,
                         std::numeric_limits<double>::max(),
                         std::nextafter(1.0, 2.0)})
    expect_round_trip(x);
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::bit_cast<double>(random.bits());
    if (std::isfinite(x)) expect_round_trip(x);
  }
}

TEST(DocumentWrite, NumbersAreWrittenShort) {
  Document<2> document;
  document.constraints.push_back({boundary<2>({0.1, -0.0})});
  document.constraints.push_back({boundary<2>({1e-308, 1e300})});
  const std::string text = to_json_text(document);
  EXPECT_NE(text.find("\"at\": [0.1, -0.0]}"), std::string::npos) << text;
  EXPECT_NE(text.find("\"at\": [1e-308, 1e+300]}"), std::string::npos) << text;
}

TEST(DocumentWrite, TextKeepsEveryCharacter) {
  using namespace std::string_literals;
  Document<2> document;
  document.title = "\"\\/\b\f\n\r\t\x01\x7F\0 \xE2\x82\xAC \xF0\x9F\x99\x82"s;
  EXPECT_EQ(parse_document<2>(to_json_text(document)).title, document.title);
  document.title = "a\xFFz";
  EXPECT_EQ(parse_document<2>(to_json_text(document)).title, "a\xEF\xBF\xBDz");
}

/// The error of a document that is not written.
template <int Dim>
std::string refusal(const Document<Dim>& document) {
  try {
    to_json_text(document);
  } catch (const FileError&) {
    return "a FileError, though there is no file";
  } catch (const Error& error) {
    return error.what();
  }
  return "written";
}

TEST(DocumentWrite, WhatCouldNotBeReadIsNotWritten) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](const Constraint<2>& c) {
    Document<2> document;
    for (int i = 0; i < 3; ++i) document.constraints.push_back({interior<2>({0, 0})});
    document.constraints.push_back({c});
    return refusal(document);
  };
  EXPECT_EQ(with(boundary<2>({0, nan})), "constraints[3].at: expected a finite number");
  EXPECT_EQ(with(boundary<2>({0, 0}, {INFINITY, 0})), "constraints[3].normal: expected a finite number");
  EXPECT_EQ(with(boundary<2>({0, 0}, {1, 0}, nan)), "constraints[3].offset: expected a finite number");
  EXPECT_EQ(with(boundary<2>({0, 0}, {1, 0}, 1, nan)), "constraints[3].value: expected a finite number");
  EXPECT_EQ(with(boundary<2>({0, 0}, {0, 0})),
            "constraints[3].normal: the zero vector has no direction: give a vector of any other length");
  EXPECT_EQ(with(interior<2>({0, 0}, -2)),
            "constraints[3].value: expected a number above 0 inside, found -2");
  EXPECT_EQ(with(exterior<2>({0, 0}, 0)), "constraints[3].value: expected a number below 0 outside, found 0");
  EXPECT_EQ(with({ConstraintKind::boundary, {0, 0}, 1, {}}),
            "constraints[3].value: a boundary constraint is 0 by definition");
  EXPECT_EQ(with({ConstraintKind::interior, {0, 0}, 1, NormalConstraint<2>{}}),
            "constraints[3].normal: only a boundary constraint has a normal, this one is interior");
  Document<2> document;
  document.smoothing = -1;
  EXPECT_EQ(refusal(document), "smoothing: expected 0 or a positive number, found -1");
  document = {};
  document.display.view = Box<2>();
  EXPECT_EQ(refusal(document), "display.view: expected \"min\" below \"max\" in every coordinate");
  Document<3> solid;
  solid.camera = Camera();
  solid.camera->target = solid.camera->position;
  EXPECT_EQ(refusal(solid), "camera.target: expected another point than the camera's position");
}

}  // namespace
}  // namespace seesaw
