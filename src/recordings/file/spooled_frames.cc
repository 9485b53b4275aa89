#include "recordings/file/spooled_frames.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace somato {
namespace {

// Precedes the values of a frame; the bytes never leave the process.
struct FrameHead {
  double time = 0.0;
  std::size_t channel = 0;
  std::size_t values = 0;
  std::size_t marks = 0;  // Marks of validity: as many as values, or none.
};

template <typename T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

template <typename T>
Result<void> read_values(Spool& spool, std::vector<T>& values, std::size_t count) {
  values.resize(count);
  return spool.read(reinterpret_cast<char*>(values.data()), count * sizeof(T));
}

}  // namespace

Result<void> SpooledFrames::add(std::size_t channel, std::span<const float> values, double time,
                                std::span<const std::uint8_t> valid) {
  earliest_ = spool_.unread() == 0 ? time : std::min(earliest_, time);
  const FrameHead head{time, channel, values.size(), valid.size()};
  SOMATO_TRY_VOID(spool_.write(bytes_of(std::span(&head, 1))));
  SOMATO_TRY_VOID(spool_.write(bytes_of(values)));
  return spool_.write(bytes_of(valid));
}

Result<void> SpooledFrames::hand_frame(FrameSink& to) {
  FrameHead head;
  SOMATO_TRY_VOID(spool_.read(reinterpret_cast<char*>(&head), sizeof head));
  SOMATO_TRY_VOID(read_values(spool_, values_, head.values));
  SOMATO_TRY_VOID(read_values(spool_, valid_, head.marks));
  return to.frame(head.channel, values_, head.time, valid_);
}

Result<void> SpooledFrames::hand_over(ExplorationStart start, FrameSink& to) {
  start.time = earliest_;
  Result<void> handed = to.begin_exploration(start);
  while (handed && spool_.unread() > 0) handed = hand_frame(to);
  if (handed) handed = to.end_exploration();
  spool_.clear();
  return handed;
}

}  // namespace somato
