// What is refused, and in which words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/mesh/mesh_file.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using testing::HasSubstr;

struct Bad {
  std::string name, bytes, says;
};

void expect_refused(const std::vector<Bad>& files) {
  for (const Bad& file : files) {
    try {
      parse_model(file.bytes, file.name);
      ADD_FAILURE() << "not refused: " << file.name << "\n" << file.bytes;
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), HasSubstr(file.says)) << file.bytes;
      EXPECT_EQ(std::string(error.what()).find(file.name), 0u);
    }
  }
}

TEST(BadFile, NoModelAtAll) {
  expect_refused({{"a.obj", "", "is empty"},
                  {"a.ply", "\n \r\n\t", "is empty"},
                  {"a.stl", std::string(500, '\0'), "is empty"},
                  {"a", "hello, world\n", "not known here"},
                  {"a.dat",
                   std::string("\x7F"
                               "ELF\2\1\1\0\0\0",
                               10),
                   "not known here"},
                  {"a.obj", "\xFF\xFEv\0 \0", "UTF-16"},
                  {"a.obj", "# nothing\n", "neither faces nor points"},
                  {"a.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "no faces"},
                  {"a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "no face with an area"},
                  {"a.obj", "<html>\n", "a.obj:1: unknown statement \"<html>\""},
                  {"a.ply", "PLY\n", "a.ply:1: is no PLY file"},
                  {"a.off", "hello\n", "a.off:1: expected"},
                  {"a.xyz", "C 0 0 0\n", "a.xyz:1: expected numbers"}});
}

TEST(BadFile, OnDisk) {
  const ScratchFolder folder;
  for (const char* name : {"a.glb", "a.3ds", "a.ply"}) write_file(folder / name, "");
  write_file(folder / "b.3ds", "this is no 3DS file");
  write_file(folder / "b.glb", std::string(100, 'x'));
  for (const auto& [name, says] :
       {std::pair("a.glb", "is empty"), std::pair("a.3ds", "is empty"), std::pair("a.ply", "is empty"),
        std::pair("b.3ds", "cannot be read: "), std::pair("b.glb", "cannot be read: "),
        std::pair("c.obj", "no such file"), std::pair("", "is a folder")}) {
    try {
      read_model(folder / name);
      ADD_FAILURE() << name;
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), HasSubstr(says)) << name;
    }
  }
}

TEST(BadFile, Obj) {
  expect_refused({
      {"a.obj", "v 0 0 0\nv 1 nan 0\n", "a.obj:2: a coordinate is not finite: \"nan\""},
      {"a.obj", "v 0 0 0\nv 1 -inf 0\n", "a.obj:2: a coordinate is not finite"},
      {"a.obj", "v 0 0 1e999\n", "a.obj:1: a coordinate is not finite: \"1e999\""},
      {"a.obj", "v 0 0 1e101\n", "vertex 0 has the coordinate 1e+101"},
      {"a.obj", "v 0 0 0,5\n", "a.obj:1: expected a number for a coordinate, found \"0,5\""},
      {"a.obj", "v 0 0 0x1p3\n", "a.obj:1: expected a number"},
      {"a.obj", "v 0 0\n", "a.obj:1: expected v and 3, 4, 6 or 7 numbers"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
       "a.obj:4: vertex 4 is out of range: the file has 3 vertices"},
      {"a.obj", "v 0 0 0\n\nf 1 1 0\n", "a.obj:3: vertex 0: indices count from 1"},
      {"a.obj", "v 0 0 0\nf 1 1 -2\n", "a.obj:2: vertex -2 is out of range: the file has 1 vertex"},
      {"a.obj", "v 0 0 0\nf 1 1 99999999999\n", "out of range"},
      {"a.obj", "v 0 0 0\nf 1 1 999999999999999999999999\n", "expected an index"},
      {"a.obj", "v 0 0 0\nf 1 1 1.5\n", "a.obj:2: expected an index, found \"1.5\""},
      {"a.obj", "v 0 0 0\nvn 0 0 1\nf 1//1 1//2 1//1\n",
       "a.obj:3: normal 2 is out of range: the file has 1 normal"},
      {"a.obj", "v 0 0 0\ncurv 0 1 1 1\n", "a.obj:2: free-form"},
      {"a.obj", "v 0 0 0\nvertex 0 1 1\n", "a.obj:2: unknown statement"},
      {"a.obj", "v 0 0 0\nv 0 0 \x01\x02\xFF\n", "found \"???\""},
  });
}

std::string ply(const std::string& header, const std::string& body, const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + header + "end_header\n" + body;
}

TEST(BadFile, Ply) {
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string vertex = "element vertex 3\n" + xyz;
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  expect_refused({
      {"a.ply", ply(vertex + face, "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "vertex 1: y is not a number"},
      {"a.ply", ply(vertex + face, "0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n"),
       "a.ply:11: a property of \"vertex\" is not finite"},
      {"a.ply", ply(vertex + face, "0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"), "found \"x\""},
      {"a.ply", ply(vertex + face, points + "3 0 1 3\n"),
       "a.ply:13: face 0: vertex 3 is out of range: the file has 3 vertices"},
      {"a.ply", ply(vertex + face, points + "3 0 1 -1\n"), "face 0: vertex -1 is out of range"},
      {"a.ply", ply(vertex + face, points + "3 0 1\n"), "face 0: a list names 3 numbers, but 2 follow"},
      {"a.ply", ply(vertex + face, points + "-1 0 1\n"), "does not fit into the type"},
      {"a.ply", ply(vertex + face, points + "3 0 1 2 9\n"), "more numbers than a \"face\" has"},
      {"a.ply", ply(vertex + face, points), "more than the file holds"},
      {"a.ply", ply(vertex + face, "0 0 0\n1 0 0\n3 0 1 2\n"), "more numbers than a \"vertex\""},
      {"a.ply", ply(vertex + face, points + "3 0 1 2\n3 0 1 2\n"), "more in the file than its header names"},
      {"a.ply", ply("element vertex 4000000000\n" + xyz, points),
       "names 4000000000 elements \"vertex\", more than the file holds"},
      {"a.ply", ply("element vertex 4000000000\n" + xyz, std::string(36, 'x'), "binary_little_endian"),
       "more than the file holds"},
      {"a.ply", ply("element vertex 99999999999999999999\n" + xyz, points),
       "a.ply:3: expected a whole number"},
      {"a.ply", ply("element vertex -3\n" + xyz, points), "a.ply:3: the number of elements is negative"},
      {"a.ply",
       ply(vertex + face, std::string(36, '\0') + std::string("\3\0\0\0\0\1\0\0", 8), "binary_little_endian"),
       "face 0: a list names 3 numbers, more than the file holds"},
      {"a.ply",
       ply(vertex + face, std::string(36, '\0') + "\3" + std::string(11, '\0') + "\7", "binary_big_endian"),
       "face 0: vertex 7 is out of range"},
      {"a.ply", ply(vertex + face, std::string(35, '\0') + "\x7F", "binary_little_endian"),
       "more than the file holds"},
      {"a.ply", ply(vertex, std::string(34, '\0') + "\x80\x7F", "binary_little_endian"),
       "vertex 2: a number is not finite"},
      {"a.ply", ply(vertex, std::string(34, '\0') + "\xC0\x7F", "binary_little_endian"),
       "vertex 2: z is not a number"},
      {"a.ply", ply(vertex, std::string(36, '\0') + "more", "binary_little_endian"),
       "4 bytes in the file behind"},
      {"a.ply", ply("element vertex 1\nproperty float x\nproperty float y\n", "0 0\n"), "no property z"},
      {"a.ply",
       ply(vertex + "element face 1\nproperty list uchar float vertex_indices\n", points + "3 0 1 2\n"),
       "list of whole numbers"},
      {"a.ply",
       ply(vertex + "element face 1\nproperty list float int vertex_indices\n", points + "3 0 1 2\n"),
       "a.ply:8: the length of a list"},
      {"a.ply",
       ply(vertex + "element tristrips 1\nproperty list int int vertex_indices\n", points + "3 0 1 2\n"),
       "triangle strips"},
      {"a.ply", ply(vertex + vertex, points), "a.ply:7: the element \"vertex\" is there twice"},
      {"a.ply", ply(vertex + "property float x\n", points), "the property \"x\" is there twice"},
      {"a.ply", ply("property float x\n", ""), "before the first element"},
      {"a.ply", ply("element vertex 1\nproperty half x\n", ""), "a.ply:4: unknown type \"half\""},
      {"a.ply", ply("elements vertex 1\n", ""), "a.ply:3: expected element, property"},
      {"a.ply", ply(vertex, points, "binary"), "a.ply:2: expected format ascii"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "a.ply:3: the file ends before end_header"},
      {"a.ply", "ply\nelement vertex 3\nend_header\n", "no line \"format"},
      {"a.ply", "ply\n", "ends before end_header"},
  });
}

TEST(BadFile, Off) {
  expect_refused({
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", "a.off:4: a coordinate is not finite"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n",
       "a.off:4: expected a coordinate but the line ends"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
       "a.off:6: vertex 3 is out of range: the file has 3 vertices"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n",
       "a.off:6: the face has 4 corners by its first number, and 3"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n",
       "a.off:2: the header names 3 vertices and 1 face, more than"},
      {"a.off", "OFF\n3 1 0\n0.0 0.0 0\n1 0 0\n0 1 0\n", "a.off:5: the file ends after 0 of the 1 face"},
      {"a.off", "OFF\n3000000000 1000000000 0\n0 0 0\n", "more than the file holds"},
      {"a.off", "OFF\n-3 1 0\n0 0 0\n", "a.off:2: the number of vertices is negative"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", "a.off:7: there is more in the file"},
      {"a.off", "OFF BINARY\n", "a.off:1: binary OFF"},
      {"a.off", "4OFF\n1 0 0\n0 0 0 1\n", "three dimensions"},
      {"a.off", "XOFF\n1 0 0\n0 0 0 1\n", "expected OFF"},
      {"a.off", "OFF\n", "ends where its counts"},
      {"a.off", "NOFF\n1 0 0\n0 0 0 1\n", "expected a normal but the line ends"},
  });
}

TEST(BadFile, Stl) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  std::string binary = std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\0');
  std::string infinite = binary;
  infinite[98] = '\x80', infinite[99] = '\x7F';
  std::string lies = binary;
  lies[83] = '\x7F';
  expect_refused({
      {"a.stl", "solid\n" + facet, "a.stl:8: the file ends before \"endsolid\""},
      {"a.stl", "solid\n" + facet.substr(0, 56), "a.stl:5: the file ends where \"vertex\""},
      {"a.stl", "solid\n" + facet.substr(0, 43), "a.stl:4: the file ends where \"vertex\""},
      {"a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n",
       "a.stl:4: a coordinate is not finite"},
      {"a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n",
       "a.stl:4: expected a coordinate but the line ends"},
      {"a.stl", "solid\n" + facet + "triangle\n", "a.stl:9: expected \"facet\" or \"endsolid\""},
      {"a.stl", "solid\nendsolid\n", "neither faces nor points"},
      {"a.stl", "nothing of the kind", "neither a text STL"},
      {"a.stl", infinite, "triangle 0: a coordinate is not finite"},
      {"a.stl", lies, "names 2130706433 triangles, but only 1 follow"},
      {"a.stl", binary.substr(0, 120), "names 1 triangle, but only 0 follow"},
      {"a.stl", binary + "surplus", "there is more in the file than the 1 triangle"},
  });
}

TEST(BadFile, Points) {
  expect_refused({
      {"a.xyz", "0 0 0\n1 2\n", "a.xyz:2: expected 3 columns as above, found 2"},
      {"a.xyz", "0 0 0 0\n", "a.xyz:1: expected x y z or x y z nx ny nz, found 4 columns"},
      {"a.xyz", "0 0 0\n0 nan 0\n", "a.xyz:2: a coordinate is not finite"},
      {"a.xyz", "0 0 0 0 0 inf\n", "a.xyz:1: a normal is not finite"},
      {"a.xyz", "0 0 0\n0 one 0\n", "a.xyz:2: expected a number for a coordinate, found \"one\""},
      // German decimals, which must not pass for a point with its normal.
      {"a.xyz", "0,5 0,25 1,0\n", "found \"0,5\""},
      {"a.xyz", "0,5 0,25 1,0 0,5 0,25 1,0\n", "found \"0,5\""},
      {"a.csv", "0,5;0,25;1,0\n", "found \"0,5\""},
      {"a.csv", "a,b,c\n1,2,3\n", "a.csv:1: expected numbers, or a line with the column names"},
      {"a.csv", "x,y,z\n", "a.csv:1: there are no points below"},
      {"a.csv", "x,y,z\n1,2,3\n1,2,3,4\n", "a.csv:3: expected 3 columns as above, found 4"},
      {"a.pwn", "3\n1.0 2.0 3.0\n4 5 6\n", "its first line names 3 points, and 2 lines of numbers follow"},
      {"a.pwn", "2\n1 2 3\n4 5 6\n7 8 9\n", "names 2 points, and 3 lines"},
      {"a.pwn", "2\n1 2 nan\n4 5 6\n7 8 9\n7 8 9\n", "a.pwn:2: a coordinate is not finite"},
      {"a.pwn", "1000000000\n1 2 3\n",
       "a.pwn:1: the first line names 1000000000 points, more than the file holds"},
      {"a.pwn", "0\n", "ends behind the number of its points"},
  });
}

}  // namespace
}  // namespace seesaw
