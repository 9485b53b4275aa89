#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "studies/results/metric_table.h"

namespace somato::testing {

/// Fails the test if one of the metrics or readings that a study produces is not in the table of
/// metrics.
template <typename Named>
void expect_known_metrics(const std::vector<Named>& produced) {
  for (const Named& metric : produced) {
    EXPECT_TRUE(check_metric_name(metric.name, {})) << metric.name;
  }
}

}  // namespace somato::testing
