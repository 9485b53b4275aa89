#include "studies/results/metric_names.h"

#include <string_view>
#include <vector>

#include "base/core/contains.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

constexpr std::string_view kChanceSuffix = "_chance";
constexpr std::string_view kMappedWith = "mapped_with ";
constexpr std::string_view kAfter = "_after_";

const std::vector<std::string>& plain_names() {
  static const std::vector<std::string> names{"accuracy",
                                              "baseline_accuracy",
                                              "baseline_accuracy_raw",
                                              "baseline_accuracy_standardized",
                                              "unknown_auroc",
                                              "unknown_auroc_of_distance",
                                              "unknown_noticed",
                                              "unknown_noticed_at_rate",
                                              "unknown_noticed_at_rate_of_distance",
                                              "unknown_false_alarms",
                                              "baseline_unknown_auroc",
                                              "baseline_unknown_noticed_at_rate",
                                              "taught_accuracy",
                                              "taught_accuracy_of_nearest",
                                              "baseline_taught_accuracy",
                                              "known_accuracy",
                                              "known_accuracy_of_nearest",
                                              "baseline_known_accuracy",
                                              "known_changed",
                                              "names_refused",
                                              "quantization_error",
                                              "topographic_error",
                                              "individuals_apart",
                                              "areas_connected",
                                              "classes_separated",
                                              "samples_ambiguous",
                                              "neighbours_same_class",
                                              "winner_shared_within_class",
                                              "order_around",
                                              "order_within",
                                              "order_along",
                                              "right_size_wrong_group",
                                              "on_border",
                                              "neurons",
                                              "connected_parts",
                                              "cosine_between_classes",
                                              "placed_with_most_similar",
                                              "baseline_placed_with_most_similar",
                                              "placed_in_part_of_most_similar",
                                              "prediction_error",
                                              "prediction_error_of_mean",
                                              "prediction_error_of_nearest",
                                              "prediction_error_of_preceding",
                                              "strongest_right",
                                              "strongest_right_of_nearest",
                                              "strongest_right_of_preceding",
                                              "strongest_distance",
                                              "strongest_distance_of_nearest",
                                              "strongest_distance_of_preceding",
                                              "steps_right",
                                              "forgetting",
                                              "values_kept",
                                              "baseline_forgetting",
                                              "baseline_values_kept",
                                              "plain_som_accuracy",
                                              "plain_som_forgetting",
                                              "plain_som_values_kept",
                                              "same_memory_accuracy",
                                              "same_memory_forgetting",
                                              "same_memory_values_kept"};
  return names;
}

}  // namespace

Result<void> check_metric_name(const std::string& name, const std::string& where) {
  if (name.find(kMappedWith) != std::string::npos) return {};
  std::string plain = name.substr(name.rfind('.') + 1);  // npos + 1 is 0
  if (plain.ends_with(kChanceSuffix)) plain.resize(plain.size() - kChanceSuffix.size());
  plain = plain.substr(0, plain.find(kAfter));
  if (contains(plain_names(), plain)) return {};
  return fail(unknown_name("metric", plain, where, plain_names()));
}

}  // namespace somato
