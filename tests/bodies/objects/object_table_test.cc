#include "somato/bodies/object_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/files/toml_file.h"

#include <numbers>

#include "bodies/support/object_tables.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr double kPi = std::numbers::pi;

Result<ObjectTable> parse(const std::string& text) {
  return parse_object_table(text, "t.toml", declared());
}

Object only_object(const std::string& line) {
  const auto table = parse("[object]\nit = " + line);
  if (!table) {
    ADD_FAILURE() << to_string(table.error());
    return {};
  }
  EXPECT_EQ(table->objects.size(), 1U);
  return table->objects.at(0);
}

std::string error_of(const std::string& text, ErrorKind kind = ErrorKind::kUsage) {
  const auto table = parse(text);
  if (table) return "none";
  EXPECT_EQ(table.error().kind, kind);
  return to_string(table.error());
}

std::string error_of_object(const std::string& line) {
  return error_of("[object]\nit = " + line);
}

using Size = std::array<double, 3>;

TEST(ObjectTable, EveryShapeHasItsOwnKeys) {
  EXPECT_EQ(only_object(R"({ shape = "sphere", diameter = 72, material = "wood" })").size,
            (Size{72, 72, 72}));
  EXPECT_EQ(
      only_object(R"({ shape = "cylinder", diameter = 62, height = 121, material = "wood" })").size,
      (Size{62, 62, 121}));
  EXPECT_EQ(only_object(
                R"({ shape = "block", width = 58, depth = 50.5, height = 110, material = "wood" })")
                .size,
            (Size{58, 50.5, 110}));
  EXPECT_EQ(
      only_object(
          R"({ shape = "ellipsoid", width = 58, depth = 50, height = 110, material = "wood" })")
          .size,
      (Size{58, 50, 110}));
  EXPECT_EQ(
      only_object(R"({ shape = "capsule", diameter = 40, height = 40, material = "wood" })").size,
      (Size{40, 40, 40}));
}

TEST(ObjectTable, TheDepthMayBeAShareOfTheWidth) {
  const auto with = [](const std::string& shape, const std::string& keys) {
    return fmt::format(R"({{ shape = "{}", {}, height = 110, material = "wood" }})", shape, keys);
  };
  EXPECT_EQ(only_object(with("block", "width = 80, depth_share = 0.75")).size, (Size{80, 60, 110}));
  EXPECT_EQ(only_object(with("ellipsoid", "width = 80, depth_share = 1.0")).size,
            (Size{80, 80, 110}));
  expect_says(error_of_object(with("block", "width = 80, depth = 60, depth_share = 0.75")),
              {"the depth is given twice", "either 'depth' or 'depth_share'"});
  for (const char* share : {"0.0", "1.01", "nan"}) {
    const std::string keys = fmt::format("width = 80, depth_share = {}", share);
    expect_says(error_of_object(with("block", keys)), {"'depth_share' must be"});
  }
  expect_says(error_of_object(with("block", "width = 80, depth_share = \"automatic\"")),
              {"'depth' must be a number"});
  expect_says(error_of_object(with("cylinder", "diameter = 80, depth_share = 0.5")),
              {"key of a cylinder 'depth_share'"});
}

TEST(ObjectTable, AConeMayBeCutOff) {
  const Object pointed =
      only_object(R"({ shape = "cone", diameter = 60, height = 90, material = "wood" })");
  EXPECT_EQ(pointed.shape, Shape::kCone);
  EXPECT_EQ(pointed.size, (Size{60, 60, 90}));
  EXPECT_EQ(pointed.top_diameter, 0.0);
  const Object cut = only_object(
      R"({ shape = "cone", diameter = 60, height = 90, top_diameter = 60, material = "wood" })");
  EXPECT_EQ(cut.top_diameter, 60.0);
}

TEST(ObjectTable, MassComesOfVolumeAndDensityUnlessGiven) {
  EXPECT_DOUBLE_EQ(
      only_object(
          R"({ shape = "block", width = 50, depth = 50, height = 100, material = "metal" })")
          .mass,
      2.0);
  EXPECT_EQ(
      only_object(R"({ shape = "sphere", diameter = 72, material = "wood", mass = 0.31 })").mass,
      0.31);
}

TEST(ObjectTable, KeepsTheOrderOfTheText) {
  const auto table = parse(R"(
[object]
z = { shape = "sphere", diameter = 1, material = "wood" }
a = { shape = "sphere", diameter = 1000, material = "metal" }
[object.m]
shape = "sphere"
diameter = 3
material = "foam"
[material.foam]
hardness = "soft"
density = 30
)");
  ASSERT_TRUE(table) << to_string(table.error());
  ASSERT_EQ(table->objects.size(), 3U);
  EXPECT_EQ(table->objects[0].name, "z");
  EXPECT_EQ(table->objects[1].name, "a");
  EXPECT_EQ(table->objects[1].material.density, 8000.0);
  EXPECT_EQ(table->objects[2].name, "m");
  EXPECT_EQ(table->objects[2].material.hardness, Hardness::kSoft);
  EXPECT_NEAR(table->objects[2].mass, 30 * kPi / 6 * 27 * 1e-9, 1e-15);
  ASSERT_EQ(table->materials.size(), 1U);
  EXPECT_EQ(table->materials[0].name, "foam");
  EXPECT_EQ(table->materials[0].density, 30.0);
}

TEST(ObjectTable, MaterialsWithoutObjectsAreValid) {
  const auto table = parse("[material.felt]\n");
  ASSERT_TRUE(table);
  EXPECT_TRUE(table->objects.empty());
  EXPECT_EQ(table->materials.at(0).name, "felt");
}

TEST(ObjectTable, NothingIsNotEnough) {
  for (const char* text : {"", "# boccia\n", "[object]\n", "[material]\n[object]\n"}) {
    expect_says(error_of(text), {"t.toml", "neither objects nor materials"});
  }
}

TEST(ObjectTable, MisspeltTablesKeysAndNamesHaveTheNearestKnown) {
  expect_says(error_of("\n[objects]\n"), {"t.toml:2", "unknown table 'objects'", "'object'"});
  expect_says(error_of_object(R"({ shape = "spere", diameter = 72, material = "wood" })"),
              {"t.toml:2", "'shape'", "'sphere'"});
  expect_says(error_of_object(R"({ shape = "sphere", diametre = 72, material = "wood" })"),
              {"t.toml:2", "key of a sphere 'diametre'", "'diameter'"});
  expect_says(error_of_object(R"({ shape = "sphere", diameter = 72, material = "wod" })"),
              {"t.toml:2", "unknown material 'wod'", "'wood'"});
  expect_says(error_of("[material.felt]\n\nhardnes = \"soft\"\n"),
              {"t.toml:3", "unknown key 'hardnes'", "'hardness'"});
}

TEST(ObjectTable, AKeyOfAnotherShapeIsRefused) {
  expect_says(
      error_of_object(R"({ shape = "sphere", diameter = 7, width = 7, material = "wood" })"),
      {"t.toml:2", "key of a sphere 'width'"});
  expect_says(
      error_of_object(
          R"({ shape = "cylinder", diameter = 7, height = 7, top_diameter = 7, material = "wood" })"),
      {"key of a cylinder 'top_diameter'"});
  expect_says(
      error_of_object(R"({ shape = "sphere", diameter = 7, material = "wood", name = "x" })"),
      {"key of a sphere 'name'"});
}

TEST(ObjectTable, EveryNeededKeyIsMissedByName) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> shapes{
      {"sphere", {"diameter"}},
      {"cylinder", {"diameter", "height"}},
      {"block", {"width", "depth", "height"}},
      {"cone", {"diameter", "height"}},
      {"ellipsoid", {"width", "depth", "height"}},
      {"capsule", {"diameter", "height"}}};
  for (const auto& [shape, keys] : shapes) {
    std::string all = fmt::format(R"({{ shape = "{}", material = "wood")", shape);
    for (const std::string& left_out : keys) {
      std::string line = all;
      for (const std::string& key : keys) {
        if (key != left_out) line += fmt::format(", {} = 5", key);
      }
      expect_says(error_of_object(line + " }"), {"t.toml:2", shape, "'" + left_out + "'"});
      expect_says(error_of_object(line + fmt::format(", {} = \"automatic\" }}", left_out)),
                  {"t.toml:2", "'" + left_out + "' must be a number"});
    }
  }
  expect_says(error_of_object(R"({ shape = "sphere", diameter = 72 })"), {"'material'"});
  expect_says(error_of_object(R"({ diameter = 72, material = "wood" })"), {"'shape' is missing"});
  expect_says(error_of_object(R"({ shape = "mesh", material = "wood" })"), {"a mesh", "'file'"});
}

TEST(ObjectTable, SizesAreAboveZeroAndAtMostAMetre) {
  for (const char* size : {"0", "0.0", "-72", "1000.001", "nan", "inf", "-inf", "1e300",
                           "9223372036854775807", "\"72\"", "[72]", "true", "{ mm = 72 }"}) {
    const std::string line =
        fmt::format(R"({{ shape = "sphere", diameter = {}, material = "wood" }})", size);
    expect_says(error_of_object(line), {"t.toml:2", "'diameter' must be a"});
  }
  const std::string cone =
      R"({{ shape = "cone", diameter = 1000, height = 5, top_diameter = {}, material = "wood" }})";
  expect_says(error_of_object(fmt::format(fmt::runtime(cone), -1)), {"'top_diameter' must be"});
  EXPECT_EQ(only_object(fmt::format(fmt::runtime(cone), 1000)).top_diameter, 1000.0);
}

TEST(ObjectTable, MassesAreAboveZero) {
  for (const char* mass : {"0", "-0.1", "nan", "inf"}) {
    expect_says(error_of_object(fmt::format(
                    R"({{ shape = "sphere", diameter = 7, material = "wood", mass = {} }})", mass)),
                {"'mass' must be a number, 1e-06 to 10000"});
  }
}

TEST(ObjectTable, ImpossibleProportionsAreRefused) {
  expect_says(
      error_of_object(
          R"({ shape = "cone", diameter = 60, height = 9, top_diameter = 61, material = "wood" })"),
      {"t.toml:2", "61 mm", "60 mm"});
  expect_says(
      error_of_object(R"({ shape = "capsule", diameter = 60, height = 59, material = "wood" })"),
      {"t.toml:2", "59 mm", "60 mm"});
}

TEST(ObjectTable, NamesThatAreNone) {
  const std::string sphere = R"( = { shape = "sphere", diameter = 7, material = "wood" })";
  const std::string long_name(256, 'n');
  for (const std::string& name : {std::string(R"("")"), std::string(R"("a\nb")"), long_name}) {
    expect_says(error_of("[object]\n" + name + sphere), {"t.toml:2", "an object cannot be called"});
  }
  expect_says(error_of("[material.\"\"]\n"), {"t.toml:1", "a material cannot be called"});
  expect_says(error_of("[object]\na" + sphere + "\na" + sphere), {"t.toml:3", "'a'"});
}

TEST(ObjectTable, AMaterialOfADeclaredNameIsRefused) {
  expect_says(error_of("[material.wood]\ndensity = 5\n"),
              {"t.toml:1", "'wood' is declared already"});
}

TEST(ObjectTable, AMaterialWhoseNumbersDoNotFitEachOtherIsRefused) {
  expect_says(error_of("[material.cloth]\nweave_period = 1.0\n"), {"t.toml:1", "weave_height"});
}

TEST(ObjectTable, WhatIsNoTableIsRefused) {
  expect_says(error_of("object = 3\n"), {"t.toml:1", "'object' must be a table"});
  expect_says(error_of("[[object]]\nname = \"a\"\n"), {"t.toml:1", "'object' must be a table"});
  expect_says(error_of("material = [1]\n"), {"t.toml:1", "'material' must be a table"});
  expect_says(error_of("[object]\nboccia = 72\n"), {"t.toml:2", "'boccia' must be a table"});
  expect_says(error_of("[material]\nfelt = 0.3\n"), {"t.toml:2", "'felt' must be a table"});
  expect_says(error_of("[object]\nboccia = {\n"), {"t.toml:"});
}

TEST(ObjectTable, DamagedTextEndsInAnErrorOrATable) {
  const std::string whole =
      "[object]\na = { shape = \"cone\", diameter = 7, height = 9, material = \"f\" }\n"
      "[material.f]\ndensity = 30\n";
  Random random(1);
  int whole_tables = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = whole;
    const std::size_t place = random.below(text.size());
    text[place] = static_cast<char>(random.below(256));
    const auto table = parse(text);
    if (!table) {
      EXPECT_FALSE(table.error().what.empty());
      EXPECT_TRUE(table.error().where.starts_with("t.toml")) << table.error().where;
      continue;
    }
    ++whole_tables;
    for (const Object& object : table->objects) {
      EXPECT_GT(object.mass, 0.0);
      EXPECT_LE(object.size[0], 1000.0);
    }
  }
  EXPECT_GT(whole_tables, 10);
  EXPECT_LT(whole_tables, 2000);
}

TEST(ObjectTable, AMissingFileIsTheSystemsError) {
  const auto missing = read_object_table("no/such.toml", declared());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kSystem);
}

TEST(ObjectTable, IsReadFromATableOfAnotherFile) {
  const Table file =
      parse_toml(
          "[explore.material.cork]\nstiffness = 8.0\n[explore.object.stopper]\nshape = 'cylinder'\n"
          "diameter = 20\nheight = 30\nmaterial = 'cork'\n",
          "system.toml")
          .value();
  const Table* explore = table_in(file, "explore");
  ASSERT_NE(explore, nullptr);
  const auto read = object_table_of(*explore, "system.toml", {});
  ASSERT_TRUE(read) << to_string(read.error());
  ASSERT_EQ(read->objects.size(), 1U);
  EXPECT_EQ(read->objects[0].name, "stopper");
  EXPECT_EQ(read->materials[0].stiffness, 8.0);
  const auto wrong = object_table_of(
      parse_toml("[object.a]\nshape = 'spere'\n", "system.toml").value(), "system.toml", {});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().where, "system.toml:2");
}

}  // namespace
}  // namespace somato
