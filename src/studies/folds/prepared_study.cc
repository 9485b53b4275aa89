#include "studies/folds/prepared_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "somato/graph/system_model.h"
#include "somato/maps/novelty.h"
#include "studies/description/exploration_samples.h"
#include "studies/description/folds.h"
#include "studies/folds/senses.h"
#include "studies/measures/most_similar.h"
#include "studies/measures/numbered_individuals.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// Each exploration on its own.
Numbers each_separate(std::size_t explorations) {
  Numbers numbers(explorations);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

std::size_t count_different(const Numbers& numbers) {
  return std::set<std::size_t>(numbers.begin(), numbers.end()).size();
}

// Individuals are dealt to classes as wholes, so each must belong to one; where every class is a
// single individual, there would be nothing to deal.
Result<Numbers> individuals_of(const Classes& classes, const Numbers& individuals,
                               const std::string& label, const std::string& individual) {
  std::map<std::size_t, std::size_t> class_of;
  for (std::size_t i = 0; i < individuals.size(); ++i) {
    const std::size_t its_class = classes.of_sample[i];
    if (class_of.emplace(individuals[i], its_class).first->second == its_class) continue;
    return fail(ErrorKind::kData,
                fmt::format("explorations with the same '{}' differ in '{}'", individual, label),
                {}, "use another label as 'individual', or leave it empty");
  }
  return class_of.size() == classes.names.size() ? each_separate(individuals.size()) : individuals;
}

Result<StudiedLabel> studied_label(const Recording& recording, const std::string& label,
                                   const StudyParameters& study, const Numbers& individuals) {
  SOMATO_TRY(const auto names, labels_of(recording, label));
  StudiedLabel studied{label, Classes::from_names(names), {}};
  SOMATO_TRY(auto dealt, individuals_of(studied.classes, individuals, label, study.individual));
  studied.individuals = std::move(dealt);
  return studied;
}

Result<void> add_labels(const StudyParameters& study, const Numbers& individuals,
                        PreparedStudy& prepared) {
  std::vector<std::string> names{study.label};
  names.insert(names.end(), study.labels.begin(), study.labels.end());
  for (const std::string& name : names) {
    SOMATO_TRY(auto studied, studied_label(prepared.recording, name, study, individuals));
    prepared.labels.push_back(std::move(studied));
  }
  return {};
}

// Sizes within their groups are treated like a label: small and large ones of each. Sizes are
// defined by the training individuals; others are large if they are not below a large one of these.
StudiedLabel size_group_label(const StudiedOrder& order,
                              const std::vector<std::string>& group_names, std::size_t learned) {
  const auto last = order.individuals.begin() + static_cast<std::ptrdiff_t>(learned);
  const std::size_t known = *std::max_element(order.individuals.begin(), last) + 1;
  std::vector<SizedThing> things;
  things.reserve(known);
  for (std::size_t i = 0; i < known; ++i) things.push_back({order.numbers[i], order.groups[i]});
  const std::vector<bool> large = is_large(things);
  const auto is_as_large = [&](std::size_t individual) {
    for (std::size_t i = 0; i < known; ++i) {
      if (large[i] && things[i].group == order.groups[individual] &&
          things[i].number <= order.numbers[individual]) {
        return true;
      }
    }
    return false;
  };
  std::vector<std::string> names;
  names.reserve(order.individuals.size());
  for (const std::size_t individual : order.individuals) {
    names.push_back((is_as_large(individual) ? "large " : "small ") +
                    group_names[order.groups[individual]]);
  }
  return {"size_group", Classes::from_names(names), order.individuals};
}

Result<void> add_order(const StudyParameters& study, const Numbers& individuals,
                       std::size_t learned, PreparedStudy& prepared) {
  if (study.order.empty()) return {};
  SOMATO_TRY(const auto members,
             numbered_individuals(prepared.recording, {study.individual, study.order, study.within},
                                  individuals));
  if (!has_an_order(members)) return fail(no_order(study.order));
  StudiedOrder order{individuals, {}, {}};
  std::vector<std::string> names;
  for (const NumberedIndividual& member : members) {
    order.numbers.push_back(member.number);
    names.push_back(member.group);
  }
  const Classes groups = Classes::from_names(names);
  order.groups = groups.of_sample;
  prepared.labels.push_back(size_group_label(order, groups.names, learned));
  prepared.order = std::move(order);
  return {};
}

// Without the explorations that are not included.
Result<void> keep_only(const StudyParameters& study, Recording& recording) {
  if (study.only.empty()) return {};
  SOMATO_TRY(const auto labels, labels_of(recording, study.label));
  for (const std::string& name : study.only) {
    if (std::find(labels.begin(), labels.end(), name) != labels.end()) continue;
    return fail(unknown_name("value of the label '" + study.label + "'", name, "only",
                             Classes::from_names(labels).names));
  }
  Recording kept;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (std::find(study.only.begin(), study.only.end(), labels[i]) == study.only.end()) continue;
    kept.explorations.push_back(std::move(recording.explorations[i]));
  }
  recording = std::move(kept);
  return {};
}

// The two must be alike, and not only each in itself.
Result<Recording> join(Recording recording, const Recording* test) {
  SOMATO_TRY_VOID(validate(recording));
  if (!test) return recording;
  SOMATO_TRY_VOID(validate(*test));
  recording.explorations.insert(recording.explorations.end(), test->explorations.begin(),
                                test->explorations.end());
  SOMATO_TRY_VOID(validate(recording));
  return recording;
}

// The training part must contain at least two classes.
Result<void> check_classes(const PreparedStudy& prepared, const std::string& label,
                           std::size_t learned) {
  const auto& classes = prepared.classes().of_sample;
  const auto begin = classes.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(learned);
  if (learned < 2) {
    return fail(ErrorKind::kData, "the recording has only one exploration", {},
                "a study needs at least two");
  }
  if (std::any_of(begin, end, [&](std::size_t its_class) { return its_class != *begin; }))
    return {};
  return fail(ErrorKind::kData, "every exploration has the same '" + label + "'", {},
              "there are no classes to distinguish; use another label");
}

// The number of explorations of each class, among the first ones.
Numbers counts_of(const Classes& classes, std::size_t explorations) {
  Numbers counts(classes.names.size(), 0);
  for (std::size_t i = 0; i < explorations; ++i) ++counts[classes.of_sample[i]];
  return counts;
}

// A class whose explorations are all tested could never be learned.
Result<void> check_each_is_repeated(Protocol protocol, const Classes& classes,
                                    const std::string& label, std::size_t learned) {
  const Numbers counts = counts_of(classes, learned);
  const auto single = std::find(counts.begin(), counts.end(), std::size_t{1});
  if (single == counts.end()) return {};
  return fail(ErrorKind::kData,
              fmt::format("only one exploration has '{}' as its '{}'",
                          classes.names[static_cast<std::size_t>(single - counts.begin())], label),
              {}, choice_name(protocol) + " needs at least two of each; select others with 'only'");
}

// A class must have more than `most` explorations, for the reason that `otherwise` states; `key`
// can be changed.
Result<void> check_each_has_more_than(std::size_t most, const Classes& classes,
                                      const std::string& label, std::size_t learned,
                                      const std::string& otherwise, const std::string& key) {
  const Numbers counts = counts_of(classes, learned);
  for (std::size_t one = 0; one < counts.size(); ++one) {
    if (counts[one] == 0 || counts[one] > most) continue;
    return fail(ErrorKind::kData,
                fmt::format("{} of the explorations have '{}' as their '{}', and {}", counts[one],
                            classes.names[one], label, otherwise),
                {},
                fmt::format("use a smaller '{}' in [study], or select others with 'only'", key));
  }
  return {};
}

Result<void> check_each_has_earlier_ones(const Classes& classes, const StudyParameters& study,
                                         std::size_t learned) {
  return check_each_has_more_than(study.test_last, classes, study.label, learned,
                                  fmt::format("the last {} would be tested", study.test_last),
                                  "test_last");
}

Result<void> check_each_has_untaught_ones(const Classes& classes, const StudyParameters& study,
                                          std::size_t learned) {
  return check_each_has_more_than(
      study.taught_per_class, classes, study.label, learned,
      fmt::format("{} would be named, so that none is left for the test", study.taught_per_class),
      "taught_per_class");
}

// Each system with a threshold for unknown explorations needs enough training explorations.
Result<void> check_thresholds(const StudyParameters& study, const FoldSamples& samples) {
  if (study.unknown) SOMATO_TRY_VOID(check_scores(samples.samples, study.false_alarm_rate));
  if (!study.has(Protocol::kLeaveClassOut)) return {};
  for (const Fold& fold : folds(Protocol::kLeaveClassOut, samples)) {
    SOMATO_TRY_VOID(check_scores(fold.training.size(), study.false_alarm_rate));
  }
  return {};
}

// "unknown" is an answer.
Result<void> check_names(const StudyParameters& study, const std::vector<std::string>& names) {
  if (!study.unknown && !study.has(Protocol::kLeaveClassOut)) return {};
  if (std::find(names.begin(), names.end(), kUnknownAnswer) == names.end()) return {};
  return fail(ErrorKind::kData,
              fmt::format("some explorations have '{}' as their '{}', which is the answer for what "
                          "a system has not learned",
                          kUnknownAnswer, study.label),
              {}, "give them another name, or select others with 'only'");
}

Result<void> divide(const StudyParameters& study, std::size_t learned, PreparedStudy& prepared) {
  const std::size_t all = prepared.recording.explorations.size();
  prepared.samples.samples = learned;
  prepared.samples.test_samples = all - learned;
  prepared.samples.folds = study.folds;
  prepared.samples.seed = study.first_seed;
  prepared.samples.test_last = study.test_last;
  prepared.samples.choice = study.fold_choice;
  prepared.samples.classes = prepared.classes().of_sample;
  prepared.samples.classes.resize(learned);
  for (const std::string& label : study.groups) {
    SOMATO_TRY(auto groups, numbers_of(prepared.recording, label));
    groups.resize(learned);
    if (count_different(groups) < 2) {
      return fail(ErrorKind::kData, "every exploration has the same '" + label + "'", {},
                  "there are no groups to leave out; use another label in 'groups'");
    }
    prepared.groups[label] = std::move(groups);
  }
  for (const Protocol protocol : study.protocols) {
    const bool in_parts = protocol == Protocol::kFolds || protocol == Protocol::kLeaveClassOut ||
                          protocol == Protocol::kObjectAfterObject;
    if (in_parts && study.test_last > 0) {
      SOMATO_TRY_VOID(check_each_has_earlier_ones(prepared.classes(), study, learned));
    } else if (in_parts && study.folds > learned) {
      return fail(
          ErrorKind::kData,
          fmt::format("{} explorations cannot be divided into {} parts", learned, study.folds), {},
          "use a smaller number of 'folds' in [study]");
    }
    if (protocol == Protocol::kLeaveClassOut) {
      SOMATO_TRY_VOID(check_each_has_untaught_ones(prepared.classes(), study, learned));
    }
    if (protocol == Protocol::kObjectAfterObject || protocol == Protocol::kLeaveClassOut) {
      SOMATO_TRY_VOID(check_each_is_repeated(protocol, prepared.classes(), study.label, learned));
    }
  }
  SOMATO_TRY_VOID(check_names(study, prepared.classes().names));
  return check_thresholds(study, prepared.samples);
}

bool answers(const System& system, std::size_t module) {
  if (!som_of(system, module)) return false;
  const auto& modules = system.modules();
  return std::none_of(modules.begin(), modules.end(), [&](const SystemModule& listener) {
    return std::find(listener.inputs.begin(), listener.inputs.end(), module) !=
           listener.inputs.end();
  });
}

Result<void> find_modules(const System& system, const StudyDescription& description,
                          PreparedStudy& prepared) {
  SOMATO_TRY(const auto map, find_map(system, description.study.map, description.where));
  prepared.map = map;
  const SystemModule& input = system.modules()[system.modules()[map].inputs.front()];
  if (input.output.rate == Rate::kFrame) {
    return fail(system.at_module(
        {ErrorKind::kUsage,
         "a study requires one input per exploration, but this map receives one per frame",
         {},
         "combine the frames first, for example with 'last'"},
        map));
  }
  prepared.vectors = {vectors_of_map(system, map)};
  if (!description.study.recall.empty()) {
    SOMATO_TRY(prepared.recall,
               find_recall(system, map, description.study.recall, description.where));
    prepared.vectors = vectors_behind(system, *prepared.recall);
  }
  SOMATO_TRY(prepared.predictions,
             find_predictions(system, description.study.predictions, description.where));
  return {};
}

Result<void> append_altered(const StudyDescription& description, PreparedStudy& prepared) {
  const Recording unaltered = prepared.recording;
  for (const Alteration& alteration : description.altered) {
    SOMATO_TRY(auto explorations, altered(unaltered, alteration, description.study.label));
    std::move(explorations.begin(), explorations.end(),
              std::back_inserter(prepared.recording.explorations));
    prepared.alterations.push_back(alteration.name);
  }
  return {};
}

// Modules that every training would otherwise create again.
void keep_fixed(const System& system, PreparedStudy& prepared) {
  const std::size_t input = system.modules()[prepared.map].inputs.front();
  if (std::all_of(prepared.vectors.begin(), prepared.vectors.end(),
                  [&](std::size_t module) { return system.is_fixed(module); })) {
    prepared.fixed_vectors = values_of(prepared.fixed, prepared.vectors);
  }
  if (system.is_fixed(input)) prepared.fixed_inputs = prepared.fixed.values_of(input);
}

}  // namespace

Result<std::size_t> find_map(const System& system, const std::string& name,
                             const std::string& where) {
  std::vector<std::string> candidates;
  for (std::size_t module = 0; module < system.modules().size(); ++module) {
    if (name.empty() ? answers(system, module) : som_of(system, module) != nullptr) {
      candidates.push_back(system.modules()[module].name);
    }
  }
  if (!name.empty()) {
    if (std::find(candidates.begin(), candidates.end(), name) != candidates.end()) {
      return system.find(name);
    }
    return fail(unknown_name("module of type som", name, where, candidates));
  }
  if (candidates.size() == 1) return system.find(candidates.front());
  return fail(
      ErrorKind::kUsage,
      candidates.empty() ? "the system has no output map" : "more than one map could answer", where,
      candidates.empty()
          ? "add a module of type som, or select one with 'map' in [study]"
          : fmt::format("select one of {} with 'map' in [study]", fmt::join(candidates, ", ")));
}

FoldSamples PreparedStudy::divided_by(const std::string& group) const {
  FoldSamples divided = samples;
  if (!group.empty()) divided.groups = groups.at(group);
  return divided;
}

std::vector<std::size_t> PreparedStudy::altered(const std::vector<std::size_t>& explorations,
                                                std::size_t alteration) const {
  const std::size_t unaltered = samples.samples + samples.test_samples;
  std::vector<std::size_t> numbers = explorations;
  for (std::size_t& number : numbers) number += unaltered * (alteration + 1);
  return numbers;
}

std::vector<std::size_t> PreparedStudy::used_by(const Fold& fold) const {
  const std::vector<std::size_t> tested = tested_by(fold);
  std::vector<std::size_t> used;
  std::set_union(fold.training.begin(), fold.training.end(), tested.begin(), tested.end(),
                 std::back_inserter(used));
  return used;
}

std::vector<std::size_t> PreparedStudy::tested_by(const Fold& fold) const {
  std::vector<std::size_t> tested;
  std::merge(fold.test.begin(), fold.test.end(), fold.known.begin(), fold.known.end(),
             std::back_inserter(tested));
  for (std::size_t i = 0; i < alterations.size(); ++i) {
    const std::vector<std::size_t> more = altered(fold.test, i);
    tested.insert(tested.end(), more.begin(), more.end());
  }
  return tested;
}

Result<System> PreparedStudy::system(const StudyDescription& description) const {
  return System::build(description.system, layout);
}

Result<PreparedStudy> prepare_study(const StudyDescription& description, const Recording& whole,
                                    const Recording* test, std::size_t threads) {
  PreparedStudy prepared;
  Recording recording = whole;
  SOMATO_TRY_VOID(keep_only(description.study, recording));
  const std::size_t learned = recording.explorations.size();
  SOMATO_TRY(auto all, join(std::move(recording), test));
  prepared.recording = std::move(all);
  prepared.layout = layout_of(prepared.recording);
  SOMATO_TRY(auto system, prepared.system(description));
  const StudyParameters& study = description.study;
  SOMATO_TRY(const auto individuals, numbers_of(prepared.recording, study.individual));
  Result<void> ready =
      add_labels(study, individuals, prepared)
          .and_then([&] { return check_classes(prepared, study.label, learned); })
          .and_then([&] { return add_order(study, individuals, learned, prepared); })
          .and_then([&] { return divide(study, learned, prepared); })
          .and_then([&] { return find_modules(system, description, prepared); })
          .and_then([&] { return append_altered(description, prepared); });
  if (!ready) return fail(std::move(ready.error()));
  auto fixed = evaluate_fixed(system, prepared.recording, prepared.vectors, threads);
  if (!fixed) return fail(std::move(fixed.error()));
  prepared.fixed = std::move(*fixed);
  keep_fixed(system, prepared);
  return prepared;
}

}  // namespace somato
