#include "studies/lifelong/grasp_vectors.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "somato/core/signal.h"

namespace somato {
namespace {

using Vector = std::vector<float>;

// A row of several channels that are recorded together.
class JoinedChannels {
 public:
  static Result<JoinedChannels> find(const Exploration& exploration,
                                     const std::vector<std::string>& names) {
    JoinedChannels joined;
    for (const std::string& name : names) {
      SOMATO_TRY(const auto channel, find_channel(exploration, name));
      joined.channels_.push_back(channel);
    }
    return joined;
  }

  std::size_t frames() const { return channels_.empty() ? 0 : channels_.front()->frames.rows(); }
  bool has_frames(std::size_t count) const {
    for (const Channel* channel : channels_) {
      if (channel->frames.rows() != count) return false;
    }
    return !channels_.empty();
  }

  Vector row(std::size_t frame) const {
    Vector values;
    for (const Channel* channel : channels_) {
      const auto row = channel->frames.row(frame);
      values.insert(values.end(), row.begin(), row.end());
    }
    return values;
  }

 private:
  std::vector<const Channel*> channels_;
};

struct Grasp {
  Vector pose;
  Vector read;
};

bool is_near(const Vector& a, const Vector& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(double{a[i]} - double{b[i]}) > tolerance) return false;
  }
  return a.size() == b.size();
}

Result<std::vector<Grasp>> grasps_of(const Exploration& exploration,
                                     const GraspChannels& channels) {
  SOMATO_TRY(const auto pose, JoinedChannels::find(exploration, channels.pose));
  SOMATO_TRY(const auto read, JoinedChannels::find(exploration, channels.read));
  const std::size_t frames = pose.frames();
  if (frames == 0 || !pose.has_frames(frames) || !read.has_frames(frames)) {
    return fail(ErrorKind::kData, "the channels of poses and readings are not recorded together",
                exploration.source, "choose channels with the same number of frames");
  }
  std::vector<Grasp> grasps;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    Vector now = pose.row(frame);
    if (grasps.empty() || !is_near(grasps.back().pose, now, channels.tolerance)) {
      grasps.push_back({std::move(now), {}});
    }
    grasps.back().read = read.row(frame);
  }
  return grasps;
}

Result<void> check_alike(const std::vector<Grasp>& grasps, const std::vector<Grasp>& first,
                         double tolerance, const std::string& where) {
  bool alike = grasps.size() == first.size();
  for (std::size_t i = 0; alike && i < grasps.size(); ++i) {
    alike = is_near(grasps[i].pose, first[i].pose, tolerance);
  }
  if (alike) return {};
  return fail(
      ErrorKind::kData,
      fmt::format("the exploration does not have the {} grasps of the first one", first.size()),
      where, "use explorations with the same poses in the same order");
}

}  // namespace

Result<std::vector<Samples>> grasp_vectors(const Recording& recording,
                                           const GraspChannels& channels) {
  std::vector<std::vector<Grasp>> explorations;
  for (const Exploration& exploration : recording.explorations) {
    SOMATO_TRY(auto grasps, grasps_of(exploration, channels));
    explorations.push_back(std::move(grasps));
    SOMATO_TRY_VOID(check_alike(explorations.back(), explorations.front(), channels.tolerance,
                                exploration.source));
  }
  std::vector<Samples> vectors;
  for (std::size_t grasp = 0; !explorations.empty() && grasp < explorations.front().size();
       ++grasp) {
    std::vector<Signal> signals;
    signals.reserve(explorations.size());
    for (const auto& grasps : explorations) signals.push_back(Signal::dense(grasps[grasp].read));
    vectors.push_back(Samples::from_signals(signals));
  }
  return vectors;
}

}  // namespace somato
