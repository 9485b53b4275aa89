#include "studies/results/metric_names.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(MetricNames, HoldThoseOfOtherLabelsAndOfWrongGroupings) {
  for (const char* name :
       {"accuracy", "shape.accuracy", "accuracy_chance", "a.b.order_around_chance",
        "mapped_with boccia boule", "winner_shared_within_class", "order_along_chance",
        "right_size_wrong_group", "cosine_between_classes"}) {
    EXPECT_TRUE(check_metric_name(name, "a.toml:3")) << name;
  }
}

TEST(MetricNames, RefuseOthersWithTheNearest) {
  for (const char* name : {"acuracy", "shape.acuracy", "acuracy_chance"}) {
    const auto known = check_metric_name(name, "a.toml:3");
    ASSERT_FALSE(known) << name;
    EXPECT_EQ(known.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(known.error().where, "a.toml:3");
    EXPECT_EQ(known.error().what, "unknown metric 'acuracy'");
    EXPECT_EQ(known.error().advice, "did you mean 'accuracy'?");
  }
}

}  // namespace
}  // namespace somato
