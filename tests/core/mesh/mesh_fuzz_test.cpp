// A hundred thousand damaged files of all formats: each is read as a model that can be measured, or refused
// by a FileError, and nothing else.
//
// The damage is deterministic, so a failure names the number of its input and can be had again: set
// SEESAW_FUZZ_FIRST to that number. SEESAW_FUZZ_COUNT asks for more inputs.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/self_intersections.h"
#include "core/mesh/vertex_normals.h"
#include "tests/core/mesh/test_meshes.h"

namespace seesaw {
namespace {

struct Seed {
  std::string name, bytes;
};

/// Faces first, numbers of two bytes, and a list that is no face's.
std::string big_endian_ply() {
  const std::string header =
      "ply\nformat binary_big_endian 1.0\nelement face 2\nproperty list uchar ushort vertex_index\n"
      "property char q\nelement vertex 4\nproperty short x\nproperty short y\nproperty short z\n"
      "property list uchar uchar w\nend_header\n";
  const std::string faces("\3\0\0\0\1\0\2\7\4\0\0\0\2\0\3\0\1\7", 18);
  const std::string vertices("\0\0\0\0\0\0\0\0\1\0\0\0\0\1\5\0\0\0\1\0\0\0\0\0\0\0\0\1\0", 29);
  return header + faces + vertices;
}

const std::vector<Seed>& seeds() {
  static const std::vector<Seed> all = [] {
    std::vector<Seed> list;
    TriangleMesh mesh = tetrahedron();
    mesh.normals = vertex_normals(mesh);
    const PointCloud cloud{mesh.vertices, mesh.normals};
    for (const bool text : {false, true})
      for (const char* ending : {".obj", ".ply", ".off", ".stl"})
        list.push_back({std::string("m") + ending, mesh_bytes(mesh, ending, {.text = text})});
    for (const char* ending : {".xyz", ".pwn", ".csv", ".ply"})
      list.push_back({std::string("c") + ending, point_cloud_bytes(cloud, ending, {.text = true})});
    list.push_back({"big.ply", big_endian_ply()});
    // Polygons, concave and in a ring; what must be welded, turned and dropped.
    list.push_back({"p.obj",
                    "\xEF\xBB\xBF# c\r\no n\r\nv 0 0 0\r\nv 2 0 0 1\r\nv 2 2 0 1 0 0\r\nv 1 .5 0\r\nv 0 2 "
                    "0\r\nv 0 0 0\r\nvn 0 0 1\r\n"
                    "vt 0 0\r\nf 1/1/1 2/1/1 3/1/1 \\\r\n4/1/1 5/1/1\r\nf -1//-1 -2//-1 -3//-1\nl 1 2\nf 2 6 "
                    "3\nf 1 2 6\n"});
    list.push_back(
        {"p.off",
         "COFF # c\n7 4 0\n0 0 0 1 0 0 1\n4 0 0 1 0 0 1\n4 4 0 1 0 0 1\n0 4 0 1 0 0 1\n1 1 0 1 0 0 1\n"
         "3 1 0 1 0 0 1\n0 0 4 1 0 0 1\n8 0 1 2 3 0 4 5 4 0 0 0\n3 0 1 6 1\n3 0 2 1\n3 6 1 2\n"});
    list.push_back({"p.csv", "\"x\";\"Y\";id;z\n0;1;2;3\n4;5;6;7.5e-1\n"});
    list.push_back({"no_name", "# c\n1 2 3\n-4 5e0 6\n"});
    return list;
  }();
  return all;
}

const std::vector<std::string>& words() {
  using namespace std::string_literals;
  static const std::vector<std::string> all = {"nan",
                                               "inf",
                                               "-inf",
                                               "-nan(ind)",
                                               "1e999",
                                               "-1e999",
                                               "1e-999",
                                               "1e308",
                                               "1e100",
                                               "1e101",
                                               "-0",
                                               "0",
                                               "1",
                                               "2",
                                               "3",
                                               "4",
                                               "-1",
                                               "-2",
                                               "99",
                                               "255",
                                               "256",
                                               "65536",
                                               "2147483647",
                                               "2147483648",
                                               "4294967295",
                                               "4294967296",
                                               "9223372036854775807",
                                               "18446744073709551616",
                                               "1.5",
                                               "0,5",
                                               ".",
                                               "-",
                                               "+",
                                               "+1",
                                               "1/1/1",
                                               "1//1",
                                               "/",
                                               "//",
                                               "\\\n",
                                               "\\",
                                               "#",
                                               "\n",
                                               "\r",
                                               "\r\n",
                                               ";",
                                               ",",
                                               "\t",
                                               "\"",
                                               "\0"s,
                                               "\0\0\0\0"s,
                                               "\xFF\xFF\xFF\xFF",
                                               "\xFF",
                                               "v",
                                               "vn",
                                               "f",
                                               "l",
                                               "p",
                                               "g",
                                               "OFF",
                                               "4OFF",
                                               "NOFF",
                                               "ply\n",
                                               "format ascii 1.0\n",
                                               "format binary_little_endian 1.0\n",
                                               "format binary_big_endian 1.0\n",
                                               "element vertex 3\n",
                                               "element vertex 4000000000\n",
                                               "element face 1\n",
                                               "element edge 2\n",
                                               "element tristrips 1\n",
                                               "property float x\n",
                                               "property double nx\n",
                                               "property list uchar int vertex_indices\n",
                                               "property list uint double more\n",
                                               "list",
                                               "uchar",
                                               "int",
                                               "float",
                                               "double",
                                               "comment\n",
                                               "end_header\n",
                                               "solid",
                                               "endsolid\n",
                                               "facet normal 0 0 1\n",
                                               "outer loop\n",
                                               "vertex 0 0 0\n",
                                               "endloop\n",
                                               "endfacet\n",
                                               "x,y,z\n",
                                               "nx",
                                               "\xEF\xBB\xBF"};
  return all;
}

class Damage {
 public:
  explicit Damage(std::uint64_t number) : random_(number) {}

  Seed input() {
    Seed file = one_of(seeds());
    for (Index left = 1 + random_.index(3) / 2; left > 0; --left) damage(file.bytes);
    if (random_.index(30) == 0) file.name = one_of(seeds()).name;
    if (file.bytes.size() > 3000) file.bytes.resize(3000);
    return file;
  }

 private:
  void damage(std::string& bytes) {
    const Index kind = random_.index(9);
    const std::size_t here = place(bytes);
    switch (kind) {
      case 0: {  // One bit.
        const int bit = static_cast<int>(random_.index(8));
        if (!bytes.empty()) bytes[here] = static_cast<char>(bytes[here] ^ (1 << bit));
        break;
      }
      case 1:  // Any byte.
        bytes.insert(here, 1, static_cast<char>(random_.index(256)));
        break;
      case 2:  // A piece is gone.
        bytes.erase(here, 1 + static_cast<std::size_t>(random_.index(20)));
        break;
      case 3: {  // A piece is there twice.
        const std::string piece = bytes.substr(here, 1 + static_cast<std::size_t>(random_.index(60)));
        bytes.insert(place(bytes), piece);
        break;
      }
      case 4: {  // The end of another file.
        const std::string& other = one_of(seeds()).bytes;
        bytes = bytes.substr(0, here) + other.substr(place(other));
        break;
      }
      case 5:  // A word where it may not belong.
        bytes.insert(here, one_of(words()));
        break;
      case 6:  // A word in place of another.
      case 7: {
        const auto blank = [](char c) { return c == ' ' || c == '\n' || c == ',' || c == '/'; };
        std::size_t begin = here, end = here;
        while (begin > 0 && !blank(bytes[begin - 1])) --begin;
        while (end < bytes.size() && !blank(bytes[end])) ++end;
        bytes.replace(begin, end - begin, random_.index(2) == 0 ? one_of(words()) : number());
        break;
      }
      case 8:  // Cut short, but not always; or eight bytes of anything.
        if (random_.index(3) == 0) {
          bytes.resize(here);
        } else {
          const double any = std::bit_cast<double>(random_.bits());
          for (std::size_t k = 0; k < 8 && here + k < bytes.size(); ++k)
            bytes[here + k] = reinterpret_cast<const char*>(&any)[k];
        }
        break;
    }
  }

  std::string number() {
    switch (random_.index(4)) {
      case 0:
        return std::to_string(random_.index(9) - 3);
      case 1:
        return to_text(random_.uniform(-2, 2), 3);
      case 2:
        return to_text(std::bit_cast<double>(random_.bits()), 17);
      default:
        return to_text(random_.normal(), 17);
    }
  }

  template <class Item>
  const Item& one_of(const std::vector<Item>& items) {
    return items[static_cast<std::size_t>(random_.index(static_cast<Index>(items.size())))];
  }
  std::size_t place(const std::string& bytes) {
    return bytes.empty() ? 0 : static_cast<std::size_t>(random_.index(static_cast<Index>(bytes.size())));
  }

  Random random_;
};

long setting(const char* name, long usual) {
  const char* value = std::getenv(name);
  return value ? std::atol(value) : usual;
}

// What every mesh that was read keeps, whatever the file was like.
void expect_sound(const LoadedMesh& loaded, long number) {
  const TriangleMesh& mesh = loaded.mesh;
  ASSERT_TRUE(mesh.vertices.allFinite()) << number;
  const MeshReport report = check_mesh(mesh);
  ASSERT_GT(report.faces, 0) << number;
  ASSERT_EQ(report.unused_vertices, 0) << number;
  ASSERT_FALSE(std::isnan(report.area)) << number;
  if (report.manifold && loaded.repairs.one_sided == 0) {
    ASSERT_TRUE(report.oriented) << number;
  }
  if (report.closed && report.manifold && report.oriented) {
    ASSERT_GE(report.genus, 0) << number;
  }
  if (mesh.has_normals()) {
    ASSERT_LT((mesh.normals.colwise().norm().array() - 1).abs().maxCoeff(), 1e-12) << number;
  }
  ASSERT_TRUE(vertex_normals(mesh).allFinite()) << number;
  self_intersections(mesh);
  // What is repaired needs no more repairs.
  const MeshRepairs again = repair(mesh).repairs;
  ASSERT_EQ(again.unused_vertices + again.degenerate_faces + again.duplicate_faces + again.turned_faces, 0)
      << number;
}

TEST(MeshFuzz, WithoutDamageAllAreRead) {
  for (const Seed& file : seeds()) EXPECT_NO_THROW(parse_model(file.bytes, file.name)) << file.bytes;
}

TEST(MeshFuzz, DamagedFilesAreReadOrRefusedAndNothingElse) {
  const long first = setting("SEESAW_FUZZ_FIRST", 0);
  const long count = setting("SEESAW_FUZZ_COUNT", 100'000);
  long meshes = 0, clouds = 0;
  for (long number = first; number < first + count; ++number) {
    const Seed file = Damage(static_cast<std::uint64_t>(number)).input();
    try {
      const Model model = parse_model(file.bytes, file.name);
      if (const auto* loaded = std::get_if<LoadedMesh>(&model)) {
        ++meshes;
        expect_sound(*loaded, number);
        if (HasFatalFailure()) return;
      } else {
        ++clouds;
        const PointCloud& cloud = std::get<PointCloud>(model);
        ASSERT_TRUE(cloud.points.allFinite()) << number;
        ASSERT_TRUE(cloud.normals.cols() == 0 || cloud.has_normals()) << number;
        for (Index i = 0; i < cloud.normals.size(); ++i)
          ASSERT_FALSE(std::isinf(cloud.normals.data()[i])) << number;
      }
    } catch (const FileError& error) {
      const std::string what = error.what();
      ASSERT_LT(what.size(), 300u) << number;
      ASSERT_LE(error.line(), 1 + std::count_if(file.bytes.begin(), file.bytes.end(),
                                                [](char c) { return c == '\n' || c == '\r'; }))
          << number;
      for (const char c : what) ASSERT_TRUE(c >= ' ' && c <= '~') << number << ": " << what;
    } catch (const std::exception& error) {
      FAIL() << "input " << number << ": not a FileError: " << error.what() << "\n" << file.bytes;
    }
  }
  // Damage that is always fatal, or never, would test little.
  if (count >= 1000) {
    EXPECT_GT(meshes, count / 20);
    EXPECT_GT(clouds, count / 30);
    EXPECT_LT(meshes + clouds, 3 * count / 4);
  }
  RecordProperty("meshes", std::to_string(meshes));
  RecordProperty("clouds", std::to_string(clouds));
}

}  // namespace
}  // namespace seesaw
