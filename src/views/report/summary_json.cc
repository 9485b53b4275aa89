#include "views/report/summary_json.h"

#include "studies/results/fold_comparison.h"
#include "studies/results/main_result.h"
#include "studies/results/next_steps.h"
#include "studies/results/tested_folds.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostConfusions = 3;

Json confusions_json(const ProtocolResults& protocol) {
  Json json = Json::array();
  for (const Confusion& one : confusions(protocol, kMostConfusions)) {
    json.push_back(
        {{"label", one.label}, {"predicted", one.predicted}, {"count", one.count}, {"of", one.of}});
  }
  return json;
}

Json next_json(const Evidence& evidence, const ReportSources& sources) {
  ResultFiles files;
  if (evidence.recording && sources.recording_path) {
    files.data = sources.recording_path(evidence.part->recordings[evidence.recording_number].hash);
  }
  if (evidence.model) files.model = evidence.model->path;
  Json json = Json::array();
  for (const NextStep& step : next_steps(*evidence.part, files)) {
    json.push_back({{"text", step.text}, {"commands", step.commands}, {"page", step.page}});
  }
  return json;
}

std::vector<std::string> groups_of(const Evidence& evidence, const std::string& group) {
  std::vector<std::string> groups;
  if (!evidence.recording || group.empty()) return groups;
  for (const std::size_t i : evidence.explorations) {
    const auto label = find_label(evidence.recording->explorations[i], group);
    if (!label) return {};
    groups.push_back(*label);
  }
  return groups;
}

// Results of versions without a choice have interleaved folds.
FoldChoice fold_choice_of(const Evidence& evidence) {
  for (const Settings& part : evidence.part->parameters) {
    if (part.part != "study") continue;
    for (const Setting& one : part.settings) {
      if (one.name == "fold_choice") return evidence.study->study.fold_choice;
    }
  }
  return FoldChoice::kInterleaved;
}

// How far the main result is from the best nearest neighbour, and whether neighbours leak under any
// protocol.
Json sentences_json(const PartResults& part, const ProtocolResults& main) {
  Json sentences = Json::array();
  if (const std::string best = best_neighbour_sentence(main); !best.empty())
    sentences.push_back(best);
  for (const ProtocolResults& protocol : part.protocols) {
    if (protocol.fold_comparison) sentences.push_back(sentence_of(*protocol.fold_comparison));
  }
  return sentences;
}

}  // namespace

Json summary_json(const Evidence& evidence, const ReportSources& sources) {
  const auto result = main_result(*evidence.part);
  if (!result) return nullptr;
  const ProtocolResults& protocol = evidence.part->protocols[result->protocol];
  return {{"protocol", result->protocol},
          {"accuracy", result->accuracy},
          {"deviation", result->deviation},
          {"baseline", result->baseline ? Json(*result->baseline) : Json(nullptr)},
          {"chance", result->chance},
          {"confusions", confusions_json(protocol)},
          {"sentences", sentences_json(*evidence.part, protocol)},
          {"next", next_json(evidence, sources)}};
}

std::vector<std::size_t> folds_of(const Evidence& evidence, const ProtocolResults& protocol) {
  // The first seed of each recording and the classes of its samples determine folds; groups are
  // the same in all recordings of a reproduction.
  const bool has_one = evidence.part->recordings.size() == 1;
  if (!evidence.study || (protocol.protocol == "k_folds" && !has_one)) return {};
  return tested_folds(protocol, evidence.study->study.folds, fold_choice_of(evidence),
                      groups_of(evidence, protocol.group));
}

}  // namespace somato::detail
