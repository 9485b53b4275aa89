#include "report/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "report/rebuilt_study.h"
#include "studies/question.h"
#include "studies/settings.h"

namespace somato::detail {
namespace {

std::string without_model(const ReportFile& file, const PartResults& part) {
  const std::string what =
      "The trained system is not at hand, so U-matrix, hits, component planes and receptive fields "
      "are left out: ";
  const std::string advice = file.results.is_study
                                 ? "give system.somato, which 'somato run' writes, with --model."
                                 : "'somato run' writes a trained system; give one of '" +
                                       part.system + "' with these settings with --model.";
  if (file.models.empty()) return what + advice;
  const std::string others = file.models.size() > 1 ? "' and others have" : "' has";
  return what + "'" + file.models.front()->path + others + " other settings; " + advice;
}

void find_model(const ReportFile& file, Evidence& evidence) {
  for (const auto& model : file.models) {
    if (same_system(system_settings(model->model.system), evidence.part->settings)) {
      evidence.model = model;
      return;
    }
  }
  evidence.missing.push_back(without_model(file, *evidence.part));
}

std::string without_recording(const Evidence& evidence, const std::string& named) {
  const std::string what =
      "The recording is not at hand, so labels of the explorations, hits and what the sensors told "
      "are left out: ";
  const std::string others =
      named.empty() ? "" : "'" + named + "' is not what these results are of; ";
  return what + others +
         (evidence.file->is_study
              ? "give it with --data, or put it beside results.json."
              : "leave the folder 'recordings' beside results.json, or give --data.");
}

// Those that the study asks about.
std::vector<std::size_t> asked_of(const Recording& recording, const StudyParameters& study) {
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    const auto label = find_label(recording.explorations[i], study.label);
    const bool is_asked =
        study.only.empty() ||
        (label && std::find(study.only.begin(), study.only.end(), *label) != study.only.end());
    if (is_asked) asked.push_back(i);
  }
  return asked;
}

// Samples of all protocols but those that test with another recording.
std::optional<std::size_t> samples_of(const PartResults& part) {
  for (const SystemResults& protocol : part.protocols) {
    if (protocol.protocol != "test_data") return protocol.samples;
  }
  return {};
}

void find_recording(const ReportSources& sources, Evidence& evidence) {
  const PartResults& part = *evidence.part;
  for (std::size_t i = 0; i < part.recordings.size() && !evidence.recording; ++i) {
    const RecordingInfo* info = evidence.file->find_recording(part.recordings[i]);
    if (!info || !sources.recording) continue;
    ReportRecording found = sources.recording(info->data_hash);
    evidence.recording = std::move(found.recording);
    evidence.recording_name = std::move(found.name);
    evidence.recording_number = i;
  }
  if (!evidence.recording) {
    evidence.missing.push_back(without_recording(evidence, sources.named_recordings));
    return;
  }
  const StudyParameters asked = evidence.study ? evidence.study->study : StudyParameters{};
  evidence.explorations = asked_of(*evidence.recording, asked);
  const auto samples = samples_of(part);
  if (!samples || *samples == evidence.explorations.size()) return;
  evidence.missing.push_back(fmt::format(
      "The recording has {} explorations to ask about where the results have {} samples, so it is "
      "left out.",
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
                               "): give the recording with --data.");
  }
}

void find_answering_map(Evidence& evidence) {
  const System* system = evidence.system();
  if (!system) return;
  std::string name = evidence.study ? evidence.study->study.map : std::string();
  if (evidence.model && evidence.model->model.answer) name = evidence.model->model.answer->map;
  if (const auto map = find_map(*system, name, {})) evidence.map = *map;
}

}  // namespace

const System* Evidence::system() const {
  if (model) return &model->model.system;
  return built ? &*built : nullptr;
}

Evidence find_evidence(const ReportFile& file, const PartResults& part,
                       const ReportSources& sources) {
  Evidence evidence;
  evidence.file = &file.results;
  evidence.part = &part;
  evidence.missing = file.missing;
  if (auto study = rebuilt_study(part.settings)) {
    evidence.study = std::move(*study);
  } else {
    evidence.missing.push_back("The graph of modules is left out: its settings cannot be read (" +
                               to_string(study.error()) + ").");
  }
  find_model(file, evidence);
  find_recording(sources, evidence);
  build_system(evidence);
  find_answering_map(evidence);
  return evidence;
}

}  // namespace somato::detail
