#include "core/mesh/mesh_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/random.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/vertex_normals.h"
#include "tests/core/mesh/test_meshes.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

LoadedMesh mesh_in(const std::string& text, const std::string& name = "m.obj") {
  return std::get<LoadedMesh>(parse_model(text, name));
}
PointCloud cloud_in(const std::string& text, const std::string& name) {
  return std::get<PointCloud>(parse_model(text, name));
}

/// The number as `Bits` in a byte order.
template <class Number>
std::string bytes_of(Number number, bool big = false) {
  std::string bytes(reinterpret_cast<const char*>(&number), sizeof number);
  if (big == (std::endian::native == std::endian::little)) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

// --- OBJ

const char* const square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ReadObj, EveryFormOfAFace) {
  for (const char* faces :
       {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/7/1 2/8/1 3//1 4/9/1",
        "f -4 -3 -2 -1", "f -4//-1 -3//-1 -2//-1 -1//-1", "f 1 2 \\\n3 4", "f 1 2 3\\\r\n 4"}) {
    const LoadedMesh loaded = mesh_in(square_obj + std::string("vn 0 0 2\nvt 0 0\n") + faces + "\n");
    EXPECT_EQ(loaded.mesh.vertices.cols(), 4) << faces;
    EXPECT_EQ(loaded.mesh.faces.cols(), 2) << faces;
    EXPECT_FALSE(loaded.repairs.any()) << faces;
    const bool normals = std::string(faces).find("//") != std::string::npos;
    EXPECT_EQ(loaded.mesh.has_normals(), normals) << faces;
    if (normals) {
      EXPECT_EQ(loaded.mesh.normals.col(2), Point<3>(0, 0, 1));
    }
    EXPECT_DOUBLE_EQ(check_mesh(loaded.mesh).area, 1);
  }
}

TEST(ReadObj, AsPeopleWriteIt) {
  const LoadedMesh loaded = mesh_in(
      "\xEF\xBB\xBF# a model\r\nmtllib a.mtl\r\no thing\r\n\r\nv 0 0 0 0.5 0.5 0.5\r\n\tv  1 0 0 1.0\r\n"
      "v 1 1 +0.0 1 0 0 1 # red\r\nvt 0.5 0.5\r\ng one two\r\nusemtl steel\r\ns off\r\nf 1 2 3\r\nl 1 2\r\np "
      "1");
  EXPECT_EQ(loaded.mesh.faces.cols(), 1);
  EXPECT_EQ(loaded.repairs.lines_and_points, 2);
  // Faces may run ahead of their vertices.
  EXPECT_EQ(mesh_in("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").mesh.faces.cols(), 1);
  // Creases: one vertex with two normals has none.
  EXPECT_FALSE(mesh_in(std::string(square_obj) + "vn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//1\n")
                   .mesh.has_normals());
  const PointCloud cloud = cloud_in("v 0 0 0\nv 1 0 0\nvn 1 0 0\nvn 0 1 0\n", "points.obj");
  EXPECT_EQ(cloud.points.cols(), 2);
  EXPECT_TRUE(cloud.has_normals());
}

// --- PLY

TEST(ReadPly, TextAndBothByteOrdersWithForeignElementsInAnyOrder) {
  const auto header = [](const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment made by hand\nobj_info none\nelement material 2\n"
           "property list uchar char junk\nproperty short id\nelement face 2\nproperty uchar flags\n"
           "property list ushort uint vertex_index\nproperty list int double more\nelement vertex 4\n"
           "property uchar red\nproperty double z\nproperty float x\nproperty int y\nproperty float nx\n"
           "property float ny\nproperty float nz\nend_header\n";
  };
  std::string text = header("ascii") +
                     "2 7 -8 300\n0 -2\n\n5 3 0 1 2 0\n6 4 0 2 3 1 2 0.5 0.25\n"
                     "255 0.125 0 0 0 0 1\n0 0.125 1 0 0 0 1\n0 0.125 1 1 0 0 1\n0 0.125 0 1 0 0 1\n";
  std::vector<LoadedMesh> all = {mesh_in(text, "a.ply")};
  for (const bool big : {false, true}) {
    std::string b = header(big ? "binary_big_endian" : "binary_little_endian");
    const auto u8 = [&](int x) { b += static_cast<char>(x); };
    u8(2), u8(7), u8(-8), b += bytes_of<std::int16_t>(300, big), u8(0), b += bytes_of<std::int16_t>(-2, big);
    const auto face = [&](int flags, const std::vector<std::uint32_t>& corners,
                          const std::vector<double>& more) {
      u8(flags);
      b += bytes_of(static_cast<std::uint16_t>(corners.size()), big);
      for (const std::uint32_t v : corners) b += bytes_of(v, big);
      b += bytes_of(static_cast<std::int32_t>(more.size()), big);
      for (const double x : more) b += bytes_of(x, big);
    };
    face(5, {0, 1, 2}, {});
    face(6, {0, 2, 3, 1}, {0.5, 0.25});
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
      u8(255);
      b += bytes_of(0.125, big) + bytes_of(static_cast<float>(x), big) + bytes_of(std::int32_t{y}, big);
      b += bytes_of(0.f, big) + bytes_of(0.f, big) + bytes_of(1.f, big);
    }
    all.push_back(mesh_in(b, "b.ply"));
    all.push_back(mesh_in(b + "\n", "b"));
  }
  for (const LoadedMesh& loaded : all) {
    EXPECT_EQ(loaded.mesh.vertices.col(2), Point<3>(1, 1, 0.125));
    EXPECT_EQ(loaded.mesh.faces.col(0), Eigen::Vector3i(0, 1, 2));
    EXPECT_EQ(loaded.mesh.faces, all[0].mesh.faces);
    EXPECT_EQ(loaded.mesh.vertices, all[0].mesh.vertices);
  }
}

TEST(ReadPly, HeadersEndAsTheyBegan) {
  // The first byte of the data looks like a line feed: a vertex list of ten corners' count, were it one.
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string b = "ply" + end + "format binary_little_endian 1.0" + end + "element vertex 1" + end;
    for (const char* axis : {"x", "y", "z"}) b += std::string("property uchar ") + axis + end;
    b += "end_header" + end + "\n\r\n";
    const PointCloud cloud = cloud_in(b, "c.ply");
    EXPECT_EQ(cloud.points.col(0), Point<3>(10, 13, 10));
  }
}

// --- OFF, STL

TEST(ReadOff, Variants) {
  for (const char* text :
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
        "# c\n\nOFF # c\n3 1 3 # c\n\n0 0 0 # c\n1 0 0\n# c\n0 1 0\n3 0 1 2 255 0 0\n",
        "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2 0.5 0.5 0.5 1\n",
        "STCNOFF\n3 1\n0 0 0 0 0 1 255 0 0 255 0 0\n1 0 0 0 0 1 0 0 0 0 1 1\n0 1 0 0 0 1 0 0 0 0 1 1\n3 0 1 "
        "2\n",
        "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}) {
    const LoadedMesh loaded = mesh_in(text, "m.off");
    EXPECT_EQ(loaded.mesh.vertices.col(2), Point<3>(0, 1, 0)) << text;
    EXPECT_EQ(loaded.mesh.faces.cols(), 1) << text;
    EXPECT_EQ(loaded.mesh.has_normals(), std::string(text).find("NOFF") != std::string::npos) << text;
  }
}

std::string binary_stl(const TriangleMesh& mesh, const std::string& header) {
  std::string bytes =
      header + std::string(80 - header.size(), ' ') + bytes_of(static_cast<std::uint32_t>(mesh.faces.cols()));
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    for (int k = 0; k < 3; ++k) bytes += bytes_of(std::numeric_limits<float>::quiet_NaN());
    for (int k = 0; k < 3; ++k)
      for (int d = 0; d < 3; ++d) bytes += bytes_of(static_cast<float>(mesh.vertices(d, mesh.faces(k, f))));
    bytes += "xy";
  }
  return bytes;
}

TEST(ReadStl, TextAndBinaryAndBinaryThatCallsItselfSolid) {
  const TriangleMesh cube = unit_cube();
  const std::string text = mesh_bytes(cube, ".stl", {.text = true});
  std::string loud = text;
  for (char& c : loud)
    if (c >= 'a' && c <= 'z' && c != 'e') c = static_cast<char>(c - 'a' + 'A');
  for (const std::string& bytes :
       {text, loud, "\n" + text, binary_stl(cube, "anything"), binary_stl(cube, "solid gold"),
        binary_stl(cube, "solid") + std::string(6, '\0')}) {
    const LoadedMesh loaded = mesh_in(bytes, "m.stl");
    EXPECT_EQ(loaded.repairs.welded_vertices, 28);
    const MeshReport report = check_mesh(loaded.mesh);
    EXPECT_EQ(report.vertices, 8);
    EXPECT_EQ(report.genus, 0);
    EXPECT_DOUBLE_EQ(report.volume, 1);
  }
}

// --- points

TEST(ReadPoints, TheWaysToWriteThem) {
  const PointCloud expected{Points<3>{{1, 4}, {2, 5}, {3, 6}}, Points<3>{{0, 0}, {0, 1}, {1, 0}}};
  for (const auto& [text, name] : std::vector<std::pair<std::string, std::string>>{
           {"1 2 3 0 0 1\n4 5 6 0 1 0\n", "a.xyz"},
           {"# points\n\n1\t2 3 0 0 1\r\n4 5 6 0 1 0", "a.xyz"},
           {"2\n1 2 3\n4 5 6\n0 0 1\n0 1 0\n", "a.pwn"},
           {"2\n1 2 3 0 0 1\n4 5 6 0 1 0\n", "a.pwn"},
           {"# x; y; z\n1,2,3,0,0,1\n4,5,6,0,1,0\n", "a.csv"},
           {"1, 2, 3, 0, 0, 1\n4, 5, 6, 0, 1, 0\n", "a.csv"},
           {"1;2;3;0;0;1\n4; 5; 6; 0; 1; 0\n", "a.csv"},
           {"x,y,z,nx,ny,nz\n1,2,3,0,0,1\n4,5,6,0,1,0\n", "a.csv"},
           {"\xEF\xBB\xBF\"NZ\";\"ny\";\"nx\";\"id\";\"Z\";\"Y\";\"X\"\r\n1;0;0;7;3;2;1\r\n0;1;0;8;6;5;4\r\n",
            "a.csv"},
           {"1 2 3 0 0 1\n4 5 6 0 1 0\n", "without_a_name"},
           {"//X Y Z Normal_X Normal_Y Normal_Z\n1 2 3 0 0 1\n4 5 6 0 1 0\n", "a.asc"},
           {"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
            "property float nx\nproperty float ny\nproperty float nz\nend_header\n1 2 3 0 0 1\n4 5 6 0 1 0\n",
            "a.ply"}}) {
    const PointCloud cloud = cloud_in(text, name);
    EXPECT_EQ(cloud.points, expected.points) << text;
    EXPECT_EQ(cloud.normals, expected.normals) << text;
  }
  EXPECT_FALSE(cloud_in("1 2 3\n4 5 6\n", "a.xyz").has_normals());
  // Colors are no normals, but whole numbers may be.
  EXPECT_FALSE(cloud_in("1 2 3 255 0 12\n4 5 6 7 8 9\n", "a.xyz").has_normals());
  EXPECT_TRUE(cloud_in("1 2 3 0 0 2\n4 5 6 0 3 0\n", "a.xyz").has_normals());
  EXPECT_TRUE(cloud_in("1 2 3 0 0 200\n4 5 6 0 -300 0\n", "a.xyz").has_normals());
  EXPECT_EQ(cloud_in("2\n1 2 3\n4 5 6\n", "a.pwn").points.cols(), 2);
  // Normals that are not known; points in one place stay apart.
  const PointCloud holes = cloud_in("1 2 3 nan 0 0\n1 2 3 0 0 0\n1 2 3 0 0 1\n", "a.xyz");
  EXPECT_EQ(holes.points.cols(), 3);
  EXPECT_TRUE(holes.normals.col(0).array().isNaN().all());
  EXPECT_EQ(holes.normals.col(1), Point<3>(0, 0, 0));
}

// --- there and back

TEST(MeshFile, WhatIsWrittenIsReadBack) {
  Random random(3);
  TriangleMesh mesh = sphere_mesh(2);
  for (Index v = 0; v < mesh.vertices.cols(); ++v) mesh.vertices.col(v) *= random.uniform(0.5, 1.5) / 3;
  mesh.normals = vertex_normals(mesh);
  const ScratchFolder folder;
  for (const char* name : {"m.obj", "m.ply", "m.off", "M.OBJ"})
    for (const bool text : {false, true}) {
      write_mesh(folder / name, mesh, {.text = text});
      const LoadedMesh again = read_mesh(folder / name);
      EXPECT_FALSE(again.repairs.any()) << name;
      EXPECT_EQ(again.mesh.vertices, mesh.vertices) << name;
      EXPECT_EQ(again.mesh.faces, mesh.faces) << name;
      // Normalized again.
      EXPECT_LT((again.mesh.normals - mesh.normals).cwiseAbs().maxCoeff(), 4e-16) << name;
    }
  for (const bool text : {false, true}) {
    write_mesh(folder / "m.stl", mesh, {.text = text});
    const TriangleMesh again = read_mesh(folder / "m.stl").mesh;
    EXPECT_EQ(check_mesh(again).genus, 0);
    EXPECT_NEAR(check_mesh(again).volume, check_mesh(mesh).volume, 1e-7);
  }
  PointCloud cloud{mesh.vertices, mesh.normals};
  cloud.normals.col(3).setConstant(std::numeric_limits<double>::quiet_NaN());
  for (const char* name : {"c.xyz", "c.pwn", "c.csv", "c.ply"})
    for (const bool normals : {false, true}) {
      if (!normals) cloud.normals.resize(3, 0);
      write_point_cloud(folder / name, cloud);
      const PointCloud again = read_point_cloud(folder / name);
      EXPECT_EQ(again.points, cloud.points) << name;
      ASSERT_EQ(again.normals.cols(), cloud.normals.cols()) << name;
      for (Index i = 0; i < cloud.normals.cols(); ++i)
        EXPECT_TRUE(i == 3 ? again.normals.col(i).array().isNaN().all()
                           : again.normals.col(i) == cloud.normals.col(i));
    }
  EXPECT_THROW(write_mesh(folder / "m.jpg", mesh), FileError);
  EXPECT_THROW(write_mesh(folder / "m.stl", moved(mesh, 1e39, {0, 0, 0})), FileError);
  EXPECT_NE(read_mesh(folder / "m.stl").mesh.faces.cols(), 0) << "the old file stays";
  EXPECT_THROW(write_point_cloud(folder / "c.obj", cloud), FileError);
  EXPECT_THROW(read_mesh(folder / "c.xyz"), FileError);
  EXPECT_THROW(read_point_cloud(folder / "m.obj"), FileError);
  EXPECT_THROW(read_model(folder / "missing.ply"), FileError);
  // What the content says counts more than the name.
  std::filesystem::copy(folder / "m.ply", folder / "really_a_ply.obj");
  EXPECT_EQ(read_mesh(folder / "really_a_ply.obj").mesh.faces, mesh.faces);
}

TEST(MeshFile, AssimpReadsTheRest) {
  const ScratchFolder folder;
  // A glTF file with one triangle mesh of a tetrahedron, placed twice: once moved, once mirrored.
  const TriangleMesh mesh = tetrahedron();
  std::string buffer;
  for (Index v = 0; v < 4; ++v)
    for (int d = 0; d < 3; ++d) buffer += bytes_of(static_cast<float>(mesh.vertices(d, v)));
  for (Index f = 0; f < 4; ++f)
    for (int k = 0; k < 3; ++k) buffer += bytes_of(static_cast<std::uint16_t>(mesh.faces(k, f)));
  write_file(folder / "m.bin", buffer);
  write_file(folder / "m.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0,"translation":[5,0,0]},{"mesh":0,"scale":[-2,1,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"uri":"m.bin","byteLength":72}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})");
  const LoadedMesh loaded = read_mesh(folder / "m.gltf");
  const MeshReport report = check_mesh(loaded.mesh);
  EXPECT_EQ(report.components, 2);
  EXPECT_EQ(report.genus, 0);
  EXPECT_NEAR(report.volume, 1.0 / 6 + 2.0 / 6, 1e-6);
  EXPECT_EQ(loaded.repairs.turned_shells, 0);
  EXPECT_EQ(report.box.min().x(), -2);
  EXPECT_EQ(report.box.max().x(), 6);
  write_file(folder / "bad.gltf", "{\"asset\": 3");
  EXPECT_THROW(read_mesh(folder / "bad.gltf"), FileError);
}

}  // namespace
}  // namespace seesaw
