#include "studies/question.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "somato/graph/system_model.h"
#include "somato/studies/most_similar.h"
#include "studies/exploration_samples.h"
#include "studies/numbered_individuals.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// Each exploration on its own.
Numbers each_alone(std::size_t explorations) {
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
                {}, "name another label as 'individual', or leave it empty");
  }
  return class_of.size() == classes.names.size() ? each_alone(individuals.size()) : individuals;
}

Result<AskedLabel> ask(const Recording& recording, const std::string& label,
                       const StudyParameters& study, const Numbers& individuals) {
  const auto names = labels_of(recording, label);
  if (!names) return fail(names.error());
  AskedLabel asked{label, Classes::from_names(*names), {}};
  auto dealt = individuals_of(asked.classes, individuals, label, study.individual);
  if (!dealt) return fail(std::move(dealt.error()));
  asked.individuals = std::move(*dealt);
  return asked;
}

Result<void> ask_labels(const StudyParameters& study, const Numbers& individuals,
                        Question& question) {
  std::vector<std::string> names{study.label};
  names.insert(names.end(), study.labels.begin(), study.labels.end());
  for (const std::string& name : names) {
    auto asked = ask(question.recording, name, study, individuals);
    if (!asked) return fail(std::move(asked.error()));
    question.labels.push_back(std::move(*asked));
  }
  return {};
}

// Sizes within their groups are asked like a label: small and large ones of each. What is large
// among what was learned from, is; of others, what is as large as one of these.
AskedLabel ask_size_groups(const AskedOrder& order, const std::vector<std::string>& group_names,
                           std::size_t learned) {
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

Result<void> ask_order(const StudyParameters& study, const Numbers& individuals,
                       std::size_t learned, Question& question) {
  if (study.order.empty()) return {};
  const auto members = numbered_individuals(
      question.recording, {study.individual, study.order, study.within}, individuals);
  if (!members) return fail(members.error());
  if (!has_an_order(*members)) return fail(no_order(study.order));
  AskedOrder order{individuals, {}, {}};
  std::vector<std::string> names;
  for (const NumberedIndividual& member : *members) {
    order.numbers.push_back(member.number);
    names.push_back(member.group);
  }
  const Classes groups = Classes::from_names(names);
  order.groups = groups.of_sample;
  question.labels.push_back(ask_size_groups(order, groups.names, learned));
  question.order = std::move(order);
  return {};
}

// Without the explorations that are not asked about.
Result<void> keep_only(const StudyParameters& study, Recording& recording) {
  if (study.only.empty()) return {};
  const auto labels = labels_of(recording, study.label);
  if (!labels) return fail(labels.error());
  for (const std::string& name : study.only) {
    if (std::find(labels->begin(), labels->end(), name) != labels->end()) continue;
    return fail(unknown_name("value of the label '" + study.label + "'", name, "only",
                             Classes::from_names(*labels).names));
  }
  Recording kept;
  for (std::size_t i = 0; i < labels->size(); ++i) {
    if (std::find(study.only.begin(), study.only.end(), (*labels)[i]) == study.only.end()) continue;
    kept.explorations.push_back(std::move(recording.explorations[i]));
  }
  recording = std::move(kept);
  return {};
}

// The two must be alike, and not only each in itself.
Result<Recording> join(Recording recording, const Recording* test) {
  if (auto valid = validate(recording); !valid) return fail(std::move(valid.error()));
  if (!test) return recording;
  if (auto valid = validate(*test); !valid) return fail(std::move(valid.error()));
  recording.explorations.insert(recording.explorations.end(), test->explorations.begin(),
                                test->explorations.end());
  if (auto valid = validate(recording); !valid) return fail(std::move(valid.error()));
  return recording;
}

// There must be something to tell apart in what is learned from.
Result<void> check_classes(const Question& question, const std::string& label,
                           std::size_t learned) {
  const auto& classes = question.classes().of_sample;
  const auto begin = classes.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(learned);
  if (learned < 2) {
    return fail(ErrorKind::kData, "the recording has only one exploration", {},
                "a study needs at least two");
  }
  if (std::any_of(begin, end, [&](std::size_t its_class) { return its_class != *begin; }))
    return {};
  return fail(ErrorKind::kData, "every exploration has the same '" + label + "'", {},
              "there is nothing to tell apart; name another label");
}

Result<void> divide(const StudyParameters& study, std::size_t learned, Question& question) {
  const std::size_t all = question.recording.explorations.size();
  question.samples.samples = learned;
  question.samples.test_samples = all - learned;
  question.samples.folds = study.folds;
  question.samples.seed = study.first_seed;
  question.samples.classes = question.classes().of_sample;
  question.samples.classes.resize(learned);
  for (const std::string& label : study.groups) {
    auto groups = numbers_of(question.recording, label);
    if (!groups) return fail(std::move(groups.error()));
    groups->resize(learned);
    if (count_different(*groups) < 2) {
      return fail(ErrorKind::kData, "every exploration has the same '" + label + "'", {},
                  "there are no groups to leave out; name another label in 'groups'");
    }
    question.groups[label] = std::move(*groups);
  }
  for (const Protocol protocol : study.protocols) {
    if (protocol == Protocol::kFolds && study.folds > learned) {
      return fail(
          ErrorKind::kData,
          fmt::format("{} explorations cannot be divided into {} parts", learned, study.folds), {},
          "write a smaller number of 'folds' in [study]");
    }
  }
  return {};
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
                          Question& question) {
  const auto map = find_map(system, description.study.map, description.where);
  if (!map) return fail(map.error());
  question.map = *map;
  question.vectors = system.modules()[*map].inputs.front();
  const SystemModule& input = system.modules()[question.vectors];
  if (input.output.rate == Rate::kFrame) {
    return fail(system.at_module({ErrorKind::kUsage,
                                  "a study asks about explorations, and this map has frames coming "
                                  "in",
                                  {},
                                  "put the frames together first, as with 'last'"},
                                 *map));
  }
  if (input.type->name == "standardization") question.vectors = input.inputs.front();
  question.grid = grid_of(system, *map);
  return {};
}

// What every training would put together anew.
void keep_fixed(const System& system, Question& question) {
  const Numbers all = each_alone(question.recording.explorations.size());
  const std::size_t input = system.modules()[question.map].inputs.front();
  if (system.is_fixed(question.vectors)) {
    question.fixed_vectors = values_of(question.fixed, question.vectors, all);
  }
  if (!system.is_fixed(input)) return;
  question.fixed_inputs =
      input == question.vectors ? question.fixed_vectors : values_of(question.fixed, input, all);
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
      candidates.empty() ? "the system has no map that answers" : "more than one map could answer",
      where,
      candidates.empty()
          ? "add a module of type som, or name one with 'map' in [study]"
          : fmt::format("name one of {} with 'map' in [study]", fmt::join(candidates, ", ")));
}

FoldSamples Question::divided_by(const std::string& group) const {
  FoldSamples divided = samples;
  if (!group.empty()) divided.groups = groups.at(group);
  return divided;
}

Result<System> Question::system(const StudyDescription& description) const {
  return System::build(description.system, layout);
}

Result<Question> make_question(const StudyDescription& description, const Recording& whole,
                               const Recording* test, std::size_t threads) {
  Question question;
  Recording recording = whole;
  if (auto kept = keep_only(description.study, recording); !kept) {
    return fail(std::move(kept.error()));
  }
  const std::size_t learned = recording.explorations.size();
  auto all = join(std::move(recording), test);
  if (!all) return fail(std::move(all.error()));
  question.recording = std::move(*all);
  question.layout = layout_of(question.recording);
  auto system = question.system(description);
  if (!system) return fail(std::move(system.error()));
  const StudyParameters& study = description.study;
  const auto individuals = numbers_of(question.recording, study.individual);
  if (!individuals) return fail(individuals.error());
  Result<void> ready =
      ask_labels(study, *individuals, question)
          .and_then([&] { return check_classes(question, study.label, learned); })
          .and_then([&] { return ask_order(study, *individuals, learned, question); })
          .and_then([&] { return divide(study, learned, question); })
          .and_then([&] { return find_modules(*system, description, question); });
  if (!ready) return fail(std::move(ready.error()));
  auto fixed = evaluate_fixed(*system, question.recording, {question.vectors}, threads);
  if (!fixed) return fail(std::move(fixed.error()));
  question.fixed = std::move(*fixed);
  keep_fixed(*system, question);
  return question;
}

}  // namespace somato
