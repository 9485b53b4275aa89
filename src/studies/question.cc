#include "studies/question.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "somato/codes/standardization.h"
#include "somato/studies/nearest_neighbour.h"

namespace somato {
namespace {

Result<std::vector<std::string>> labels_of(const Recording& recording, const std::string& name) {
  std::vector<std::string> labels;
  for (const Exploration& exploration : recording.explorations) {
    Result<std::string> label = find_label(exploration, name);
    if (!label) return fail(std::move(label.error()));
    labels.push_back(std::move(*label));
  }
  return labels;
}

Result<std::vector<std::size_t>> individuals_of(const Recording& recording,
                                                const std::string& name) {
  std::vector<std::size_t> individuals;
  if (name.empty()) {
    for (std::size_t i = 0; i < recording.explorations.size(); ++i) individuals.push_back(i);
    return individuals;
  }
  return labels_of(recording, name).map([](const std::vector<std::string>& labels) {
    return Classes::from_names(labels).of_sample;
  });
}

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

Result<Standardization> standardize_on(const Question& question, const VectorParameters& parameters,
                                       const std::vector<std::size_t>& training) {
  // The baseline alone must not refuse what the map takes as it is.
  const ConstantColumns constant =
      parameters.standardize ? parameters.constant_columns : ConstantColumns::kZero;
  return Standardization::fit(question.vectors.samples.subset(training), {constant},
                              question.vectors.element_names);
}

Result<PreparedFold> prepare_fold(const Question& question, const VectorParameters& parameters,
                                  Fold fold) {
  const Samples& raw = question.vectors.samples;
  PreparedFold prepared{std::move(fold), raw, {}, {}};
  const std::vector<std::size_t>& training = prepared.fold.training;
  std::optional<Samples> standardized;
  if (training.size() >= 2) {
    auto standardization = standardize_on(question, parameters, training);
    if (!standardization) return fail(std::move(standardization.error()));
    standardized = standardization->apply(raw);
  }
  const Samples& comparable = standardized ? *standardized : raw;
  for (const std::size_t sample : prepared.fold.test) {
    prepared.raw_baseline.push_back(
        nearest_neighbour_class(raw, training, sample, question.classes.of_sample));
    prepared.standardized_baseline.push_back(
        nearest_neighbour_class(comparable, training, sample, question.classes.of_sample));
  }
  if (parameters.standardize) prepared.samples = comparable;
  return prepared;
}

}  // namespace

Result<Question> make_question(const StudyDescription& description, const Recording& recording) {
  if (auto valid = validate(recording); !valid) return fail(std::move(valid.error()));
  auto labels = labels_of(recording, description.study.label);
  if (!labels) return fail(std::move(labels.error()));
  auto individuals = individuals_of(recording, description.study.individual);
  if (!individuals) return fail(std::move(individuals.error()));
  auto vectors = make_vectors(recording, description.vector);
  if (!vectors) return fail(std::move(vectors.error()));
  Question question{std::move(*vectors), Classes::from_names(*labels), std::move(*individuals)};
  if (question.vectors.samples.count() < 2) {
    return fail(ErrorKind::kData, "the recording has only one exploration", {},
                "a study needs at least two");
  }
  if (question.classes.names.size() < 2) {
    return fail(ErrorKind::kData,
                "every exploration has the same '" + description.study.label + "'", {},
                "there is nothing to tell apart; name another label");
  }
  if (auto whole = check_individuals(question, description.study); !whole) {
    return fail(std::move(whole.error()));
  }
  return question;
}

Result<std::vector<PreparedFold>> prepare_folds(const Question& question,
                                                const VectorParameters& parameters,
                                                Protocol protocol) {
  std::vector<PreparedFold> prepared;
  for (Fold& fold : folds(protocol, question.vectors.samples.count())) {
    auto ready = prepare_fold(question, parameters, std::move(fold));
    if (!ready) return fail(std::move(ready.error()));
    prepared.push_back(std::move(*ready));
  }
  return prepared;
}

}  // namespace somato
