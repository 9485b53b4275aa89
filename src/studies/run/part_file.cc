#include "studies/run/part_file.h"

#include <fmt/format.h>

#include <limits>
#include <utility>
#include <vector>

#include "base/text/flag_hint.h"
#include "base/text/format_version.h"
#include "studies/results/results_json.h"
#include "studies/run/checked_line.h"

namespace somato {
namespace {

using PartJson = nlohmann::json;

constexpr std::uint64_t kPartVersion = 5;

PartJson protocol_json(const ProtocolResults& protocol) {
  PartJson metrics = PartJson::array();
  for (const Metric& metric : protocol.metrics) {
    metrics.push_back({metric.name, metric.values, metric.of_each});
  }
  PartJson json = {{"protocol", protocol.protocol},
                   {"group", protocol.group},
                   {"label", protocol.label},
                   {"samples", protocol.samples},
                   {"metrics", metrics},
                   {"chosen_neighbours", protocol.chosen_neighbours}};
  if (protocol.fold_comparison) {
    json["fold_comparison"] = detail::fold_comparison_json(*protocol.fold_comparison);
  }
  return json;
}

// JSON has no NaN and writes null.
std::vector<double> kept_values(const PartJson& list) {
  std::vector<double> values;
  for (const PartJson& value : list) {
    values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                     : value.get<double>());
  }
  return values;
}

FoldComparison comparison_of(const PartJson& kept) {
  FoldComparison comparison{kept.at("choice"), kept.at("other")};
  kept.at("largest_block").get_to(comparison.largest_block);
  kept.at("samples").get_to(comparison.samples);
  kept.at("right").get_to(comparison.right);
  kept.at("other_right").get_to(comparison.other_right);
  kept.at("only_right").get_to(comparison.only_right);
  kept.at("only_other_right").get_to(comparison.only_other_right);
  return comparison;
}

ProtocolResults protocol_of(const PartJson& kept) {
  ProtocolResults protocol;
  kept.at("protocol").get_to(protocol.protocol);
  kept.at("group").get_to(protocol.group);
  kept.at("label").get_to(protocol.label);
  kept.at("samples").get_to(protocol.samples);
  kept.at("chosen_neighbours").get_to(protocol.chosen_neighbours);
  if (kept.contains("fold_comparison")) {
    protocol.fold_comparison = comparison_of(kept.at("fold_comparison"));
  }
  for (const PartJson& metric : kept.at("metrics")) {
    protocol.metrics.push_back({metric.at(0), kept_values(metric.at(1)), metric.at(2)});
  }
  return protocol;
}

}  // namespace

std::string part_file(const PartResults& part) {
  PartJson recordings = PartJson::array();
  for (const RecordingInfo& one : part.recordings) recordings.push_back(one.name);
  PartJson pairs = PartJson::array();
  for (const Pair& pair : part.pairs) pairs.push_back({pair.recording, pair.seed});
  PartJson protocols = PartJson::array();
  for (const ProtocolResults& protocol : part.protocols)
    protocols.push_back(protocol_json(protocol));
  return checked_line({{"somato_part", kPartVersion},
                       {"question", part.question},
                       {"system", part.system},
                       {"variation", part.variation},
                       {"recordings", recordings},
                       {"pairs", pairs},
                       {"protocols", protocols}});
}

Result<std::optional<PartResults>> read_part_file(std::string_view content,
                                                  const std::string& where) {
  if (!content.ends_with('\n')) return std::nullopt;
  content.remove_suffix(1);
  const auto kept = checked_content(content);
  if (!kept || !kept->is_object()) return std::nullopt;
  const auto version = kept->find("somato_part");
  if (version == kept->end() || !version->is_number_unsigned()) return std::nullopt;
  if (*version != kPartVersion) {
    return unsupported_format(
        version->get<std::uint64_t>(), kPartVersion, where,
        fmt::format(
            "complete the sweep with that version, use another folder{}, or remove the file",
            flag_hint("out")));
  }
  PartResults part;
  kept->at("question").get_to(part.question);
  kept->at("system").get_to(part.system);
  kept->at("variation").get_to(part.variation);
  for (const PartJson& name : kept->at("recordings")) {
    part.recordings.push_back({name, {}, 0, {}, 0});
  }
  for (const PartJson& pair : kept->at("pairs")) part.pairs.push_back({pair.at(0), pair.at(1)});
  for (const PartJson& protocol : kept->at("protocols")) {
    part.protocols.push_back(protocol_of(protocol));
  }
  return part;
}

}  // namespace somato
