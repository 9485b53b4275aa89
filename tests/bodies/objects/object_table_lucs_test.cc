#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "bodies/support/object_tables.h"

namespace somato {
namespace {

TEST(Lucs2Objects, AreThoseOfTableOne) {
  const auto objects = lucs2_objects(declared());
  ASSERT_TRUE(objects) << to_string(objects.error());
  std::vector<std::string> lines;
  for (const Object& o : *objects) {
    lines.push_back(fmt::format("{} {} {}x{}x{} {}", o.name, choice_name(o.shape), o.size[0],
                                o.size[1], o.size[2], o.material.name));
  }
  EXPECT_EQ(lines,
            (std::vector<std::string>{
                "boccia sphere 72x72x72 plastic", "boule sphere 82x82x82 metal",
                "cylinder cylinder 62x62x121 hard_board", "metal_cylinder cylinder 75x75x109 metal",
                "block_1 block 50x50x110 wood", "block_2 block 58x50x110 wood"}));
}

void expect_counts(const std::vector<Object>& objects, std::ptrdiff_t each) {
  std::ptrdiff_t cylinders = 0;
  std::ptrdiff_t blocks = 0;
  for (const Object& object : objects) {
    cylinders += object.shape == Shape::kCylinder ? 1 : 0;
    blocks += object.shape == Shape::kBlock ? 1 : 0;
    EXPECT_GE(object.size[0], object.size[1]) << object.name;  // the wider side to the palm
    EXPECT_GE(object.size[2], 120.0) << object.name;
    EXPECT_LE(object.size[2], 150.0) << object.name;
  }
  EXPECT_EQ(cylinders, each);
  EXPECT_EQ(blocks, each);
}

std::pair<double, double> widths(const std::vector<Object>& objects, Shape shape) {
  std::pair<double, double> widths{1000.0, 0.0};
  for (const Object& object : objects) {
    if (object.shape != shape) continue;
    widths.first = std::min(widths.first, object.size[0]);
    widths.second = std::max(widths.second, object.size[0]);
  }
  return widths;
}

TEST(Lucs3Objects, SpanTheHand) {
  const auto objects = lucs3_objects(declared());
  ASSERT_TRUE(objects) << to_string(objects.error());
  expect_counts(*objects, 5);
  EXPECT_EQ(widths(*objects, Shape::kCylinder), (std::pair{40.0, 80.0}));
  EXPECT_EQ(widths(*objects, Shape::kBlock), (std::pair{50.0, 90.0}));
}

TEST(Lucs3Objects, TheNewOnesLieBetweenAndAreOthers) {
  const auto objects = lucs3_objects(declared()).value();
  const auto fresh = lucs3_new_objects(declared());
  ASSERT_TRUE(fresh) << to_string(fresh.error());
  expect_counts(*fresh, 3);
  for (const Object& one : *fresh) {
    const auto [least, most] = widths(objects, one.shape);
    EXPECT_GT(one.size[0], least);
    EXPECT_LT(one.size[0], most);
    for (const Object& other : objects) {
      EXPECT_NE(one.name, other.name);
      EXPECT_FALSE(one.shape == other.shape && one.size[0] == other.size[0]) << one.name;
    }
  }
}

TEST(Lucs2Objects, AMissingMaterialIsNamed) {
  const auto objects = lucs2_objects(std::span(declared()).first(1));
  ASSERT_FALSE(objects);
  expect_says(to_string(objects.error()), {"objects/lucs2.toml:4", "'metal'"});
}

}  // namespace
}  // namespace somato
