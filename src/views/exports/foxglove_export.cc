#include "views/exports/foxglove_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/explorations/exploration_frames.h"
#include "views/exports/scene_messages.h"

namespace somato {
namespace {

constexpr const char* kTouch = "touch";
constexpr std::int64_t kShortestStep = 10'000'000;        // ns between poses: 100 a second.
constexpr std::array<double, 3> kTouched{1.0, 0.2, 0.0};  // The colour of the largest force.

// The frames of the bodies: those of ROS have no slash at the beginning, and none is the world's.
std::vector<std::string> frames_of(const Scene& scene) {
  std::vector<std::string> frames;
  frames.reserve(scene.bodies.size());
  for (const std::string& body : scene.bodies) frames.push_back("body/" + body);
  return frames;
}

std::size_t longest_channel(const Exploration& exploration) {
  const auto longest = std::max_element(
      exploration.channels.begin(), exploration.channels.end(),
      [](const Channel& a, const Channel& b) { return a.frames.rows() < b.frames.rows(); });
  return static_cast<std::size_t>(longest - exploration.channels.begin());
}

float largest_value(const Channel& channel) {
  float largest = 0.0F;
  for (const float value : channel.frames.values()) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

// Writes the frames of an exploration to the bag, each followed by what the scene shows of it.
class FoxgloveExport::ScenedFrames final : public FrameSink {
 public:
  ScenedFrames(BagExport& bag, const SceneTopics& topics, const Exploration& exploration,
               ScenePlayer& player)
      : bag_(&bag),
        topics_(&topics),
        exploration_(&exploration),
        player_(&player),
        bodies_(frames_of(player.scene())),
        posed_(longest_channel(exploration)),
        poses_(player.poses(exploration, 0)) {
    for (const SceneGeom& geom : player.scene().geoms) {
      (geom.taxel ? taxels_ : shapes_).push_back(geom);
    }
  }

  Result<void> begin_exploration(const ExplorationStart& start) override {
    SOMATO_TRY_VOID(bag_->begin_exploration(start));
    const std::int64_t time = bag_->frame_time();
    return bag_->bag().write(topics_->scene, time, scene_update_message(time, bodies_, shapes_));
  }

  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) override {
    SOMATO_TRY_VOID(bag_->frame(channel, values, time, valid));
    if (channel == posed_) SOMATO_TRY_VOID(write_poses());
    if (exploration_->channels[channel].name != kTouch || taxels_.empty()) return {};
    return write_taxels(values, largest_value(exploration_->channels[channel]));
  }

  Result<void> end_exploration() override { return bag_->end_exploration(); }

 private:
  // A sound has more frames than a viewer can show.
  Result<void> write_poses() {
    const std::size_t frame = posed_frames_++;
    const std::int64_t time = bag_->frame_time();
    if (frame > 0 && time < latest_pose_ + kShortestStep) return {};
    latest_pose_ = time;
    poses_ = player_->poses(*exploration_, frame);
    return bag_->bag().write(topics_->transforms, time, transforms_message(time, bodies_, poses_));
  }

  Result<void> write_taxels(std::span<const float> values, float largest) {
    std::vector<SceneGeom> touched = taxels_;
    std::vector<ValuedPoint> points;
    points.reserve(taxels_.size());
    for (std::size_t i = 0; i < taxels_.size(); ++i) {
      const SceneGeom& taxel = taxels_[i];
      const float value = *taxel.taxel < values.size() ? values[*taxel.taxel] : 0.0F;
      const double share = largest > 0.0F ? std::abs(value) / largest : 0.0;
      for (std::size_t part = 0; part < kTouched.size(); ++part) {
        touched[i].colour[part] = (1.0 - share) * taxel.colour[part] + share * kTouched[part];
      }
      const ScenePose body = taxel.body ? poses_[*taxel.body] : ScenePose{};
      points.push_back({position_in_world(body, taxel.pose.position), value});
    }
    const std::int64_t time = bag_->frame_time();
    SOMATO_TRY_VOID(
        bag_->bag().write(topics_->taxels, time, scene_update_message(time, bodies_, touched)));
    return bag_->bag().write(topics_->points, time, point_cloud_message(time, points));
  }

  BagExport* bag_;
  const SceneTopics* topics_;
  const Exploration* exploration_;
  ScenePlayer* player_;
  std::vector<std::string> bodies_;
  std::vector<SceneGeom> shapes_;
  std::vector<SceneGeom> taxels_;
  std::size_t posed_;             // The channel whose frames have poses.
  std::size_t posed_frames_ = 0;  // Its frames so far.
  std::int64_t latest_pose_ = 0;  // The time of poses_, ns.
  std::vector<ScenePose> poses_;
};

Result<std::unique_ptr<RecordingExport>> FoxgloveExport::begin(const std::string& path,
                                                               SceneFinder scenes) {
  SOMATO_TRY(auto writer, BagWriter::begin(path));
  return std::make_unique<FoxgloveExport>(std::move(writer), std::move(scenes));
}

Result<void> FoxgloveExport::open_scene_topics(const Scene& scene) {
  if (topics_) return {};
  BagWriter& bag = bag_.bag();
  topics_.emplace();
  SOMATO_TRY(topics_->scene, bag.open_topic("/scene", scene_update_schema()));
  SOMATO_TRY(topics_->transforms, bag.open_topic("/tf", transforms_schema()));
  SOMATO_TRY(topics_->taxels, bag.open_topic("/taxels", scene_update_schema()));
  SOMATO_TRY(topics_->points, bag.open_topic("/taxel_points", point_cloud_schema()));
  shown_.emplace(
      ShownScene{{"/scene", "/taxels"}, "/taxel_points", 0.0F, scene.camera, scene.target});
  return {};
}

Result<void> FoxgloveExport::add(const Exploration& exploration) {
  const std::unique_ptr<ScenePlayer> player = scenes_ ? scenes_(exploration) : nullptr;
  if (player == nullptr) {
    SOMATO_TRY_VOID(hand_frames(exploration, bag_));
  } else {
    SOMATO_TRY_VOID(open_scene_topics(player->scene()));
    ScenedFrames frames(bag_, *topics_, exploration, *player);
    SOMATO_TRY_VOID(hand_frames(exploration, frames));
    const auto touch = find_channel(exploration, kTouch);
    if (touch) shown_->largest = std::max(shown_->largest, largest_value(**touch));
  }
  if (plots_.empty()) plot(exploration);
  return {};
}

void FoxgloveExport::plot(const Exploration& exploration) {
  if (!exploration.labels.empty()) label_topic_ = bag_.topic_of_label(0);
  for (std::size_t i = 0; i < exploration.channels.size(); ++i) {
    const Channel& channel = exploration.channels[i];
    PlottedTopic plotted{bag_.topic_of_channel(i), bag_.field_of_channel(i), channel.name, {}};
    if (!channel.unit.empty()) plotted.title += fmt::format(" ({})", channel.unit);
    const std::size_t shown = std::min(channel.frames.columns(), kMostPlotted);
    for (std::size_t e = 0; e < shown; ++e) {
      plotted.element_names.push_back(channel.element_names.empty() ? fmt::format("{}", e + 1)
                                                                    : channel.element_names[e]);
    }
    plots_.push_back(std::move(plotted));
  }
}

Result<void> FoxgloveExport::finish() {
  SOMATO_TRY_VOID(
      bag_.bag().save("foxglove_layout.json", foxglove_layout(plots_, label_topic_, shown_)));
  return bag_.finish();
}

}  // namespace somato
