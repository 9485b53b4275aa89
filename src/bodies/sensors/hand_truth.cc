#include "bodies/sensors/hand_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "bodies/sensors/exact_values.h"

namespace somato::detail {
namespace {

constexpr const char* kReadings = "true_readings";
constexpr const char* kJoints = "true_joints";
constexpr const char* kForce = "true_force";
constexpr const char* kContacts = "true_contacts";

// A message of a file holds many contacts, because reading a message takes long.
constexpr std::size_t kContactsPerFrame = 512;
constexpr std::size_t kContactElements = 5;  // steps since the contact before, taxel, parts
constexpr float kNoTaxel = -1.0F;            // fills the last frame

// More than any exploration reaches.
constexpr double kMostReadings = 1e7;
constexpr double kMostSteps = 1e9;
constexpr double kMostTaxels = 1e6;

Channel numbered(const char* name, const char* unit, std::size_t columns) {
  Channel channel;
  channel.name = name;
  channel.unit = unit;
  channel.frames = Matrix<float>(0, columns);
  return channel;
}

}  // namespace

void HandTruth::step(const std::vector<double>& forces) {
  ++steps_;
  forces_.resize(forces.size(), 0.0);
  for (std::size_t taxel = 0; taxel < forces.size(); ++taxel) {
    if (forces[taxel] == forces_[taxel]) continue;
    contacts_.push_back({steps_, taxel, forces[taxel]});
    forces_[taxel] = forces[taxel];
  }
}

void HandTruth::read(const std::vector<double>& joints) {
  ++readings_;
  joints_ = joints;
}

void HandTruth::keep() {
  moments_.push_back({readings_ - 1, steps_, joints_, forces_});
}

void HandTruth::add_to(Exploration& exploration, const std::vector<std::string>& joints,
                       const std::vector<std::string>& taxels) const {
  Channel readings = exact_channel(kReadings, "", {"readings", "steps"});
  Channel angles = exact_channel(kJoints, "deg", joints);
  Channel force = numbered(kForce, "N", taxels.size());
  force.element_names = taxels;
  for (const Moment& moment : moments_) {
    add_exact(readings,
              std::array{static_cast<double>(moment.readings), static_cast<double>(moment.steps)});
    add_exact(angles, moment.joints);
    const std::span<float> row = force.frames.add_row();
    std::transform(moment.forces.begin(), moment.forces.end(), row.begin(),
                   [](double value) { return static_cast<float>(value); });
  }
  exploration.channels.push_back(std::move(readings));
  if (!joints.empty()) exploration.channels.push_back(std::move(angles));
  if (taxels.empty()) return;
  exploration.channels.push_back(std::move(force));
  add_contacts(exploration);
}

void HandTruth::add_contacts(Exploration& exploration) const {
  Channel channel = numbered(kContacts, "", kContactsPerFrame * kContactElements);
  channel.shape = {kContactsPerFrame, kContactElements};
  const std::uint64_t end = moments_.empty() ? 0 : moments_.back().steps;
  std::uint64_t before = 0;
  std::size_t used = kContactsPerFrame;
  std::span<float> row;
  const auto next = [&] {
    if (used == kContactsPerFrame) {
      row = channel.frames.add_row();
      for (std::size_t i = 0; i < kContactsPerFrame; ++i) row[i * kContactElements + 1] = kNoTaxel;
      used = 0;
    }
    return row.subspan(kContactElements * used++, kContactElements);
  };
  for (const Contact& contact : contacts_) {
    if (contact.step > end) break;
    const std::span<float> numbers = next();
    numbers[0] = static_cast<float>(contact.step - before);
    numbers[1] = static_cast<float>(contact.taxel);
    std::ranges::copy(parts_of(contact.force), numbers.begin() + 2);
    before = contact.step;
  }
  if (channel.frames.rows() == 0) next();
  exploration.channels.push_back(std::move(channel));
}

bool has_hand_truth(const Exploration& exploration) {
  return true_channel(exploration, kReadings) != nullptr;
}

Result<HandTruth> HandTruth::of(const Exploration& exploration) {
  HandTruth truth;
  SOMATO_TRY_VOID(truth.read_moments(exploration));
  SOMATO_TRY_VOID(truth.read_contacts(exploration));
  return truth;
}

Result<void> HandTruth::read_moments(const Exploration& exploration) {
  const Channel& readings = *true_channel(exploration, kReadings);
  SOMATO_TRY_VOID(check_truth(readings, 2 * kParts));
  const Channel* joints = true_channel(exploration, kJoints);
  if (joints != nullptr) {
    SOMATO_TRY_VOID(check_truth(*joints, joints->frames.columns() / kParts * kParts));
    if (joints->frames.rows() != readings.frames.rows()) {
      return bad_truth(*joints, "has another number of frames than 'true_readings'");
    }
  }
  Moment before;
  for (std::size_t frame = 0; frame < readings.frames.rows(); ++frame) {
    const std::vector<double> counts = exact_row(readings, frame);
    if (!is_count(counts[0], kMostReadings) || !is_count(counts[1], kMostSteps)) {
      return bad_truth(readings, "has other numbers than counts");
    }
    Moment moment{static_cast<std::uint64_t>(counts[0]),
                  static_cast<std::uint64_t>(counts[1]),
                  joints == nullptr ? std::vector<double>() : exact_row(*joints, frame),
                  {}};
    const bool follows =
        frame == 0 || (moment.readings > before.readings && moment.steps >= before.steps);
    if (!follows) return bad_truth(readings, "has counts that do not increase");
    moments_.push_back(moment);
    before = std::move(moment);
  }
  return {};
}

Result<void> HandTruth::read_contacts(const Exploration& exploration) {
  const Channel* channel = true_channel(exploration, kContacts);
  if (channel == nullptr) return {};
  SOMATO_TRY_VOID(check_truth(*channel, kContactsPerFrame * kContactElements));
  const std::span<const float> all = channel->frames.values();
  contacts_.reserve(all.size() / kContactElements);
  std::uint64_t step = 0;
  std::vector<std::uint64_t> last;  // step with a contact of each taxel; 0: none
  for (std::size_t i = 0; i + kContactElements <= all.size(); i += kContactElements) {
    if (all[i + 1] == kNoTaxel) break;
    const auto steps = static_cast<double>(all[i]);
    const auto taxel = static_cast<double>(all[i + 1]);
    if (!is_count(steps, kMostSteps) || !is_count(taxel, kMostTaxels)) {
      return bad_truth(*channel, "has other numbers than steps and taxels");
    }
    step += static_cast<std::uint64_t>(steps);
    const Contact contact{step, static_cast<std::size_t>(taxel),
                          whole_of(all[i + 2], all[i + 3], all[i + 4])};
    if (step == 0) return bad_truth(*channel, "has a row in step 0, but steps count from 1");
    if (contact.taxel >= last.size()) last.resize(contact.taxel + 1, 0);
    if (std::exchange(last[contact.taxel], step) == step) {
      return bad_truth(*channel,
                       fmt::format("has two rows of taxel {} in step {}", contact.taxel, step));
    }
    contacts_.push_back(contact);
  }
  return {};
}

}  // namespace somato::detail
