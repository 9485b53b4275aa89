#include "bodies/hands/hand_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "base/files/embedded.h"
#include "bodies/physics/object_mjcf.h"
#include "bodies/physics/units.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using detail::kMetres;
using detail::kRadians;

constexpr double kMostHeight = 400.0, kMostWidth = 400.0;  // mm, of anything before a hand

std::string_view model_file(Hand hand) {
  return hand == Hand::kLucs2 ? "models/lucs_haptic_hand_2.xml" : "models/lucs_haptic_hand_3.xml";
}

// An actuator turns or shifts the joint it acts upon.
bool is_slide(const mjModel& model, int servo) {
  return model.jnt_type[*detail::row_of(model.actuator_trnid, servo, 2)] == mjJNT_SLIDE;
}

DegreeOfFreedom degree_of_freedom(const mjModel& model, int servo) {
  const bool slide = is_slide(model, servo);
  const double scale = slide ? kMetres : kRadians;
  const mjtNum* range = detail::row_of(model.actuator_ctrlrange, servo, 2);
  // Rounded to the precision of the model's text: 30 deg is 30, not 29.99998.
  const auto in_unit = [&](double value) { return std::round(value / scale * 1e3) / 1e3; };
  return {
      mj_id2name(&model, mjOBJ_ACTUATOR, servo), slide ? "mm" : "deg", in_unit(range[0]),
      in_unit(range[1]),
      *detail::row_of(model.actuator_user, servo, static_cast<int>(model.nuser_actuator)) / scale};
}

ChannelDescription sensor(const char* name, const char* unit, std::vector<std::string> elements) {
  ChannelDescription description;
  description.name = name;
  description.unit = unit;
  description.element_names = std::move(elements);
  return description;
}

std::vector<std::string> potentiometers(const mjModel& model) {
  std::vector<std::string> names;
  const auto count = static_cast<int>(model.nsensor);
  names.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) names.emplace_back(mj_id2name(&model, mjOBJ_SENSOR, i));
  return names;
}

// The joints of Hand II are known from the driver, those of Hand III from its potentiometers.
std::vector<ChannelDescription> proprioception(Hand hand, const mjModel& model,
                                               const std::vector<DegreeOfFreedom>& servos) {
  if (hand == Hand::kLucs3) return {sensor("joints", "deg", potentiometers(model))};
  std::vector<std::string> fingers;
  for (std::size_t i = 2; i < servos.size(); ++i) fingers.push_back(servos[i].name);
  return {sensor("height", "mm", {}), sensor("wrist", "deg", {}), sensor("joints", "deg", fingers)};
}

ChannelDescription silhouette_sensor(std::size_t pixels) {
  ChannelDescription description = sensor("silhouette", "", {});
  description.shape = {pixels, pixels};
  return description;
}

BodyDescription describe(const HandScene::Impl& parts) {
  const mjModel& model = *parts.model;
  BodyDescription description;
  description.name = parts.hand == Hand::kLucs2 ? "LUCS Haptic Hand II" : "LUCS Haptic Hand III";
  const auto servos = static_cast<int>(model.nu);
  for (int i = 0; i < servos; ++i)
    description.degrees_of_freedom.push_back(degree_of_freedom(model, i));
  description.sensors = proprioception(parts.hand, model, description.degrees_of_freedom);
  if (!parts.taxels.names.empty()) {
    description.sensors.push_back(sensor("touch", "N", parts.taxels.names));
    description.sensors.push_back(sensor("touch_change", "N", parts.taxels.names));
  }
  const std::size_t pixels = parts.parameters.silhouette;
  if (pixels > 0) description.sensors.push_back(silhouette_sensor(pixels));
  return description;
}

// The initial positions of the servos in the model, or 0.
std::vector<double> start_of(const mjModel& model) {
  const int found = detail::find_in(model, mjOBJ_NUMERIC, "start");
  if (found < 0) return std::vector<double>(static_cast<std::size_t>(model.nu), 0.0);
  SOMATO_ASSERT(model.numeric_size[found] == static_cast<int>(model.nu));
  const mjtNum* first = model.numeric_data + model.numeric_adr[found];
  return {first, first + model.nu};
}

bool has_taxels(Hand hand, const SimulationParameters& parameters) {
  return hand == Hand::kLucs2 || parameters.taxels;
}

void find_indices(HandScene::Impl& parts) {
  const mjModel& model = *parts.model;
  parts.taxels.taxel_of_geom.assign(static_cast<std::size_t>(model.ngeom), -1);
  if (has_taxels(parts.hand, parts.parameters)) parts.taxels = detail::find_taxels(model);
  parts.start = start_of(model);
  for (int i = 0; i < static_cast<int>(model.nu); ++i)
    parts.scales.push_back(is_slide(model, i) ? kMetres : kRadians);
  parts.place = detail::find_in(model, mjOBJ_SITE, "object_place");
  if (parts.place < 0) {
    parts.place = detail::find_in(model, mjOBJ_SITE, "against_palm");
    parts.at_palm = true;
    parts.turn_to_palm = parts.object.size[1] > parts.object.size[0];
  }
  parts.object_body = detail::find_in(model, mjOBJ_BODY, "object");
  parts.object_geom = detail::find_in(model, mjOBJ_GEOM, "object");
  parts.stand_body = detail::find_in(model, mjOBJ_BODY, "stand");
  SOMATO_ASSERT(parts.place >= 0 && parts.object_body >= 0 && parts.object_geom >= 0);
}

// Skin and material yield in series, and a contact's time constant grows with the root of both
// together; that of the hand's geoms is that of the skin.
void soften(const Material& material, mjModel& model) {
  constexpr double kSkin = 20.0;  // N/mm, not given in the paper
  const int geom = detail::find_in(model, mjOBJ_GEOM, "object");
  *detail::row_of(model.geom_solref, geom, mjNREF) *=
      std::sqrt(1.0 + kSkin / material.stiffness_under_taxel());
}

// Taxels that are not there are neither felt nor seen.
void remove_taxels(mjModel& model) {
  const detail::Taxels taxels = detail::find_taxels(model);
  for (std::size_t geom = 0; geom < taxels.taxel_of_geom.size(); ++geom) {
    if (taxels.taxel_of_geom[geom] < 0) continue;
    model.geom_contype[geom] = 0;
    model.geom_conaffinity[geom] = 0;
    model.geom_rgba[4 * geom + 3] = 0.0F;
  }
}

// Parameters that are not in the model's text because they depend on the object and the caller.
void settle_model(Hand hand, const Material& material, const SimulationParameters& parameters,
                  mjModel& model) {
  model.opt.timestep = parameters.time_step;
  soften(material, model);
  if (!has_taxels(hand, parameters)) remove_taxels(model);
}

Result<void> check_size(const Object& object) {
  const auto& size = object.size;
  if (size[0] <= kMostWidth && size[1] <= kMostWidth && size[2] <= kMostHeight) return {};
  return fail(ErrorKind::kUsage,
              fmt::format("'{}' ({:g} x {:g} x {:g} mm) does not fit the hand", object.name,
                          size[0], size[1], size[2]),
              object.name, "use a smaller object");
}

}  // namespace

namespace detail {

std::string scene_mjcf(std::string_view hand, const std::string& assets,
                       const std::string& bodies) {
  constexpr std::string_view kEnd = "</worldbody>";
  const std::size_t end = hand.find(kEnd);
  SOMATO_ASSERT(end != std::string_view::npos);
  std::string text(hand.substr(0, end));
  text += bodies;
  text += kEnd;
  if (!assets.empty()) text += "<asset>" + assets + "</asset>";
  return text + std::string(hand.substr(end + kEnd.size()));
}

}  // namespace detail

Result<HandScene> HandScene::build(Hand hand, const Object& object,
                                   const SimulationParameters& parameters) {
  SOMATO_TRY(auto measured, detail::measure_object(object));
  SOMATO_TRY_VOID(check_size(measured.object));
  const auto mjcf = detail::object_mjcf(
      measured, {parameters.free, parameters.friction.value_or(object.material.friction)});
  SOMATO_TRY(auto model,
             detail::compile_model(detail::scene_mjcf(detail::embedded_text(model_file(hand)),
                                                      mjcf.assets, mjcf.bodies),
                                   object.name));
  settle_model(hand, object.material, parameters, *model);
  auto parts = std::make_shared<Impl>();
  parts->hand = hand;
  parts->object = std::move(measured.object);
  parts->parameters = parameters;
  parts->model = std::move(model);
  find_indices(*parts);
  parts->description = describe(*parts);
  return HandScene(std::move(parts));
}

const Object& HandScene::object() const {
  return impl_->object;
}

}  // namespace somato
