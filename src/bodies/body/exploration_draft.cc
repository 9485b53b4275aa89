#include "bodies/body/exploration_draft.h"

#include <algorithm>
#include <utility>

#include "bodies/body/driving.h"

namespace somato {
// As the exploration will have them: the frames have times, and no rate.
void ExplorationDraft::begin(const BodyDescription& body, std::vector<Label> labels) {
  is_open_ = false;
  start_ = {std::move(labels), body.name, {}};
  sensors_.clear();
  for (const ChannelDescription& sensor : body.sensors) {
    sensors_.push_back({sensor.rate, detail::empty_channel(sensor).frames.columns()});
    start_.channels.push_back(sensor);
    start_.channels.back().times_known = sensor.times_known || sensor.rate > 0.0;
    start_.channels.back().rate = 0.0;
  }
}

Result<void> ExplorationDraft::open(const BodyState& state) {
  start_.time = state.time;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const FrameTimes times(state, i, sensors_[i].rate);
    if (state.readings[i].rows() == 0 || !times.are_complete()) continue;
    start_.time = std::min(start_.time, times[0]);
  }
  is_open_ = true;
  return to_->begin_draft(start_);
}

Result<void> ExplorationDraft::append(const BodyState& state) {
  if (state.readings.size() != sensors_.size()) return {};
  if (!is_open_) SOMATO_TRY_VOID(open(state));
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    SOMATO_TRY_VOID(append(i, state.readings[i], {state, i, sensors_[i].rate}));
  }
  return {};
}

Result<void> ExplorationDraft::append(std::size_t index, const Matrix<float>& frames,
                                      const FrameTimes& times) {
  Sensor& sensor = sensors_[index];
  if (frames.rows() == 0 || frames.columns() == 0) return {};
  if (sensor.elements == 0) sensor.elements = frames.columns();
  if (sensor.elements != frames.columns() || !times.are_complete()) return {};
  for (std::size_t i = 0; i < frames.rows(); ++i) {
    sensor.latest = std::max({sensor.latest, start_.time, times[i]});
    SOMATO_TRY_VOID(to_->draft_frame(index, frames.row(i), sensor.latest));
  }
  return {};
}

}  // namespace somato
