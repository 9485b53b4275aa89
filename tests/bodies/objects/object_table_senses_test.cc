#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "base/core/contains.h"
#include "base/support/places.h"
#include "bodies/support/object_tables.h"

namespace somato {
namespace {

// All that a sense can perceive of an object that is fixed or as heavy as the others.
auto felt_by_hand(const Object& object) {
  return std::tuple(object.shape, object.size, object.material.friction, object.material.density,
                    object.mass, object.material.stiffness_under_taxel());
}
auto sound_of(const Object& object) {
  return object.material.name;  // each material has heights of its own
}
auto pressed(const Object& object) {
  return object.material.stiffness;
}

auto surface(const Material& material) {
  return std::tuple(material.friction, material.loss, material.roughness,
                    material.correlation_length, material.hurst, material.weave_period,
                    material.weave_height);
}

ObjectTable all_senses() {
  return own_object_table("all_senses", declared()).value();
}

template <typename Perceived>
std::size_t distinguished(const std::vector<Object>& objects, Perceived perceived) {
  std::set<decltype(perceived(objects.front()))> found;
  for (const Object& object : objects) found.insert(perceived(object));
  return found.size();
}

TEST(AllSensesObjects, NoSingleSenseDistinguishesThem) {
  const std::vector<Object> objects = all_senses().objects;
  ASSERT_EQ(objects.size(), 24U);
  EXPECT_EQ(distinguished(objects, felt_by_hand), 8U);  // 4 forms, soft or hard
  EXPECT_EQ(distinguished(objects, sound_of), 6U);
  EXPECT_EQ(distinguished(objects, pressed), 2U);
}

TEST(AllSensesObjects, TwoProbesDoNotDistinguishThemButAllSensesDo) {
  const std::vector<Object> objects = all_senses().objects;
  const auto by_probes = [](const Object& object) {
    return std::tuple(sound_of(object), pressed(object));
  };
  const auto by_all = [](const Object& object) {
    return std::tuple(felt_by_hand(object), sound_of(object), pressed(object));
  };
  EXPECT_EQ(distinguished(objects, by_probes), 6U);
  EXPECT_EQ(distinguished(objects, by_all), 24U);
}

TEST(AllSensesObjects, SurfaceAndHardnessVaryIndependently) {
  const std::vector<Material> materials = all_senses().materials;
  ASSERT_EQ(materials.size(), 6U);
  const auto count = [&](const Material& one, bool same_surface, bool same_stiffness) {
    return std::count_if(materials.begin(), materials.end(), [&](const Material& other) {
      return (surface(one) == surface(other)) == same_surface &&
             (one.stiffness == other.stiffness) == same_stiffness;
    });
  };
  for (const Material& material : materials) {
    EXPECT_EQ(count(material, true, false), 1) << material.name;
    EXPECT_EQ(count(material, false, true), 2) << material.name;
    EXPECT_EQ(material.hardness == Hardness::kSoft, material.stiffness < 20.0) << material.name;
  }
}

TEST(AllSensesObjects, HaveSizesOfWhichTheHandHoldsSmallerAndLarger) {
  for (const Object& object : all_senses().objects) {
    EXPECT_GT(object.size[0], 40.0) << object.name;
    EXPECT_LT(object.size[0], 80.0) << object.name;
    EXPECT_EQ(object.size[0], object.size[1]) << object.name;
    EXPECT_EQ(object.size[2], 140.0) << object.name;
  }
}

TEST(OwnObjectTables, AreListedAndRead) {
  const std::vector<std::string> names = own_object_tables();
  EXPECT_EQ(names,
            (std::vector<std::string>{"all_senses", "lucs2", "lucs3", "lucs3_new", "lucs3_sides"}));
  for (const std::string& name : names) EXPECT_TRUE(own_object_table(name, declared())) << name;
}

TEST(OwnObjectTables, AreFoundByNameAndFilesByPath) {
  const auto own = find_object_table("lucs3_new", declared());
  const auto file = find_object_table(source_path("objects/lucs3_new.toml"), declared());
  ASSERT_TRUE(own);
  ASSERT_TRUE(file);
  ASSERT_EQ(own->objects.size(), file->objects.size());
  EXPECT_EQ(own->objects.back().name, file->objects.back().name);
  const auto missing = find_object_table("lucs3_new.toml", declared());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kSystem);
  const auto unknown = find_object_table("lucs3_now", declared());
  ASSERT_FALSE(unknown);
  EXPECT_NE(to_string(unknown.error()).find("lucs3_new"), std::string::npos);
}

}  // namespace
}  // namespace somato
