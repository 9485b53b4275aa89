#include "views/replay/live_reader.h"

#include <algorithm>
#include <utility>

namespace somato::live {

void LiveReader::choose(const ViewSystem* system, const std::optional<RecordingLayout>& layout) {
  picture_ = system != nullptr ? picture_of(*system, layout) : SystemPicture{};
  problem_ = picture_.problem;
  reading_.reset();
  latest_.reset();
  error_.reset();
  if (system == nullptr || !system->trained || !problem_.empty()) return;
  auto reading = SystemReading::build(system->trained);
  if (!reading) return keep(reading.error());
  reading_ = std::make_unique<SystemReading>(std::move(*reading));
  reading_->limit_memory(most_memory_);
  start();
}

void LiveReader::start() {
  latest_.reset();
  error_.reset();
  is_said_ = false;
  said_at_ = {};
  problem_ = picture_.problem;
  if (reading_) reading_->start();
}

void LiveReader::follow(const Exploration& exploration, const std::vector<std::size_t>& frames,
                        const std::vector<std::size_t>& dropped) {
  if (!reading_ || !problem_.empty()) return;
  is_said_ = false;
  if (auto followed = reading_->follow(exploration, frames, dropped); !followed)
    keep(followed.error());
}

void LiveReader::give_up() {
  latest_.reset();
  problem_ = "The beginning of this exploration is no longer kept (--page-memory).";
}

const Reading* LiveReader::read(bool now) {
  constexpr Clock::duration kPatience = std::chrono::milliseconds(250);
  if (!reading_ || !problem_.empty()) return nullptr;
  const bool is_due =
      now || !reading_->is_costly() || Clock::now() - said_at_ >= std::max(kPatience, 10 * took_);
  if (!is_due || is_said_) return latest_ ? &*latest_ : nullptr;
  const auto begun = Clock::now();
  auto read = reading_->read();
  said_at_ = Clock::now();
  took_ = said_at_ - begun;
  is_said_ = true;
  // A costly system may need more of the exploration than there is yet.
  latest_ = read ? std::move(*read) : std::nullopt;
  return latest_ ? &*latest_ : nullptr;
}

void LiveReader::keep(const Error& error) {
  problem_ = sentence_of(error);
  error_ = error;
  latest_.reset();
}

}  // namespace somato::live
