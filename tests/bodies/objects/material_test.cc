#include "somato/bodies/material.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/files/toml_file.h"

namespace somato {
namespace {

Result<std::vector<Material>> materials_of(const std::string& text) {
  const auto file = parse_toml(text, "mine.toml");
  EXPECT_TRUE(file);
  return read_materials(*file);
}

void expect_refused(const std::string& text, const std::string& where, const std::string& word) {
  const auto refused = materials_of(text);
  ASSERT_FALSE(refused) << text;
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(refused.error().where, where);
  EXPECT_NE(refused.error().what.find(word), std::string::npos) << refused.error().what;
}

TEST(Material, FourOfTheDeclaredAreSoftAndFourHard) {
  const auto& all = declared_materials();
  ASSERT_EQ(all.size(), 8U);
  const auto soft =
      std::count_if(all.begin(), all.end(), [](auto& m) { return m.hardness == Hardness::kSoft; });
  EXPECT_EQ(soft, 4);
}

TEST(Material, EverySoftOneGivesWayMoreThanEveryHardOne) {
  double stiffest_soft = 0.0;
  double softest_hard = 1e9;
  for (const Material& material : declared_materials()) {
    double& edge = material.hardness == Hardness::kSoft ? stiffest_soft : softest_hard;
    edge = material.hardness == Hardness::kSoft ? std::max(edge, material.stiffness)
                                                : std::min(edge, material.stiffness);
  }
  EXPECT_LT(stiffest_soft, softest_hard);
}

TEST(Material, KeysThatAreLeftOutKeepTheirDefaults) {
  const auto read = materials_of("[material.cork]\nhardness = \"soft\"\ndensity = 200\n");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 1U);
  const Material& cork = read->front();
  EXPECT_EQ(cork.name, "cork");
  EXPECT_EQ(cork.hardness, Hardness::kSoft);
  EXPECT_EQ(cork.density, 200.0);
  EXPECT_EQ(cork.friction, Material{}.friction);
  EXPECT_EQ(cork.hurst, Material{}.hurst);
}

TEST(Material, ATaxelMeetsTheStiffnessOfTheTipUnlessItHasItsOwn) {
  const auto read = materials_of(
      "[material.a]\nstiffness = 7\n[material.b]\nstiffness = 7\ntouch_stiffness = 2\n");
  ASSERT_TRUE(read);
  EXPECT_EQ((*read)[0].stiffness_under_taxel(), 7.0);
  EXPECT_EQ((*read)[1].stiffness_under_taxel(), 2.0);
}

TEST(Material, WhatCannotBeIsRefusedWithItsPlace) {
  expect_refused("[material.a]\ndensity = 0\n", "mine.toml:2", "density");
  expect_refused("[material.a]\nroughness = -1\n", "mine.toml:2", "roughness");
  expect_refused("[material.a]\nhurst = 1.5\n", "mine.toml:2", "hurst");
  expect_refused("[material.a]\ncolour = 3\n", "mine.toml:2", "colour");
  expect_refused("[material.a]\nweave_period = 2.0\n", "mine.toml:1", "weave");
  expect_refused("[material.a]\nweave_height = 2.0\n", "mine.toml:1", "weave");
  expect_refused("material = 3\n", "mine.toml:1", "must be a table");
  expect_refused("[material]\ndensity = 3\n", "mine.toml:2", "must be a table");
}

// As the reference of keys says.
TEST(Material, RidgesOfAWeaveLieAtMostTenCentimetresApart) {
  const std::string weave = "[material.a]\nweave_height = 9\nweave_period = ";
  EXPECT_TRUE(materials_of(weave + "100"));
  expect_refused(weave + "100.5", "mine.toml:3", "weave_period");
}

TEST(Material, AFileWithoutMaterialsHasNone) {
  const auto read = materials_of("[object.ball]\nshape = \"sphere\"\n");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->empty());
}

TEST(Material, AnUnknownNameIsAnsweredWithTheNearest) {
  ASSERT_TRUE(find_material(declared_materials(), "felt"));
  const auto unknown = find_material(declared_materials(), "fel");
  ASSERT_FALSE(unknown);
  EXPECT_NE((unknown.error().what + unknown.error().advice).find("'felt'"), std::string::npos);
}

TEST(Material, SaysWhatIsKnownOfItsExplorations) {
  const Material sponge = find_material(declared_materials(), "sponge").value();
  EXPECT_EQ(labels_of(sponge, 4),
            (std::vector<Label>{{"material", "sponge"}, {"hardness", "soft"}, {"trial", "5"}}));
}

}  // namespace
}  // namespace somato
