#include "views/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "studies/results/results_json.h"
#include "systems/graph/graph_json.h"
#include "views/curves/curves.h"
#include "views/curves/frame_curves.h"
#include "views/curves/part_settings.h"
#include "views/report/deciding_json.h"
#include "views/report/evidence.h"
#include "views/report/inference_file.h"
#include "views/report/moments_json.h"
#include "views/report/packed_json.h"
#include "views/report/samples_json.h"
#include "views/report/summary_json.h"
#include "views/report/trained_json.h"
#include "views/skins/channel_places.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 2;

// As in results.json, each run with its recording, without what only verdicts are made of.
Json protocols_json(const detail::Evidence& evidence) {
  const PartResults& part = *evidence.part;
  Json json = Json::array();
  for (const ProtocolResults& protocol : part.protocols) {
    Json one = detail::protocol_json(protocol);
    for (Json& metric : one["metrics"]) metric.erase("of_each");
    one.erase("chosen_neighbours");  // the sentences of the summary state both
    one.erase("fold_comparison");
    if (auto folds = detail::folds_of(evidence, protocol); !folds.empty()) one["folds"] = folds;
    for (std::size_t i = 0; i < protocol.runs.size(); ++i) {
      Json& run = one["runs"][i];
      run["recording"] = part.pairs[i].recording;
      const auto& map = protocol.runs[i].map;
      if (map)
        run["map"]["u_matrix"] = detail::packed_numbers(map->u_matrix, detail::PackedBits::k16);
    }
    json.push_back(std::move(one));
  }
  return json;
}

Json names_json(const std::vector<RecordingInfo>& recordings) {
  Json names = Json::array();
  for (const RecordingInfo& one : recordings) names.push_back(one.name);
  return names;
}

std::string hash_of(const detail::Evidence& evidence) {
  const auto& recordings = evidence.part->recordings;
  return recordings.empty() ? std::string() : recordings[evidence.recording_number].hash;
}

// Each training of a map that grows gives another number of neurons, within the size of its output.
Result<void> check_winners(const detail::Evidence& evidence, const std::string& path) {
  const std::size_t neurons = evidence.system()->modules()[*evidence.map].output.size();
  for (const ProtocolResults& protocol : evidence.part->protocols) {
    for (const Run& run : protocol.runs) {
      const auto most = std::max_element(run.winners.begin(), run.winners.end());
      if (most == run.winners.end() || *most < neurons) continue;
      return fail(ErrorKind::kData,
                  fmt::format("neuron {} of '{}' is a winner, but its map has {} neurons", *most,
                              evidence.part->system, neurons),
                  path, "use the original results.json");
    }
  }
  return {};
}

Json number_or_null(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json claim_report(const ClaimOutcome& outcome, const std::string& file) {
  Json json = {{"file", file}};
  json.update(detail::claim_json(outcome.claim));
  json.erase("than_system");
  json.erase("than_variation");
  json.update({{"than", outcome.claim.other()},
               {"than_metric", outcome.claim.compares() ? outcome.claim.other_metric() : ""},
               {"values", outcome.values},
               {"by_chance", number_or_null(outcome.by_chance)},
               {"chance_share", number_or_null(outcome.chance_share)},
               {"verdict", choice_name(outcome.verdict())},
               {"reason", outcome.reason()},
               {"share", outcome.share()}});
  if (!outcome.claim.contradicted_by.empty()) {
    json["contradicted_by"] = outcome.claim.contradicted_by;
  }
  for (const ClaimOutcome& second : outcome.as_written) {
    json["as_written"] = {{"verdict", choice_name(second.verdict())},
                          {"reason", second.reason()},
                          {"summary", second.summary()}};
  }
  return json;
}

bool is_as_it_stands(const PartResults& part) {
  return part.question.empty() && part.variation.empty();
}

bool has_parameter(const ModuleType& type, const std::string& name) {
  return std::any_of(type.parameters.begin(), type.parameters.end(),
                     [&](const ParameterInfo& info) { return info.name == name; });
}

Json parameters_json(const ModuleType& type, const Settings* part) {
  Json json = Json::object();
  for (const Setting& setting : part ? part->settings : std::vector<Setting>{}) {
    if (has_parameter(type, setting.name)) json[setting.name] = setting.value;
  }
  return json;
}

Json graph_or_null(const detail::Evidence& evidence) {
  if (!evidence.system() || !evidence.map) return nullptr;
  const auto& modules = evidence.system()->modules();
  return detail::graph_json(*evidence.system(), modules[*evidence.map].name, [&](std::size_t i) {
    return parameters_json(*modules[i].type, detail::find_part(evidence.part->parameters,
                                                               "module." + modules[i].name));
  });
}

// Puts a report together, file by file; the files outlive it.
class ReportWriter {
 public:
  explicit ReportWriter(const ReportSources& sources) : sources_(sources) {}

  Result<void> add(const ReportFile& file) {
    for (const PartResults& part : file.results.parts) {
      detail::Evidence evidence = detail::find_evidence(file, part, sources_);
      SOMATO_TRY_VOID(add_system(file.path, evidence));
      parts_.push_back(&part);
    }
    for (const ClaimOutcome& outcome : file.results.claims) {
      claims_.push_back(claim_report(outcome, file.path));
      outcomes_.push_back(&outcome);
    }
    return {};
  }

  Result<void> add(const ReportInference& file) {
    SOMATO_TRY(auto inference, detail::parse_inference(file.text, file.path));
    inferences_.push_back(std::move(inference));
    return {};
  }

  Result<Report> finish() {
    if (!sources_.places.empty()) SOMATO_TRY_VOID(place_channels());
    Json curves = detail::frame_curves_json(parts_);
    for (Json& curve : detail::curves_json(parts_, outcomes_, sources_.units)) {
      curves.push_back(std::move(curve));
    }
    Json json = {{"version", kVersion},         {"somato", sources_.version},
                 {"systems", systems_},         {"claims", claims_},
                 {"curves", std::move(curves)}, {"moments", moments_.list()}};
    if (!placed_.empty()) json["placed"] = placed_;
    if (!inferences_.empty()) json["inferences"] = inferences_;
    return Report{json.dump(-1, ' ', false, Json::error_handler_t::replace), systems_.size(),
                  claims_.size(), inferences_.size(), missing_};
  }

 private:
  Result<void> add_system(const std::string& path, detail::Evidence& evidence) {
    detail::read_inputs(evidence, sources_.threads);
    Json trained = detail::trained_json(evidence, sources_.threads);
    Json grid = nullptr;
    if (evidence.system() && evidence.map) {
      const Grid of_map = grid_of(*evidence.system(), *evidence.map);
      SOMATO_TRY_VOID(check_winners(evidence, path));
      grid = detail::grid_json(of_map);
    }
    const PartResults& part = *evidence.part;
    systems_.push_back(
        {{"file", path},
         {"name", part.system},
         {"variation", part.variation},
         {"question", part.question},
         {"settings", detail::parameters_json(part.parameters)},
         {"data_hash", hash_of(evidence)},
         {"summary", detail::summary_json(evidence, sources_)},
         {"recordings", names_json(part.recordings)},
         {"recording", evidence.recording ? Json(evidence.recording_number) : Json(nullptr)},
         {"protocols", protocols_json(evidence)},
         {"graph", graph_or_null(evidence)},
         {"grid", std::move(grid)},
         {"samples", detail::samples_json(evidence)},
         {"things", detail::things_json(evidence, sources_)},
         {"not_given", detail::not_given_json(part.parameters)},
         {"trained", std::move(trained)},
         {"deciding", detail::deciding_json(evidence, sources_.threads)},
         {"moments", moments_.numbers(evidence, is_as_it_stands(part))},
         {"missing", evidence.missing}});
    remember(evidence.missing);
    return {};
  }

  // Each channel that has places once, because their picture may be large.
  Result<void> place(const Json& channel) {
    channels_.push_back(channel["name"]);
    Json placed = channel;
    SOMATO_TRY_VOID(add_places(sources_.places, placed));
    const bool is_known = std::find(placed_.begin(), placed_.end(), placed) != placed_.end();
    if (placed.contains("layout") && !is_known) placed_.push_back(std::move(placed));
    return {};
  }

  // A plane may have other elements than the readings of its channel, and then no places.
  Result<void> place_channels() {
    for (const Json& moment : moments_.list()) {
      for (const Json& of : moment["channels"]) SOMATO_TRY_VOID(place(of["channel"]));
    }
    for (const Json& system : systems_) {
      if (system["trained"].is_null()) continue;
      for (const Json& planes : system["trained"]["planes"]) {
        static_cast<void>(place(planes["channel"]));
      }
      if (system["deciding"].is_null()) continue;
      for (const Json& source : system["deciding"]["sources"]) {
        static_cast<void>(place(source["channel"]));
      }
    }
    return check_channels(sources_.places, channels_);
  }

  void remember(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) {
      if (std::find(missing_.begin(), missing_.end(), sentence) == missing_.end()) {
        missing_.push_back(sentence);
      }
    }
  }

  const ReportSources& sources_;
  std::vector<const PartResults*> parts_;
  std::vector<const ClaimOutcome*> outcomes_;
  Json systems_ = Json::array();
  Json claims_ = Json::array();
  Json inferences_ = Json::array();
  detail::Moments moments_;
  std::vector<std::string> missing_;
  std::vector<std::string> channels_;  // of moments and planes
  Json placed_ = Json::array();
};

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

// As a script element may hold it: no '<', and no line that JavaScript would end where JSON does
// not.
std::string without_markup(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  replace_all(text, "\xE2\x80\xA8", "\\u2028");
  replace_all(text, "\xE2\x80\xA9", "\\u2029");
  return text;
}

}  // namespace

Result<Report> make_report(const std::vector<ReportFile>& files, const ReportSources& sources,
                           const std::vector<ReportInference>& inferences) {
  ReportWriter writer(sources);
  for (const ReportFile& file : files) SOMATO_TRY_VOID(writer.add(file));
  for (const ReportInference& file : inferences) SOMATO_TRY_VOID(writer.add(file));
  return writer.finish();
}

Result<std::string> report_page(std::string_view page, std::string_view json) {
  constexpr std::string_view kPlace =
      R"(<script type="application/json" id="report-data">null</script>)";
  constexpr std::string_view kNull = "null</script>";
  const std::size_t at = page.find(kPlace);
  if (at == std::string_view::npos || page.find(kPlace, at + 1) != std::string_view::npos) {
    return fail(ErrorKind::kUsage, "the page has no place for the report", "report.html",
                "build the program from an unmodified folder 'web'");
  }
  const std::size_t value = at + kPlace.size() - kNull.size();
  std::string whole(page.substr(0, value));
  whole += without_markup(json);
  whole += page.substr(value + 4);
  return whole;
}

}  // namespace somato
