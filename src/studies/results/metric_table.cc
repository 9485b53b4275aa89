#include "studies/results/metric_table.h"

#include <algorithm>
#include <string_view>

#include "somato/core/parameter.h"

namespace somato {
namespace {

constexpr std::string_view kChanceSuffix = "_chance";
constexpr std::string_view kMappedWith = "mapped_with ";
constexpr std::string_view kAfter = "_after_";

// The name without prefixes and suffixes.
std::string plain_metric_name(const std::string& name) {
  std::string plain = name.substr(name.rfind('.') + 1);  // npos + 1 is 0
  if (plain.ends_with(kChanceSuffix)) plain.resize(plain.size() - kChanceSuffix.size());
  return plain.substr(0, plain.find(kAfter));
}

bool is_mapped_with(const std::string& name) {
  return name.find(kMappedWith) != std::string::npos;
}

std::vector<std::string> names_of_metrics() {
  std::vector<std::string> names;
  for (const MetricInfo& metric : metric_table()) names.push_back(metric.name);
  return names;
}

}  // namespace

const std::vector<MetricInfo>& metric_table() {
  using enum MetricRange;
  using enum MetricDirection;
  static const std::vector<MetricInfo> rows{
#include "studies/results/metrics.inc"
  };
  return rows;
}

const MetricInfo* find_metric_info(const std::string& name) {
  if (is_mapped_with(name)) return nullptr;
  const std::string plain = plain_metric_name(name);
  const auto& rows = metric_table();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const MetricInfo& metric) { return metric.name == plain; });
  return found == rows.end() ? nullptr : &*found;
}

Result<void> check_metric_name(const std::string& name, const std::string& where) {
  if (is_mapped_with(name) || find_metric_info(name) != nullptr) return {};
  return fail(unknown_name("metric", plain_metric_name(name), where, names_of_metrics()));
}

}  // namespace somato
