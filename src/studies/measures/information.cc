#include "somato/studies/information.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "recordings/explorations/content_hash.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system_model.h"
#include "somato/maps/labels.h"
#include "studies/description/exploration_samples.h"
#include "studies/measures/explained_share.h"
#include "studies/measures/individual_order.h"
#include "studies/measures/sample_distances.h"
#include "systems/graph/wiring.h"
#include "systems/model/element_names.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::size_t>;

// The maps that no other map comes before.
std::vector<std::string> first_maps(const System& system) {
  const auto is_map = [&](std::size_t module) { return som_of(system, module) != nullptr; };
  std::vector<std::string> names;
  for (std::size_t module = 0; module < system.modules().size(); ++module) {
    bool is_first = is_map(module);
    for (std::size_t other = 0; is_first && other < system.modules().size(); ++other) {
      is_first = other == module || !is_map(other) || !system.wiring().reaches(other, module);
    }
    if (is_first) names.push_back(system.modules()[module].name);
  }
  return names;
}

Result<std::size_t> find_first_map(const System& system, const std::string& name,
                                   const std::string& where) {
  if (!name.empty()) {
    auto module = system.find(name, "map");
    if (!module || som_of(system, *module)) return module;
    return fail(ErrorKind::kUsage, fmt::format("the module '{}' is not a map", name), "map",
                "use the name of a module of type som");
  }
  const std::vector<std::string> candidates = first_maps(system);
  if (candidates.size() == 1) return system.find(candidates.front());
  if (candidates.empty()) {
    return fail(ErrorKind::kUsage, "the system has no map", where, "add a module of type som");
  }
  return fail(ErrorKind::kUsage, "the system has more than one first map", where,
              fmt::format("set 'map' to one of {}", fmt::join(candidates, ", ")));
}

// Before training, only outputs that do not depend on learning are available.
Result<void> check_fixed(const System& system, std::size_t vectors, std::size_t map) {
  std::vector<std::string> learners;
  for (std::size_t module = 0; module < system.modules().size(); ++module) {
    const bool comes_before = module == vectors || system.wiring().reaches(module, vectors);
    if (comes_before && system.modules()[module].module->learner()) {
      learners.push_back("'" + system.modules()[module].name + "'");
    }
  }
  if (learners.empty()) return {};
  return fail(system.at_module(
      {ErrorKind::kUsage,
       fmt::format("the vectors depend on modules that learn: {}", fmt::join(learners, ", ")),
       {},
       "select a map whose input does not depend on learning, or set the ranges of a one_hot with "
       "'low' and 'high'; 'somato run' measures trained systems"},
      map));
}

// The module that outputs the vectors.
Result<std::size_t> find_vectors(const System& system, const StudyDescription& description,
                                 const std::string& map_name) {
  SOMATO_TRY(const auto map, find_first_map(system, map_name, description.where));
  std::size_t vectors = system.modules()[map].inputs.front();
  if (system.modules()[vectors].type->name == "standardization") {
    vectors = system.modules()[vectors].inputs.front();
  }
  if (system.modules()[vectors].output.rate == Rate::kFrame) {
    return fail(
        system.at_module({ErrorKind::kUsage,
                          "this map receives one input per frame; one per exploration is required",
                          {},
                          "combine the frames first, for example with 'last'"},
                         map));
  }
  SOMATO_TRY_VOID(check_fixed(system, vectors, map));
  return vectors;
}

Result<Samples> vectors_of(const System& system, const Recording& recording, std::size_t module,
                           std::size_t threads) {
  Numbers all(recording.explorations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Activations activations(system.modules().size(), all.size());
  SOMATO_TRY_VOID(evaluate(system, recording, all, {module}, threads, activations));
  return activations.values_of(module).samples;
}

Error too_few_classes(const std::string& label) {
  return {ErrorKind::kData,
          "every exploration has the same '" + label + "'",
          {},
          "there are no classes to distinguish; use another label"};
}

bool all_equal(const Numbers& numbers) {
  return std::adjacent_find(numbers.begin(), numbers.end(), std::not_equal_to<>()) == numbers.end();
}

Result<LabelInformation> about_label(const std::string& name, const Recording& recording,
                                     const Samples& vectors, const Matrix<double>& distances,
                                     const Numbers& individuals) {
  SOMATO_TRY(const auto labels, labels_of(recording, name));
  const Classes classes = Classes::from_names(labels);
  if (classes.names.size() < 2) return fail(too_few_classes(name));
  Numbers each(individuals.size());
  std::iota(each.begin(), each.end(), std::size_t{0});
  const NeighbourAccuracy left_out = neighbour_accuracy(distances, classes.of_sample, each);
  LabelInformation about{name, classes.names.size(), left_out.accuracy, left_out.chance, {}, {},
                         {}};
  about.explained = explained_shares(vectors, classes);
  about.distance_ratio = between_to_within(distances, classes.of_sample);
  if (individuals == each) return about;
  const NeighbourAccuracy others = neighbour_accuracy(distances, classes.of_sample, individuals);
  if (others.chance <= 0.0) return about;  // no other individual has the same
  about.accuracy_new_individuals = others.accuracy;
  about.chance_new_individuals = others.chance;
  return about;
}

Json json_of(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const LabelInformation& about) {
  return {{"label", about.label},
          {"classes", about.classes},
          {"accuracy", about.accuracy},
          {"chance", about.chance},
          {"accuracy_new_individuals", json_of(about.accuracy_new_individuals)},
          {"chance_new_individuals", json_of(about.chance_new_individuals)},
          {"distance_ratio", json_of(about.distance_ratio)},
          {"explained", about.explained}};
}

Json json_of(const OrderInformation& order) {
  Json groups = Json::array();
  for (const OrderInformation::Group& group : order.groups) {
    groups.push_back({{"group", group.name},
                      {"individuals", group.individuals},
                      {"correlation", group.correlation}});
  }
  return {{"correlation", order.correlation},
          {"shuffled", order.shuffled},
          {"shuffled_share", order.shuffled_share},
          {"groups", groups}};
}

Json json_of(const InformationParameters& parameters) {
  Json json = Json::object();
  for (const auto& parameter : InformationParameters::declarations().all()) {
    const std::string value = to_toml(parameter.read(parameters));
    const Json parsed = Json::parse(value, nullptr, false);
    json[parameter.info.name] = parsed.is_discarded() ? Json(value) : parsed;
  }
  return json;
}

}  // namespace

const Declarations<InformationParameters>& InformationParameters::declarations() {
  using P = InformationParameters;
  static const auto declared =
      Declarations<P>()
          .add("labels", &P::labels, "", Range::any(),
               "Labels by which the vectors are compared; by default that of the study.")
          .add("individual", &P::individual, "", Range::any(),
               "Label of the individuals, such as the object if a label is its shape: a label is "
               "then also predicted from other individuals, and an order is that of the "
               "individuals' mean vectors; empty: each exploration is an individual.")
          .add("order", &P::order, "", Range::any(),
               "Label with numbers, such as girth, whose order is measured; empty: none.")
          .add("within", &P::within, "", Range::any(),
               "Label of groups, such as shape, within each of which the order is measured; empty: "
               "all individuals form one group.")
          .add("map", &P::map, "", Range::any(),
               "Name of the module of type som whose input vectors are measured; empty: the only "
               "one that does not depend on another map.")
          .add("shuffles", &P::shuffles, "", Range::between(0, 1e6),
               "Number of shuffles of the numbers with which the order is compared.")
          .add("seed", &P::seed, "", Range::between(0, 1e15), "Seed of the shuffles.");
  return declared;
}

Result<Information> measure_information(const StudyDescription& description,
                                        const Recording& recording,
                                        const InformationParameters& parameters,
                                        std::size_t threads) {
  SOMATO_TRY_VOID(validate(recording));
  SOMATO_TRY(const auto system, System::build(description.system, layout_of(recording)));
  SOMATO_TRY(const auto module, find_vectors(system, description, parameters.map));
  if (recording.explorations.size() < 2) {
    return fail(ErrorKind::kData, "the recording has only one exploration", {},
                "a comparison requires at least two");
  }
  SOMATO_TRY(const auto individuals, numbers_of(recording, parameters.individual));
  if (all_equal(individuals)) return fail(too_few_classes(parameters.individual));
  SOMATO_TRY(const auto vectors, vectors_of(system, recording, module, threads));

  const SystemModule& gives = system.modules()[module];
  Information information{description.study.name,
                          content_hash(recording),
                          parameters,
                          gives.name,
                          vectors.count(),
                          vectors.size(),
                          element_names(system, module),
                          {},
                          {}};
  const Matrix<double> distances = distances_between(vectors, threads);
  for (const std::string& label : parameters.labels) {
    SOMATO_TRY(auto about, about_label(label, recording, vectors, distances, individuals));
    information.labels.push_back(std::move(about));
  }
  if (parameters.order.empty()) return information;
  SOMATO_TRY(auto order, order_of_individuals(recording, parameters, individuals, vectors));
  information.order = std::move(order);
  return information;
}

std::string to_json(const Information& information) {
  Json labels = Json::array();
  for (const LabelInformation& about : information.labels) labels.push_back(json_of(about));
  Json json = {{"version", 1},
               {"study", information.study},
               {"data_hash", information.data_hash},
               {"parameters", json_of(information.parameters)},
               {"module", information.module},
               {"explorations", information.explorations},
               {"elements", information.elements},
               {"element_names", information.element_names},
               {"labels", labels}};
  if (information.order) json["order"] = json_of(*information.order);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace somato
