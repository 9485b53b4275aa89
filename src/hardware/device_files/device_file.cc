#include "hardware/device_files/device_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/files/embedded.h"
#include "base/files/toml_file.h"
#include "base/text/text.h"

namespace somato::devices {
namespace {

tl::unexpected<Error> refuse(std::string what, const std::string& where, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), where, std::move(advice));
}

Result<void> check_present(const Table& table, std::string_view key, std::string advice) {
  if (table.find(key)) return {};
  return refuse(fmt::format("'{}' is missing", key), table.where, std::move(advice));
}

// "touch_1..3" stands for touch_1, touch_2 and touch_3.
Result<void> expand(const std::string& name, const std::string& where,
                    std::vector<std::string>& names) {
  const std::size_t dots = name.find("..");
  if (dots == std::string::npos) {
    names.push_back(name);
    return {};
  }
  constexpr std::string_view kDigits = "0123456789";
  const std::size_t begin = name.find_last_not_of(kDigits, dots - 1) + 1;
  const std::string first = name.substr(begin, dots - begin);
  const std::string last = name.substr(dots + 2);
  constexpr std::size_t kLongest = 4;
  const bool numbers = !first.empty() && !last.empty() && first.size() <= kLongest &&
                       last.size() <= kLongest &&
                       last.find_first_not_of(kDigits) == std::string::npos;
  if (dots == 0 || !numbers || std::stoul(first) > std::stoul(last)) {
    return refuse(fmt::format("{} is no range of names", shown(name)), where,
                  "write for example \"finger1_proximal_1..7\"");
  }
  for (std::size_t i = std::stoul(first); i <= std::stoul(last); ++i) {
    names.push_back(fmt::format("{}{}", name.substr(0, begin), i));
  }
  return {};
}

// Reads the tables of a device file one after the other.
class Reader {
 public:
  explicit Reader(const Table& file) : file_(file) {}

  Result<DeviceFile> read() {
    Table keys{file_.where, {}};
    for (const Table::Entry& entry : file_.entries) {
      if (const Table* table = std::get_if<Table>(&entry.content)) {
        SOMATO_TRY_VOID(read_table(entry.name, entry.where, *table));
      } else {
        keys.entries.push_back(entry);
      }
    }
    SOMATO_TRY(auto settings, read_parameters<DeviceSettings>(keys));
    SOMATO_TRY_VOID(check_present(keys, "name", "write for example name = \"my hand\""));
    SOMATO_TRY_VOID(check_present(keys, "explore", "write for example explore = \"closing\""));
    device_.settings = std::move(settings);
    SOMATO_TRY_VOID(check());
    return std::move(device_);
  }

 private:
  Result<void> read_table(const std::string& name, const std::string& where, const Table& table) {
    if (name == "servos") return read_line(table, device_.servo_line);
    if (name == "frames") return read_frames(table);
    if (name == "microphone") return read_microphone(table);
    if (name == "safety") return assign(read_parameters<SafetySettings>(table), device_.safety);
    if (name == "servo")
      return each(table, [&](auto& entry, auto& own) { return read_servo(entry, own); });
    if (name == "sensor")
      return each(table, [&](auto& entry, auto& own) { return read_sensor(entry, own); });
    return fail(unknown_name("table", name, where,
                             {"servos", "servo", "frames", "sensor", "microphone", "safety"}));
  }

  template <typename T>
  static Result<void> assign(Result<T> read, T& to) {
    if (!read) return fail(std::move(read.error()));
    to = std::move(*read);
    return {};
  }

  template <typename Read>
  static Result<void> each(const Table& table, const Read& read) {
    for (const Table::Entry& entry : table.entries) {
      const Table* own = std::get_if<Table>(&entry.content);
      if (own == nullptr)
        return refuse(fmt::format("'{}' must be a table", entry.name), entry.where,
                      "write for example [servo.wrist]");
      if (!is_name(entry.name))
        return refuse("the name is empty or too long", entry.where,
                      "use 1 to 255 bytes of text without control characters");
      SOMATO_TRY_VOID(read(entry, *own));
    }
    return {};
  }

  Result<void> read_line(const Table& table, std::optional<ServoLine>& line) {
    SOMATO_TRY_VOID(assign(read_parameters<ServoLine>(table), line.emplace()));
    SOMATO_TRY_VOID(check_present(table, "bus", "write for example bus = \"ssc32\""));
    return check_present(table, "port", "write for example port = \"/dev/ttyUSB0\"");
  }

  Result<void> read_frames(const Table& table) {
    SOMATO_TRY_VOID(assign(read_parameters<FrameLine>(table), device_.frame_line.emplace()));
    SOMATO_TRY_VOID(check_present(table, "port", "write for example port = \"/dev/ttyACM0\""));
    SOMATO_TRY_VOID(check_present(table, "elements", "write the number of values in a frame"));
    if (device_.frame_line->format != FrameFormat::kAnyskin ||
        device_.frame_line->elements % kAnyskinAxes == 0)
      return {};
    return refuse("frames of AnySkin have three values for each magnetometer",
                  table.find("elements")->where, "use a multiple of 3");
  }

  Result<void> read_microphone(const Table& table) {
    SOMATO_TRY_VOID(
        assign(read_parameters<MicrophoneSettings>(table), device_.microphone.emplace()));
    return check_present(table, "source", "write for example source = \"alsa:default\"");
  }

  Result<void> read_servo(const Table::Entry& entry, const Table& table) {
    SOMATO_TRY(auto servo, read_parameters<ServoSettings>(table));
    for (const char* key : {"channel", "least", "most"}) {
      SOMATO_TRY_VOID(check_present(table, key, "a servo requires channel, least and most"));
    }
    servo.name = entry.name;
    where_[servo.name] = table.where;
    device_.servos.push_back(std::move(servo));
    return {};
  }

  Result<void> read_sensor(const Table::Entry& entry, const Table& table) {
    SOMATO_TRY(auto sensor, read_parameters<SensorSettings>(table));
    SOMATO_TRY_VOID(check_present(table, "from", "write for example from = \"frames\""));
    std::vector<std::string> names;
    for (const std::string& name : sensor.elements) {
      SOMATO_TRY_VOID(expand(name, table.find("elements")->where, names));
    }
    sensor.elements = std::move(names);
    sensor.name = entry.name;
    where_[sensor.name] = table.where;
    SOMATO_TRY_VOID(check_keys(sensor, table));
    device_.sensors.push_back(std::move(sensor));
    return {};
  }

  // A key that would be ignored is a mistake.
  static Result<void> check_keys(SensorSettings& sensor, const Table& table) {
    const bool of_servos = sensor.from == SensorOrigin::kDriver ||
                           sensor.from == SensorOrigin::kServos ||
                           sensor.from == SensorOrigin::kCurrents;
    for (const auto& [key, used] : {std::pair("servos", of_servos),
                                    std::pair("first", sensor.from == SensorOrigin::kFrames)}) {
      const Table::Entry* entry = table.find(key);
      if (entry == nullptr || used) continue;
      return refuse(
          fmt::format("'{}' has no effect with from = \"{}\"", key, choice_name(sensor.from)),
          entry->where, "remove it");
    }
    if (of_servos && sensor.servos.empty()) {
      return refuse("'servos' is missing", table.where, "name the servos whose values it has");
    }
    if (!of_servos || sensor.elements.empty() || sensor.elements.size() == sensor.servos.size())
      return {};
    return refuse(fmt::format("the sensor has {} elements, but {} servos", sensor.elements.size(),
                              sensor.servos.size()),
                  table.where, "name one element for each servo, or none");
  }

  Result<void> check() const {
    for (const ServoSettings& servo : device_.servos) SOMATO_TRY_VOID(check_servo(servo));
    for (const SensorSettings& sensor : device_.sensors) SOMATO_TRY_VOID(check_sensor(sensor));
    if (device_.servos.empty() && device_.settings.explore != ExploringMethod::kHolding) {
      return refuse("the device has no servos", file_.where,
                    "add tables such as [servo.wrist], or write explore = \"holding\"");
    }
    if (device_.sensors.empty()) {
      return refuse("the device has no sensors", file_.where, "add tables such as [sensor.touch]");
    }
    return check_safety();
  }

  Result<void> check_servo(const ServoSettings& servo) const {
    const std::string& where = where_.at(servo.name);
    if (!device_.servo_line)
      return refuse("there is no line for the servos", where, "add a table [servos]");
    if (servo.unit != "deg" && servo.unit != "mm")
      return refuse(fmt::format("{} is no unit of a servo", shown(servo.unit)), where,
                    R"(use "deg" or "mm")");
    if (!(servo.least < servo.most))
      return refuse("'least' must be below 'most'", where,
                    "give the range in which the servo may move");
    if (servo.resting() < servo.least || servo.resting() > servo.most)
      return refuse("'rest' is outside of the servo's limits", where,
                    "choose a position from least to most");
    SOMATO_TRY_VOID(check_reach(servo, where));
    return check_channel(servo, where);
  }

  Result<void> check_reach(const ServoSettings& servo, const std::string& where) const {
    const BusTraits& bus = traits_of(device_.servo_line->bus);
    if (servo.scale == 0.0)
      return refuse("'scale' must not be 0", where, "give the change on the bus per unit");
    for (const double limit : {servo.least, servo.most}) {
      const double position = servo.on_bus(limit);
      if (position >= bus.lowest && position <= bus.highest) continue;
      return refuse(
          fmt::format("the limit {:g} {} is {:g} on the bus, which goes from {:g} to {:g}", limit,
                      servo.unit, position, bus.lowest, bus.highest),
          where, "correct zero and scale, or narrow the limits");
    }
    return {};
  }

  Result<void> check_channel(const ServoSettings& servo, const std::string& where) const {
    const std::size_t channels = traits_of(device_.servo_line->bus).channels;
    if (servo.channel >= channels) {
      return refuse(fmt::format("the bus has no channel {}", servo.channel), where,
                    fmt::format("use 0 to {}", channels - 1));
    }
    for (const ServoSettings& other : device_.servos) {
      if (&other == &servo) break;
      if (other.channel == servo.channel)
        return refuse(fmt::format("'{}' and '{}' have the same channel {}", other.name, servo.name,
                                  servo.channel),
                      where, "give each servo its own channel");
    }
    return {};
  }

  Result<void> check_sensor(const SensorSettings& sensor) const {
    const std::string& where = where_.at(sensor.name);
    for (const std::string& name : sensor.servos) SOMATO_TRY_VOID(check_known(name, where));
    if (sensor.from == SensorOrigin::kMicrophone && !device_.microphone)
      return refuse("there is no microphone", where, "add a table [microphone]");
    if (sensor.from == SensorOrigin::kFrames) return check_frame(sensor, where);
    const bool measured =
        sensor.from == SensorOrigin::kServos || sensor.from == SensorOrigin::kCurrents;
    if (!measured || traits_of(device_.servo_line->bus).measures) return {};
    return refuse("the SSC-32 cannot measure positions and currents of servos", where,
                  "use from = \"driver\", or sensors at another line");
  }

  Result<void> check_known(const std::string& servo, const std::string& where) const {
    std::vector<std::string> known;
    known.reserve(device_.servos.size());
    for (const ServoSettings& one : device_.servos) known.push_back(one.name);
    if (std::find(known.begin(), known.end(), servo) != known.end()) return {};
    return fail(unknown_name("servo", servo, where, known));
  }

  Result<void> check_frame(const SensorSettings& sensor, const std::string& where) const {
    if (!device_.frame_line)
      return refuse("there is no line for frames", where, "add a table [frames]");
    const std::size_t end = sensor.first + elements_of(sensor);
    if (end <= device_.frame_line->elements) return {};
    return refuse(fmt::format("the sensor ends at value {} of a frame of {}", end,
                              device_.frame_line->elements),
                  where, "correct 'first', or the elements of [frames]");
  }

  Result<void> check_safety() const {
    const SafetySettings& safety = device_.safety;
    const std::string where = file_.find("safety") ? file_.find("safety")->where : file_.where;
    if (safety.limit.has_value() == safety.sensor.empty())
      return refuse("a limit requires a sensor, and a sensor a limit", where,
                    "write for example sensor = \"touch\" and limit = 20");
    std::vector<std::string> known;
    known.reserve(device_.sensors.size());
    for (const SensorSettings& sensor : device_.sensors) known.push_back(sensor.name);
    if (safety.sensor.empty() ||
        std::find(known.begin(), known.end(), safety.sensor) != known.end())
      return {};
    return fail(unknown_name("sensor", safety.sensor, where, known));
  }

  const Table& file_;
  DeviceFile device_;
  std::map<std::string, std::string> where_;
};

ChannelDescription describe(const SensorSettings& sensor, const DeviceFile& file) {
  ChannelDescription description;
  description.name = sensor.name;
  description.unit = sensor.unit;
  description.element_names = sensor.elements;
  if (sensor.elements.empty() && sensor.servos.size() > 1)
    description.element_names = sensor.servos;
  if (sensor.from == SensorOrigin::kMicrophone) description.rate = file.microphone->rate;
  return description;
}

}  // namespace

std::vector<BusServo> DeviceFile::bus_servos() const {
  std::vector<BusServo> all;
  all.reserve(servos.size());
  for (const ServoSettings& servo : servos) {
    all.push_back({servo.channel, servo.on_bus(servo.resting())});
  }
  return all;
}

double patience_of(const DeviceFile& file) {
  return static_cast<double>(file.safety.missed) * file.settings.period;
}

Result<DeviceFile> parse_device_file(std::string_view text, std::string_view where) {
  return parse_toml(text, where).and_then([](const Table& file) { return Reader(file).read(); });
}

Result<DeviceFile> read_device_file(const std::string& path) {
  return read_toml(path).and_then([](const Table& file) { return Reader(file).read(); });
}

Result<DeviceFile> own_device_file(std::string_view name) {
  constexpr std::string_view kFolder = "devices/";
  constexpr std::string_view kEnding = ".toml";
  std::vector<std::string> known;
  for (const detail::EmbeddedFile& file : detail::embedded_files()) {
    if (!file.path.starts_with(kFolder)) continue;
    const std::string_view own =
        file.path.substr(kFolder.size(), file.path.size() - kFolder.size() - kEnding.size());
    if (own == name) return parse_device_file(file.text, file.path);
    known.emplace_back(own);
  }
  return fail(unknown_name("device", name, "devices", known));
}

std::size_t elements_of(const SensorSettings& sensor) {
  return std::max({std::size_t{1}, sensor.elements.size(), sensor.servos.size()});
}

BodyDescription describe(const DeviceFile& file) {
  BodyDescription body;
  body.name = file.settings.name;
  for (const ServoSettings& servo : file.servos) {
    body.degrees_of_freedom.push_back(
        {servo.name, servo.unit, servo.least, servo.most, servo.fastest});
  }
  for (const SensorSettings& sensor : file.sensors) body.sensors.push_back(describe(sensor, file));
  return body;
}

}  // namespace somato::devices
