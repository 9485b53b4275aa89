#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <filesystem>

#include "base/support/temporary_folder.h"
#include "bodies/support/object_tables.h"

namespace somato {
namespace {

using Size = std::array<double, 3>;

class MeshFile : public ::testing::Test {
 protected:
  Result<ObjectTable> read(const std::string& file, const std::string& more = "") const {
    const std::string table = folder_.with(
        "things.toml", fmt::format("[object]\ncup = {{ shape = \"mesh\", file = \"{}\", "
                                   "material = \"wood\"{} }}\n",
                                   file, more));
    return read_object_table(table, declared());
  }

  std::string error_of(const std::string& file, ErrorKind kind) const {
    const auto table = read(file);
    if (table) return "none";
    EXPECT_EQ(table.error().kind, kind) << file;
    EXPECT_EQ(table.error().where, folder_.file("things.toml") + ":2");
    return to_string(table.error());
  }

  TemporaryFolder folder_;
};

TEST_F(MeshFile, LiesBesideTheTable) {
  std::filesystem::create_directory(folder_.file("meshes"));
  folder_.with("meshes/cup.STL", "solid");
  for (const std::string& file :
       {std::string("meshes/cup.STL"), std::string("./meshes/../meshes/cup.STL"),
        folder_.file("meshes/cup.STL")}) {
    const auto table = read(file);
    ASSERT_TRUE(table) << to_string(table.error());
    const Object& cup = table->objects.at(0);
    EXPECT_EQ(cup.mesh_file, folder_.file("meshes/cup.STL"));
    EXPECT_EQ(cup.mesh_scale, 1.0);
    EXPECT_EQ(cup.size, (Size{0, 0, 0}));
    EXPECT_EQ(cup.mass, 0.0);
  }
}

TEST_F(MeshFile, MayHaveAScaleAndAMass) {
  folder_.with("cup.obj", "v 0 0 0");
  const auto table = read("cup.obj", ", scale = 25.4, mass = 0.2");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->objects.at(0).mesh_scale, 25.4);
  EXPECT_EQ(table->objects.at(0).mass, 0.2);
  EXPECT_FALSE(read("cup.obj", ", scale = 0"));
  EXPECT_FALSE(read("cup.obj", ", scale = 1001"));
}

TEST_F(MeshFile, ThatCannotBeReadIsRefused) {
  folder_.with("cup.ply", "ply");
  folder_.with("empty.stl", "");
  std::filesystem::create_directory(folder_.file("folder.stl"));
  ASSERT_EQ(::mkfifo(folder_.file("pipe.stl").c_str(), 0600), 0);
  expect_says(error_of("missing.stl", ErrorKind::kSystem),
              {"missing.stl", "the folder of the table"});
  expect_says(error_of("cup.ply", ErrorKind::kUsage), {"'cup.ply' is not a mesh", ".stl or .obj"});
  expect_says(error_of("", ErrorKind::kUsage), {"not a mesh"});
  expect_says(error_of("empty.stl", ErrorKind::kData), {"is empty"});
  expect_says(error_of("folder.stl", ErrorKind::kData), {"is not a regular file"});
  expect_says(error_of("pipe.stl", ErrorKind::kData), {"is not a regular file"});
}

TEST_F(MeshFile, OfMoreThan64MiBIsRefused) {
  constexpr std::uintmax_t kMost = std::uintmax_t{64} << 20;
  folder_.with("large.stl", "");
  std::filesystem::resize_file(folder_.file("large.stl"), kMost);
  EXPECT_TRUE(read("large.stl"));
  std::filesystem::resize_file(folder_.file("large.stl"), kMost + 1);
  expect_says(error_of("large.stl", ErrorKind::kData), {"large.stl"});
}

}  // namespace
}  // namespace somato
