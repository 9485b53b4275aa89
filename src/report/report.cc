#include "somato/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "graph/graph_json.h"
#include "report/claims_json.h"
#include "report/curves.h"
#include "report/evidence.h"
#include "report/not_given.h"
#include "report/rebuilt_study.h"
#include "report/samples_json.h"
#include "report/trained_json.h"
#include "studies/results_json.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;

Json settings_json(const std::vector<Settings>& parts) {
  Json json = Json::object();
  for (const Settings& part : parts) {
    json[part.part] = Json::object();
    for (const Setting& setting : part.settings) json[part.part][setting.name] = setting.value;
  }
  return json;
}

// As in results.json, each run with its recording, without what only verdicts are made of.
Json protocols_json(const PartResults& part) {
  Json json = Json::array();
  for (const SystemResults& protocol : part.protocols) {
    Json one = detail::system_json(protocol);
    one.erase("name");
    for (Json& metric : one["metrics"]) metric.erase("of_each");
    for (std::size_t i = 0; i < protocol.runs.size(); ++i) {
      one["runs"][i]["recording"] = part.pairs[i].recording;
    }
    json.push_back(std::move(one));
  }
  return json;
}

// A study does not know what its recording was called.
Json recordings_json(const detail::Evidence& evidence) {
  Json names = evidence.part->recordings;
  if (evidence.file->is_study && evidence.recording) names[0] = evidence.recording_name;
  return names;
}

std::string hash_of(const detail::Evidence& evidence) {
  const auto& names = evidence.part->recordings;
  const RecordingInfo* info =
      names.empty() ? nullptr : evidence.file->find_recording(names[evidence.recording_number]);
  return info ? info->data_hash : std::string();
}

Result<void> check_winners(const detail::Evidence& evidence, const Grid& grid) {
  for (const SystemResults& protocol : evidence.part->protocols) {
    for (const Run& run : protocol.runs) {
      const auto most = std::max_element(run.winners.begin(), run.winners.end());
      if (most == run.winners.end() || *most < grid.size()) continue;
      return fail(ErrorKind::kData,
                  fmt::format("neuron {} of '{}' is a winner, and its map has {}", *most,
                              evidence.part->system, grid.size()),
                  evidence.file->path, "give results.json as it was written");
    }
  }
  return {};
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
    return parameters_json(*modules[i].type,
                           detail::find_part(evidence.part->settings, "module." + modules[i].name));
  });
}

// Puts a report together, file by file.
class ReportWriter {
 public:
  explicit ReportWriter(const ReportSources& sources) : sources_(sources) {}

  Result<void> add(const ReportFile& file) {
    RecordingLayout layout;
    for (const PartResults& part : file.results.parts) {
      detail::Evidence evidence = detail::find_evidence(file, part, sources_);
      layout = evidence.recording ? layout_of(*evidence.recording) : RecordingLayout{};
      if (auto added = add_system(evidence); !added) return added;
      add_curve_part(part, *evidence.file, layout);
    }
    add_claims(file.results, layout);
    return {};
  }

  Report finish() const {
    const Json json = {{"version", kVersion},
                       {"somato", sources_.version},
                       {"systems", systems_},
                       {"claims", claims_},
                       {"curves", detail::curves_json(curve_parts_, judged_, sources_.units)}};
    return {json.dump(-1, ' ', false, Json::error_handler_t::replace), systems_.size(),
            claims_.size(), missing_};
  }

 private:
  Result<void> add_system(detail::Evidence& evidence) {
    Json trained = detail::trained_json(evidence, sources_.threads);
    Json grid = nullptr;
    if (evidence.system() && evidence.map) {
      const Grid of_map = grid_of(*evidence.system(), *evidence.map);
      if (auto right = check_winners(evidence, of_map); !right) return right;
      grid = detail::grid_json(of_map);
    }
    const PartResults& part = *evidence.part;
    systems_.push_back(
        {{"file", evidence.file->path},
         {"name", part.system},
         {"variation", part.variation},
         {"question", part.question},
         {"settings", settings_json(part.settings)},
         {"data_hash", hash_of(evidence)},
         {"recordings", recordings_json(evidence)},
         {"protocols", protocols_json(part)},
         {"graph", graph_or_null(evidence)},
         {"grid", std::move(grid)},
         {"samples", detail::samples_json(evidence)},
         {"things", detail::things_json(evidence, sources_.things)},
         {"not_given", detail::not_given_json(part.settings)},
         {"trained", std::move(trained)},
         {"moments", is_as_it_stands(part) ? detail::moments_json(evidence) : Json::array()},
         {"missing", evidence.missing}});
    remember(evidence.missing);
    return {};
  }

  void add_claims(const ResultsFile& file, const RecordingLayout& layout) {
    for (JudgedClaim& judged : detail::claims_of(file, layout, plans_)) {
      claims_.push_back(detail::claim_json(judged, file.path));
      judged_.push_back(std::move(judged));
    }
  }

  // Results from before exploring stood among the settings: the library's own files say it, unless
  // the recordings were given.
  void add_curve_part(const PartResults& part, const ResultsFile& file,
                      const RecordingLayout& layout) {
    detail::CurvePart curve{&part, part.settings};
    const bool given =
        file.is_study ||
        std::any_of(part.recordings.begin(), part.recordings.end(), [&](const std::string& name) {
          const RecordingInfo* info = file.find_recording(name);
          return !info || info->source == "given";
        });
    const bool says = detail::find_part(part.settings, "explore") != nullptr;
    const auto own = given || says ? std::nullopt : plans_.find(part, layout);
    if (own) curve.settings.insert(curve.settings.end(), own->explore.begin(), own->explore.end());
    curve_parts_.push_back(std::move(curve));
  }

  void remember(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) {
      if (std::find(missing_.begin(), missing_.end(), sentence) == missing_.end()) {
        missing_.push_back(sentence);
      }
    }
  }

  const ReportSources& sources_;
  detail::OwnPlans plans_;
  std::vector<detail::CurvePart> curve_parts_;
  std::vector<JudgedClaim> judged_;
  Json systems_ = Json::array();
  Json claims_ = Json::array();
  std::vector<std::string> missing_;
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

Result<Report> make_report(const std::vector<ReportFile>& files, const ReportSources& sources) {
  ReportWriter writer(sources);
  for (const ReportFile& file : files) {
    if (auto added = writer.add(file); !added) return fail(std::move(added.error()));
  }
  return writer.finish();
}

Result<std::string> report_page(std::string_view page, std::string_view json) {
  constexpr std::string_view kPlace =
      R"(<script type="application/json" id="report-data">null</script>)";
  constexpr std::string_view kNull = "null</script>";
  const std::size_t at = page.find(kPlace);
  if (at == std::string_view::npos || page.find(kPlace, at + 1) != std::string_view::npos) {
    return fail(ErrorKind::kUsage, "the page has no place for the report", "report.html",
                "build the program from an untouched folder 'web'");
  }
  const std::size_t value = at + kPlace.size() - kNull.size();
  std::string whole(page.substr(0, value));
  whole += without_markup(json);
  whole += page.substr(value + 4);
  return whole;
}

}  // namespace somato
