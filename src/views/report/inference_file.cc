#include "views/report/inference_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "base/text/format_version.h"
#include "somato/studies/claim.h"
#include "views/report/checked_json.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kInferenceFileVersion = 1;
constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
constexpr std::array kSupports{"explained", "reachable", "excluded", "not decided"};

template <typename Read>
Json list_of(const CheckedJson& json, const Read& read) {
  Json list = Json::array();
  json.each([&](const CheckedJson& one) { list.push_back(read(one)); });
  return list;
}

Json number_of(const CheckedJson& json) {
  return json.number();
}

Json text_of(const CheckedJson& json) {
  return json.text();
}

Json share_of(const CheckedJson& json) {
  const double share = json.number();
  if (share < 0.0 || share > 1.0) json.refuse("is not a share from 0 to 1");
  return share;
}

Json share_or_null(const CheckedJson& json) {
  return json.is_null() ? Json() : share_of(json);
}

Json number_or_null(const CheckedJson& json) {
  return json.is_null() ? Json() : number_of(json);
}

Json text_or_null(const CheckedJson& json) {
  return json.is_null() ? Json() : text_of(json);
}

// A value of an unknown: a number, a text or a truth value.
Json value_of(const CheckedJson& json) {
  if (json.is_number()) return json.number();
  return json.is_truth() ? Json(json.truth()) : Json(json.text());
}

Json texts_of(const CheckedJson& json, std::initializer_list<const char*> keys) {
  Json texts = Json::object();
  for (const char* key : keys) texts[key] = json.at(key).text();
  return texts;
}

Json target_of(const CheckedJson& json) {
  Json target = texts_of(json, {"text", "paper", "system", "variation", "metric", "protocol"});
  for (const char* key : {"observed", "scale", "prior", "posterior"}) {
    target[key] = json.at(key).number();
  }
  return target;
}

Json cell_of(const CheckedJson& json) {
  return {{"from", value_of(json.at("from"))},
          {"to", value_of(json.at("to"))},
          {"prior", share_of(json.at("prior"))},
          {"posterior", share_of(json.at("posterior"))}};
}

Json summary_of(const CheckedJson& json) {
  Json summary = Json::object();
  for (const char* key : {"low", "median", "high"}) summary[key] = value_of(json.at(key));
  return summary;
}

Json unknown_of(const CheckedJson& json) {
  Json unknown = texts_of(json, {"name", "text", "system"});
  unknown["key"] = list_of(json.at("key"), text_of);
  unknown["cells"] = list_of(json.at("cells"), cell_of);
  if (json.ok() && unknown["cells"].empty()) json.at("cells").refuse("has no part of the range");
  unknown["prior"] = summary_of(json.at("prior"));
  unknown["posterior"] = summary_of(json.at("posterior"));
  unknown["shrinkage"] = json.at("shrinkage").number();
  return unknown;
}

Json dependence_of(const CheckedJson& json) {
  Json dependence = texts_of(json, {"first", "second"});
  dependence["correlation"] = json.at("correlation").number();
  return dependence;
}

Json calibrated_of(const CheckedJson& json) {
  return {{"name", json.at("name").text()},
          {"covered", share_of(json.at("covered"))},
          {"uniform_p", share_of(json.at("uniform_p"))},
          {"ranks", list_of(json.at("ranks"), share_of)}};
}

std::string optional_text_of(const CheckedJson& json, const char* key) {
  return json.has(key) ? json.at(key).text() : std::string();
}

// The other system or variation with which a claim compares, and its metric.
void add_comparison(const CheckedJson& json, Json& fields) {
  Claim claim;
  claim.system = json.at("system").text();
  claim.metric = json.at("metric").text();
  claim.than_system = optional_text_of(json, "than_system");
  claim.than_variation = optional_text_of(json, "than_variation");
  claim.than_metric = optional_text_of(json, "than_metric");
  fields["than"] = claim.other();
  fields["than_metric"] = claim.compares() ? claim.other_metric() : "";
}

Json supported_of(const CheckedJson& json) {
  Json claim = texts_of(json, {"text", "paper", "system", "variation", "metric", "protocol"});
  add_comparison(json, claim);
  for (const char* key : {"published", "at_least", "at_most"}) {
    claim[key] = number_or_null(json.at(key));
  }
  for (const char* key : {"prior", "left_out", "fresh", "chance", "fresh_chance"}) {
    claim[key] = share_or_null(json.at(key));
  }
  for (const char* key : {"fresh_verdict", "fresh_verdict_as_written"}) {
    claim[key] = text_or_null(json.at(key));
  }
  claim["support"] = json.at("support").text();
  const bool is_known =
      std::find(kSupports.begin(), kSupports.end(), claim["support"]) != kSupports.end();
  if (!is_known) json.at("support").refuse("is no support of a claim");
  return claim;
}

Json conflict_of(const CheckedJson& json) {
  Json conflict = {{"first", texts_of(json.at("first"), {"system", "variation", "text"})},
                   {"second", texts_of(json.at("second"), {"system", "variation", "text"})}};
  for (const char* key : {"together", "expected", "deviations"}) {
    conflict[key] = json.at(key).number();
  }
  return conflict;
}

Json joint_of(const CheckedJson& json) {
  return {{"mean", json.at("mean").number()},
          {"sums", list_of(json.at("sums"), number_of)},
          {"not_failing", json.at("not_failing").whole(kMost)},
          {"not_failing_as_written", json.at("not_failing_as_written").whole(kMost)}};
}

Json inference_of(const CheckedJson& root, const std::string& path) {
  Json inference = {{"file", path}, {"systems", list_of(root.at("systems"), text_of)}};
  for (const char* key : {"draws", "pairs", "accepted"}) {
    inference[key] = root.at(key).whole(kMost);
  }
  inference["adjusted"] = root.at("adjusted").truth();
  const CheckedJson rule = root.at("inference");
  inference["bodies"] = rule.at("bodies").whole(kMost);
  inference["fresh_pairs"] = rule.at("pairs").whole(kMost);
  inference["targets"] = list_of(root.at("targets"), target_of);
  inference["unknowns"] = list_of(root.at("unknowns"), unknown_of);
  inference["dependences"] = list_of(root.at("dependences"), dependence_of);
  const CheckedJson calibration = root.at("calibration");
  inference["truths"] = calibration.at("truths").whole(kMost);
  inference["calibration"] = list_of(calibration.at("unknowns"), calibrated_of);
  inference["claims"] = list_of(root.at("claims"), supported_of);
  inference["conflicts"] = list_of(root.at("conflicts"), conflict_of);
  const CheckedJson joint = root.at("joint");
  inference["joint"] = {{"prior", joint_of(joint.at("prior"))},
                        {"fresh", joint_of(joint.at("fresh"))}};
  return inference;
}

}  // namespace

Result<Json> parse_inference(std::string_view text, const std::string& path) {
  SOMATO_TRY(const auto json, parse_results_json(text, path));
  std::optional<Error> trouble;
  const CheckedJson root(json, trouble);
  const std::string advice =
      "run 'somato sweep --targets' of this version again, which keeps its draws";
  const std::uint64_t version = root.at("version").whole(kMost);
  if (!trouble && version != kInferenceFileVersion) {
    return unsupported_format(version, kInferenceFileVersion, path, advice);
  }
  Json inference = trouble ? Json() : inference_of(root, path);
  if (!trouble) return inference;
  trouble->where = path;
  trouble->advice = advice;
  return fail(std::move(*trouble));
}

}  // namespace somato::detail
