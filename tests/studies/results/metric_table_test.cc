#include "studies/results/metric_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "base/support/places.h"
#include "base/support/temporary_folder.h"

namespace somato {
namespace {

const MetricInfo& info_of(const std::string& name) {
  const MetricInfo* info = find_metric_info(name);
  if (info == nullptr) throw std::out_of_range(name);
  return *info;
}

TEST(MetricTable, HasEachNameOnceAndWordsForIt) {
  std::vector<std::string> names;
  for (const MetricInfo& metric : metric_table()) {
    EXPECT_FALSE(metric.words.empty()) << metric.name;
    names.push_back(metric.name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

// A prefix or a suffix would be removed from a name before it is compared with the rows.
TEST(MetricTable, FindsTheRowOfEachName) {
  for (const MetricInfo& metric : metric_table()) {
    EXPECT_EQ(find_metric_info(metric.name), &metric) << metric.name;
    EXPECT_EQ(find_metric_info("altered.half.shape." + metric.name + "_chance"), &metric);
    EXPECT_EQ(find_metric_info("shape." + metric.name + "_after_3"), &metric);
  }
  EXPECT_EQ(find_metric_info("acuracy"), nullptr);
  EXPECT_EQ(find_metric_info("mapped_with cube a.accuracy"), nullptr);
}

TEST(MetricTable, StatesWhichMetricsRunPrints) {
  EXPECT_EQ(metric_table().front().name, "accuracy");
  for (const char* name : {"accuracy", "unknown_auroc", "areas_connected", "topographic_error"}) {
    EXPECT_TRUE(info_of(name).in_run_table) << name;
  }
  for (const char* name : {"baseline_accuracy", "names_refused", "on_border"}) {
    EXPECT_FALSE(info_of(name).in_run_table) << name;
  }
}

TEST(MetricTable, HasTheRangeAndTheDirectionOfAMetric) {
  EXPECT_EQ(info_of("accuracy").range, MetricRange::kShare);
  EXPECT_EQ(info_of("forgetting").range, MetricRange::kSigned);
  EXPECT_EQ(info_of("classes_separated").range, MetricRange::kClasses);
  EXPECT_EQ(info_of("samples_ambiguous").range, MetricRange::kSamples);
  EXPECT_EQ(info_of("connected_parts").range, MetricRange::kFromZero);
  EXPECT_EQ(info_of("accuracy").better, MetricDirection::kHigher);
  EXPECT_EQ(info_of("quantization_error").better, MetricDirection::kLower);
  EXPECT_EQ(info_of("on_border").better, MetricDirection::kNeither);
}

// The reference names a metric that is measured after each of several names with "_after_K".
TEST(MetricTable, IsDocumented) {
  const std::string page = bytes_of(source_path("docs/reference/results.md"));
  for (const MetricInfo& metric : metric_table()) {
    const bool is_documented = page.find("`" + metric.name + "`") != std::string::npos ||
                               page.find("`" + metric.name + "_after_K`") != std::string::npos;
    EXPECT_TRUE(is_documented) << "docs/reference/results.md does not define " << metric.name;
  }
}

TEST(MetricName, HoldsThoseOfOtherLabelsAndOfWrongGroupings) {
  for (const char* name :
       {"accuracy", "shape.accuracy", "accuracy_chance", "a.b.order_around_chance",
        "mapped_with boccia boule", "winner_shared_within_class", "order_along_chance",
        "right_size_wrong_group", "cosine_between_classes"}) {
    EXPECT_TRUE(check_metric_name(name, "a.toml:3")) << name;
  }
}

TEST(MetricName, RefusesOthersWithTheNearest) {
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
