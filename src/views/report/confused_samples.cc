#include "views/report/confused_samples.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "studies/results/main_result.h"

namespace somato::detail {
namespace {

bool tests_all(const Run& run, std::size_t samples) {
  return run.labels.size() == samples && run.predictions.size() == samples;
}

// The protocol of the main result with the runs that tested all samples of the recording.
ProtocolResults tests_at_hand(const Evidence& evidence) {
  const PartResults& part = *evidence.part;
  ProtocolResults tests;
  const auto result = main_result(part);
  if (!result || part.protocols[result->protocol].protocol == "test_data") return tests;
  const ProtocolResults& protocol = part.protocols[result->protocol];
  for (std::size_t i = 0; i < protocol.runs.size(); ++i) {
    const Run& run = protocol.runs[i];
    const bool is_of_recording =
        i < part.pairs.size() && part.pairs[i].recording == evidence.recording_number;
    if (is_of_recording && tests_all(run, evidence.explorations.size())) tests.runs.push_back(run);
  }
  return tests;
}

std::size_t confused_as(const ProtocolResults& tests, std::size_t sample,
                        const std::string& predicted) {
  return static_cast<std::size_t>(
      std::count_if(tests.runs.begin(), tests.runs.end(), [&](const Run& run) {
        return run.labels[sample] != predicted && run.predictions[sample] == predicted;
      }));
}

bool is_listed(const std::vector<TestedSample>& listed, std::size_t sample) {
  return std::any_of(listed.begin(), listed.end(),
                     [&](const TestedSample& one) { return one.sample == sample; });
}

// The sample of a confusion that is not listed yet.
std::optional<TestedSample> sample_of(const Confusion& confusion, const ProtocolResults& tests,
                                      const std::vector<TestedSample>& listed) {
  std::optional<TestedSample> most;
  const std::vector<std::string>& labels = tests.runs.front().labels;
  for (std::size_t sample = 0; sample < labels.size(); ++sample) {
    if (labels[sample] != confusion.label || is_listed(listed, sample)) continue;
    const std::size_t confused = confused_as(tests, sample, confusion.predicted);
    if (confused <= (most ? most->confused : 0)) continue;
    most = TestedSample{sample, tests.runs.size(), confusion.predicted, confused};
  }
  return most;
}

}  // namespace

TestedSample tests_of(const Evidence& evidence, std::size_t sample) {
  const ProtocolResults tests = tests_at_hand(evidence);
  TestedSample tested{sample, tests.runs.size(), {}, 0};
  std::map<std::string, std::size_t> wrong;
  for (const Run& run : tests.runs) {
    if (run.predictions[sample] != run.labels[sample]) ++wrong[run.predictions[sample]];
  }
  for (const auto& [predicted, count] : wrong) {
    if (count <= tested.confused) continue;
    tested.predicted = predicted;
    tested.confused = count;
  }
  return tested;
}

std::vector<TestedSample> confused_samples(const Evidence& evidence, std::size_t most) {
  const ProtocolResults tests = tests_at_hand(evidence);
  std::vector<TestedSample> listed;
  for (const Confusion& confusion : confusions(tests, most)) {
    if (auto one = sample_of(confusion, tests, listed)) listed.push_back(std::move(*one));
  }
  return listed;
}

}  // namespace somato::detail
