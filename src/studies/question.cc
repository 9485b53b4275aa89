#include "studies/question.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "somato/graph/system_model.h"
#include "studies/exploration_samples.h"

namespace somato {
namespace {

// Individuals are dealt to classes as wholes, so each must belong to one.
Result<void> check_individuals(const Question& question, const StudyParameters& parameters) {
  std::map<std::size_t, std::size_t> class_of;
  for (std::size_t i = 0; i < question.individuals.size(); ++i) {
    const std::size_t its_class = question.classes.of_sample[i];
    if (class_of.emplace(question.individuals[i], its_class).first->second == its_class) continue;
    return fail(ErrorKind::kData,
                "explorations with the same '" + parameters.individual + "' differ in '" +
                    parameters.label + "'",
                {}, "name another label as 'individual', or leave it empty");
  }
  return {};
}

// The two must be alike, and not only each in itself.
Result<Recording> join(const Recording& recording, const Recording* test) {
  Recording all = recording;
  if (test) {
    all.explorations.insert(all.explorations.end(), test->explorations.begin(),
                            test->explorations.end());
  }
  for (const Recording* part : {&recording, test, static_cast<const Recording*>(&all)}) {
    if (!part) continue;
    if (auto valid = validate(*part); !valid) return fail(std::move(valid.error()));
  }
  return all;
}

// There must be something to tell apart in what is learned from.
Result<void> check_classes(const Question& question, const std::string& label,
                           std::size_t learned) {
  const auto& classes = question.classes.of_sample;
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
  question.samples.classes = question.classes.of_sample;
  question.samples.classes.resize(learned);
  auto groups = numbers_of(question.recording, study.group);
  if (!groups) return fail(std::move(groups.error()));
  question.samples.groups = std::move(*groups);
  question.samples.groups.resize(learned);
  const auto& first = question.samples.groups.front();
  for (const Protocol protocol : study.protocols) {
    if (protocol == Protocol::kFolds && study.folds > learned) {
      return fail(
          ErrorKind::kData,
          fmt::format("{} explorations cannot be divided into {} parts", learned, study.folds), {},
          "write a smaller number of 'folds' in [study]");
    }
    if (protocol == Protocol::kLeaveGroupOut &&
        std::count(question.samples.groups.begin(), question.samples.groups.end(), first) ==
            static_cast<std::ptrdiff_t>(learned)) {
      return fail(ErrorKind::kData, "every exploration has the same '" + study.group + "'", {},
                  "there are no groups to leave out; name another label as 'group'");
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
  return {};
}

}  // namespace

Result<System> Question::system(const StudyDescription& description) const {
  return System::build(description.system, layout);
}

Result<Question> make_question(const StudyDescription& description, const Recording& recording,
                               const Recording* test, std::size_t threads) {
  Question question;
  auto all = join(recording, test);
  if (!all) return fail(std::move(all.error()));
  question.recording = std::move(*all);
  question.layout = layout_of(question.recording);
  auto system = question.system(description);
  if (!system) return fail(std::move(system.error()));
  auto labels = labels_of(question.recording, description.study.label);
  if (!labels) return fail(std::move(labels.error()));
  question.classes = Classes::from_names(*labels);
  auto individuals = numbers_of(question.recording, description.study.individual);
  if (!individuals) return fail(std::move(individuals.error()));
  question.individuals = std::move(*individuals);
  const std::size_t learned = recording.explorations.size();
  Result<void> ready = check_classes(question, description.study.label, learned)
                           .and_then([&] { return check_individuals(question, description.study); })
                           .and_then([&] { return divide(description.study, learned, question); })
                           .and_then([&] { return find_modules(*system, description, question); });
  if (!ready) return fail(std::move(ready.error()));
  auto fixed = evaluate_fixed(*system, question.recording, {question.vectors}, threads);
  if (!fixed) return fail(std::move(fixed.error()));
  question.fixed = std::move(*fixed);
  return question;
}

}  // namespace somato
