#include "recordings/file/exploration_log.h"

#include <algorithm>
#include <utility>

namespace somato {

Result<void> ExplorationLog::say(ExplorationMessage::Event event, std::uint64_t time) {
  const McapSchema schema = exploration_schema();
  SOMATO_TRY(const std::uint16_t id, file_->channel(&schema, exploration_channel()));
  ExplorationMessage message = *open_;
  message.event = event;
  const std::string json = exploration_json(message);
  if (event != ExplorationMessage::Event::kEnd) {
    for (const std::uint16_t channel : channels_) file_->announce(channel);
  }
  const McapMessage said{id, static_cast<std::uint32_t>(message.index), time, time, json};
  const bool is_continued = event == ExplorationMessage::Event::kContinue;
  return is_continued ? file_->add_before_another(said) : file_->add(said);
}

Result<void> ExplorationLog::begin(ExplorationMessage message, std::vector<std::uint16_t> channels,
                                   std::uint64_t time) {
  open_ = std::move(message);
  channels_ = std::move(channels);
  return say(ExplorationMessage::Event::kBegin, time);
}

Result<void> ExplorationLog::add(const McapMessage& message) {
  const std::uint64_t time = std::max(file_->latest_time(), message.log_time);
  Result<void> said = is_open() && file_->chunk_is_empty()
                          ? say(ExplorationMessage::Event::kContinue, time)
                          : Result<void>();
  if (!said) return said;
  return file_->add(message);
}

Result<void> ExplorationLog::end() {
  Result<void> said = say(ExplorationMessage::Event::kEnd, file_->latest_time());
  open_.reset();
  return said;
}

}  // namespace somato
