#pragma once

#include <string>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// The values that a metric can have.
enum class MetricRange {
  kShare,     ///< 0 to 1.
  kSigned,    ///< -1 to 1.
  kSamples,   ///< 0 to the number of samples.
  kClasses,   ///< 0 to the number of classes.
  kFromZero,  ///< From 0, without an upper end that is known beforehand.
};

/// The values of a metric that are better than others.
enum class MetricDirection { kHigher, kLower, kNeither };

/// One metric of studies; docs/reference/results.md defines it.
struct MetricInfo {
  std::string name;
  std::string words;  ///< The name as the report shows it.
  MetricRange range;
  MetricDirection better;
  bool in_run_table;  ///< Whether the table of `somato run` has a row of it.
};

/// All metrics, in the order in which tables show them: the rows of metrics.inc.
const std::vector<MetricInfo>& metric_table();

/// The row of a metric, whose name may have the prefix of a label or of altered explorations, and
/// the suffix "_chance" or "_after_N"; nullptr if no study provides it, and for "mapped_with A B",
/// which has no row.
const MetricInfo* find_metric_info(const std::string& name);

/// Refuses (kUsage, with the nearest name) names of metrics that no study provides. Valid names:
/// "accuracy", the same for another label as "shape.accuracy" or of wrong groupings as
/// "accuracy_chance", "mapped_with A B".
Result<void> check_metric_name(const std::string& name, const std::string& where);

}  // namespace somato
