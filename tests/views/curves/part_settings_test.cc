#include "views/curves/part_settings.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

using detail::find_part;
using detail::type_of;

const std::vector<Settings> kSettings{{"study", {{"name", "\"a\""}}},
                                      {"module.map", {{"rows", "5"}, {"type", "\"som\""}}}};

TEST(PartSettings, AreFoundByTheirName) {
  EXPECT_EQ(find_part(kSettings, "module.map"), &kSettings[1]);
  EXPECT_EQ(find_part(kSettings, "module"), nullptr);
  EXPECT_EQ(find_part({}, "study"), nullptr);
}

TEST(PartSettings, OfAModuleNameItsType) {
  const ModuleType* type = type_of(kSettings[1]);
  ASSERT_NE(type, nullptr);
  EXPECT_EQ(type->name, "som");
  EXPECT_EQ(type_of(kSettings[0]), nullptr);
  EXPECT_EQ(type_of({"module.x", {{"type", "\"none such\""}}}), nullptr);
}

}  // namespace
}  // namespace somato
