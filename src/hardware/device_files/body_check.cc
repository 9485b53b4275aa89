#include "hardware/device_files/device_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace somato::devices {
namespace {

tl::unexpected<Error> differs(std::string what, const std::string& where, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), where, std::move(advice));
}

template <typename Named>
const Named* named(const std::vector<Named>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Result<void> check_servo(const BodyDescription& device, const BodyDescription& body,
                         const DegreeOfFreedom& needed, const std::string& where) {
  const DegreeOfFreedom* servo = named(device.degrees_of_freedom, needed.name);
  if (servo == nullptr) {
    return differs(fmt::format("{} has a servo '{}', the device does not", body.name, needed.name),
                   where, fmt::format("add a table [servo.{}]", needed.name));
  }
  if (servo->unit != needed.unit) {
    return differs(fmt::format("the servo '{}' of {} has the unit {}, not {}", needed.name,
                               body.name, needed.unit, servo->unit),
                   where, "correct its unit and its scale");
  }
  if (servo->least >= needed.least && servo->most <= needed.most) return {};
  return differs(fmt::format("the servo '{}' may move from {:g} to {:g} {}, but that of {} only "
                             "from {:g} to {:g}",
                             servo->name, servo->least, servo->most, servo->unit, body.name,
                             needed.least, needed.most),
                 where, "narrow its limits");
}

Result<void> check_sensor(const BodyDescription& device, const BodyDescription& body,
                          const ChannelDescription& needed, bool required,
                          const std::string& where) {
  const ChannelDescription* sensor = named(device.sensors, needed.name);
  if (sensor == nullptr && !required) return {};
  if (sensor == nullptr) {
    return differs(fmt::format("exploring requires the sensor '{}', which the device does not have",
                               needed.name),
                   where, fmt::format("add a table [sensor.{}]", needed.name));
  }
  if (sensor->unit != needed.unit) {
    return differs(fmt::format("the sensor '{}' of {} has the unit {}, not {}", needed.name,
                               body.name, needed.unit, sensor->unit),
                   where, "correct its unit and its gain");
  }
  if (sensor->element_names == needed.element_names) return {};
  return differs(
      fmt::format("the elements of the sensor '{}' are not those of {}", needed.name, body.name),
      where,
      needed.element_names.empty()
          ? "remove 'elements'"
          : fmt::format("they are, in this order: {}", fmt::join(needed.element_names, ", ")));
}

}  // namespace

Result<void> check_against(const DeviceFile& file, const BodyDescription& body,
                           const std::vector<std::string>& needed, const std::string& where) {
  const BodyDescription device = describe(file);
  for (const DegreeOfFreedom& servo : body.degrees_of_freedom) {
    SOMATO_TRY_VOID(check_servo(device, body, servo, where));
  }
  for (const DegreeOfFreedom& servo : device.degrees_of_freedom) {
    if (named(body.degrees_of_freedom, servo.name) != nullptr) continue;
    return differs(fmt::format("{} has no servo '{}'", body.name, servo.name), where,
                   "remove it, or leave out 'body'");
  }
  for (const ChannelDescription& sensor : body.sensors) {
    const bool required = std::find(needed.begin(), needed.end(), sensor.name) != needed.end();
    SOMATO_TRY_VOID(check_sensor(device, body, sensor, required, where));
  }
  return {};
}

}  // namespace somato::devices
