#include "views/live/chosen_system.h"

#include <algorithm>

namespace somato::live {

ChosenSystem::ChosenSystem(ViewSource& source, Replay& replay)
    : source_(source), replay_(replay), number_(source.system), teachers_(source) {}

const ViewSystem* ChosenSystem::system() const {
  return number_ ? &source_.systems[*number_] : nullptr;
}

Result<void> ChosenSystem::choose(const std::string& name) {
  const auto found = std::find_if(source_.systems.begin(), source_.systems.end(),
                                  [&](const ViewSystem& one) { return one.name == name; });
  if (found == source_.systems.end()) return fail(ErrorKind::kUsage, "unknown system");
  number_ = static_cast<std::size_t>(found - source_.systems.begin());
  use();
  return {};
}

void ChosenSystem::use() {
  const Recording& recording = source_.recording;
  replay_.choose(system(), recording.explorations.empty() ? std::optional<RecordingLayout>()
                                                          : layout_of(recording));
}

void ChosenSystem::take_trained(const std::string& name,
                                const std::shared_ptr<const SystemModel>& model) {
  for (ViewSystem& one : source_.systems) {
    if (one.name != name) continue;
    one.trained = model;
    teachers_.drop(static_cast<std::size_t>(&one - source_.systems.data()));
  }
  if (system() != nullptr && system()->name == name) use();
}

bool ChosenSystem::teaches() const {
  return number_ && teachers_.can_teach(*number_) && replay_.reader().model() != nullptr;
}

std::optional<std::string> ChosenSystem::answered_label() const {
  return teaches() ? std::optional(system()->trained->answer->label) : std::nullopt;
}

const TaughtName& ChosenSystem::teach(std::size_t exploration, const std::string& name) {
  const TaughtName& taught = teachers_.teach(*number_, exploration, name);
  use();
  return taught;
}

void ChosenSystem::take_back(const GivenName& name) {
  teachers_.take_back(name);
  use();
}

std::vector<TaughtName> ChosenSystem::taught_names() const {
  return number_ ? teachers_.names(*number_) : std::vector<TaughtName>();
}

bool ChosenSystem::is_taught(std::size_t exploration) const {
  return number_ && teachers_.is_taught(*number_, exploration);
}

bool ChosenSystem::answers_unknown() const {
  const Reading* reading = teaches() ? replay_.reader().latest() : nullptr;
  return reading != nullptr && reading->novelty && is_unknown(*reading->novelty);
}

void ChosenSystem::forget() {
  teachers_.forget();
  use();
}

}  // namespace somato::live
