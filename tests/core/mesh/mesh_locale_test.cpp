// A decimal comma in the locale changes nothing in a file, neither way.
#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>
#include <utility>

#include "core/base/file.h"
#include "core/mesh/mesh_file.h"
#include "tests/core/mesh/test_meshes.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

void expect_the_same_as_ever() {
  TriangleMesh mesh = moved(sphere_mesh(1), 1234.5678, {0.25, -1.5e-7, 1e6});
  mesh.normals = sphere_mesh(1).vertices;
  for (const char* ending : {".obj", ".ply", ".off", ".stl"}) {
    const std::string bytes = mesh_bytes(mesh, ending, {.text = true});
    EXPECT_EQ(bytes.find(','), bytes.starts_with("# ") ? bytes.find(", ") : std::string::npos) << ending;
    const TriangleMesh again = std::get<LoadedMesh>(parse_model(bytes, std::string("m") + ending)).mesh;
    if (std::string(ending) != ".stl") {
      EXPECT_EQ(again.vertices, mesh.vertices) << ending;
    }
    EXPECT_EQ(again.faces.cols(), mesh.faces.cols()) << ending;
  }
  for (const char* ending : {".xyz", ".pwn", ".csv", ".ply"}) {
    const PointCloud cloud{mesh.vertices, mesh.normals};
    const std::string bytes = point_cloud_bytes(cloud, ending, {.text = true});
    const PointCloud again = std::get<PointCloud>(parse_model(bytes, std::string("c") + ending));
    EXPECT_EQ(again.points, cloud.points) << ending;
    EXPECT_EQ(again.normals, cloud.normals) << ending;
  }
  const auto x = [](const std::string& text, const char* name) {
    return std::get<PointCloud>(parse_model(text, name)).points(0, 0);
  };
  EXPECT_EQ(x("v 1234.5 0 0\n", "m.obj"), 1234.5);
  EXPECT_EQ(x("OFF 1 0\n1234.5 0 0\n", "m.off"), 1234.5);
  EXPECT_EQ(x("1234.5;0;0\n", "m.csv"), 1234.5);
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(MeshLocale, ALocaleOfTheStreamsChangesNothing) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  expect_the_same_as_ever();
  std::locale::global(before);
}

/// Makes a locale with a decimal comma, which setlocale finds by the path LOCPATH.
bool make_locale(const std::filesystem::path& folder) {
  write_file(folder / "comma.source",
             "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \"\"\ngrouping -1\nEND LC_NUMERIC\n");
  // Warnings that the other categories are missing count as failure: whether it worked, setlocale will say.
  const std::string command =
      "cd '" + folder.string() + "' && localedef -c -f UTF-8 -i comma.source ./comma >/dev/null 2>&1";
  return std::system(command.c_str()) != -1;
}

TEST(MeshLocale, ALocaleOfTheProgramChangesNothing) {
  const ScratchFolder folder;
  ::setenv("LOCPATH", folder.path().c_str(), 1);
  const bool made = make_locale(folder.path()) && std::setlocale(LC_NUMERIC, "comma");
  if (made) {
    EXPECT_STREQ(std::localeconv()->decimal_point, ",");
    expect_the_same_as_ever();
    // By Assimp too: Collada is text.
    write_file(folder / "m.dae", R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0.5 0 0 1.25 0 0 0 1.75 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
    const TriangleMesh mesh = read_mesh(folder / "m.dae").mesh;
    EXPECT_EQ(mesh.vertices.rowwise().maxCoeff(), Point<3>(1.25, 1.75, 0));
  }
  std::setlocale(LC_NUMERIC, "C");
  ::unsetenv("LOCPATH");
  if (!made) GTEST_SKIP() << "localedef makes no locale here";
}

}  // namespace
}  // namespace seesaw
