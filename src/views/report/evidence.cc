#include "views/report/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/files/toml_file.h"
#include "somato/graph/evaluation.h"
#include "studies/folds/prepared_study.h"

namespace somato::detail {
namespace {

constexpr const char* kOfModel = "U-matrix, hits, component planes and receptive fields";

void read_study_of(const PartResults& part, Evidence& evidence) {
  const auto table = parse_toml(part.study, "the study of '" + part.system + "'");
  auto study = table ? read_study(*table) : fail(table.error());
  if (study) {
    evidence.study = std::move(*study);
  } else {
    evidence.missing.push_back("The graph of modules is left out: the study cannot be read (" +
                               to_string(study.error()) + ").");
  }
}

void find_model(const ReportFile& file, const ReportSources& sources, Evidence& evidence) {
  const auto& named = evidence.part->model;
  if (!named) {
    evidence.missing.push_back(fmt::format(
        "No trained system was saved with these results, so {} are left out.", kOfModel));
    return;
  }
  auto model = sources.model
                   ? sources.model(file.path, *named)
                   : fail(ErrorKind::kSystem, "trained systems cannot be loaded", named->path);
  if (model) {
    evidence.model = std::move(*model);
    return;
  }
  evidence.missing.push_back(
      fmt::format("The trained system was not found, so {} are left out: put it at the path given "
                  "in results.json, or use --model ({}).",
                  kOfModel, to_string(model.error())));
}

std::string without_recording(const ReportSources& sources) {
  const std::string& named = sources.named_recordings;
  const std::string others =
      named.empty() ? "" : "'" + named + "' is not the one of these results; ";
  return "The recording was not found, so labels of the explorations, hits and sensor readings are "
         "left out: " +
         others + "use --data with the recording, or put it in the folder of results.json.";
}

// The explorations of the study.
std::vector<std::size_t> studied_explorations(const Recording& recording,
                                              const StudyParameters& study) {
  std::vector<std::size_t> studied;
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    const auto label = find_label(recording.explorations[i], study.label);
    const bool is_studied =
        study.only.empty() ||
        (label && std::find(study.only.begin(), study.only.end(), *label) != study.only.end());
    if (is_studied) studied.push_back(i);
  }
  return studied;
}

// Samples of the protocols that test all of them: of all but test_data, and some with test_last.
std::optional<std::size_t> samples_of(const PartResults& part) {
  std::optional<std::size_t> most;
  for (const ProtocolResults& protocol : part.protocols) {
    if (protocol.protocol != "test_data") most = std::max(most.value_or(0), protocol.samples);
  }
  return most;
}

void find_recording(const ReportSources& sources, Evidence& evidence) {
  const PartResults& part = *evidence.part;
  for (std::size_t i = 0; i < part.recordings.size() && !evidence.recording; ++i) {
    if (!sources.recording) continue;
    evidence.recording = sources.recording(part.recordings[i].hash);
    evidence.recording_number = i;
  }
  if (!evidence.recording) {
    evidence.recording_number = 0;
    evidence.missing.push_back(without_recording(sources));
    return;
  }
  const StudyParameters study = evidence.study ? evidence.study->study : StudyParameters{};
  evidence.explorations = studied_explorations(*evidence.recording, study);
  const auto samples = samples_of(part);
  if (!samples || *samples == evidence.explorations.size()) return;
  evidence.missing.push_back(
      fmt::format("The recording has {} explorations for the study, but the results have {} "
                  "samples, so it is left out.",
                  evidence.explorations.size(), *samples));
  evidence.recording = nullptr;
}

void build_system(Evidence& evidence) {
  if (evidence.model || !evidence.study) return;
  const RecordingLayout layout =
      evidence.recording ? layout_of(*evidence.recording) : RecordingLayout{};
  auto built = System::build(evidence.study->system, layout);
  if (built) {
    evidence.built = std::move(*built);
  } else {
    evidence.missing.push_back("The graph of modules is left out (" + to_string(built.error()) +
                               "): use --data with the recording.");
  }
}

void find_answering_map(Evidence& evidence) {
  const System* system = evidence.system();
  if (!system) return;
  std::string name = evidence.study ? evidence.study->study.map : std::string();
  if (evidence.model && evidence.model->model.answer) name = evidence.model->model.answer->map;
  if (const auto map = find_map(*system, name, {})) evidence.map = *map;
}

Result<Samples> inputs_of(const Evidence& evidence, std::size_t threads) {
  const System& system = *evidence.system();
  const Recording& recording = *evidence.recording;
  const std::size_t input = system.modules()[*evidence.map].inputs.front();
  Activations activations(system.modules().size(), recording.explorations.size());
  SOMATO_TRY_VOID(
      evaluate(system, recording, evidence.explorations, {input}, threads, activations));
  SampleCollector inputs;
  for (const std::size_t exploration : evidence.explorations) {
    const Samples& values = activations.find(input, exploration)->values;
    inputs.add(values[values.count() - 1]);
  }
  return inputs.samples();
}

}  // namespace

const System* Evidence::system() const {
  if (model) return &model->model.system;
  return built ? &*built : nullptr;
}

Evidence find_evidence(const ReportFile& file, const PartResults& part,
                       const ReportSources& sources) {
  Evidence evidence;
  evidence.part = &part;
  read_study_of(part, evidence);
  find_model(file, sources, evidence);
  find_recording(sources, evidence);
  build_system(evidence);
  find_answering_map(evidence);
  return evidence;
}

void read_inputs(Evidence& evidence, std::size_t threads) {
  if (!evidence.model || !evidence.map || !evidence.recording) return;
  auto inputs = inputs_of(evidence, threads);
  if (inputs) {
    evidence.inputs = std::move(*inputs);
    return;
  }
  evidence.missing.push_back(
      "The samples on the saved map are left out, because the trained system cannot be run on the "
      "recording (" +
      to_string(inputs.error()) + ").");
}

}  // namespace somato::detail
