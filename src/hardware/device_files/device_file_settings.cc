#include "hardware/device_files/device_file.h"

namespace somato {

using devices::ExploringMethod;
using devices::SensorOrigin;

const std::vector<std::pair<SensorOrigin, std::string>>& Choices<SensorOrigin>::all() {
  static const std::vector<std::pair<SensorOrigin, std::string>> kAll{
      {SensorOrigin::kDriver, "driver"},
      {SensorOrigin::kServos, "servos"},
      {SensorOrigin::kCurrents, "currents"},
      {SensorOrigin::kFrames, "frames"},
      {SensorOrigin::kMicrophone, "microphone"}};
  return kAll;
}

const std::vector<std::pair<ExploringMethod, std::string>>& Choices<ExploringMethod>::all() {
  static const std::vector<std::pair<ExploringMethod, std::string>> kAll{
      {ExploringMethod::kGrasping, "grasping"},
      {ExploringMethod::kClosing, "closing"},
      {ExploringMethod::kStroking, "stroking"},
      {ExploringMethod::kPressing, "pressing"},
      {ExploringMethod::kHolding, "holding"}};
  return kAll;
}

}  // namespace somato

namespace somato::devices {

const Declarations<DeviceSettings>& DeviceSettings::declarations() {
  using P = DeviceSettings;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(), "Name of the device. Required.")
          .add("body", &P::body, "", Range::any(),
               "Simulated body that the device stands for: lucs2, lucs3, texture or hardness; its "
               "servos and sensors are then checked. Empty: another body.")
          .add("explore", &P::explore, "", Range::any(),
               "How it explores: a hand by grasping from several poses or by closing once, a probe "
               "by stroking or pressing; holding: it rests and records for a given time. Required.")
          .add("period", &P::period, "s", Range::between(0.001, 1.0),
               "Time between two commands to the servos, and between two frames of holding.")
          .add("duration", &P::duration, "s", Range::between(0.01, 3600.0),
               "Duration of an exploration by holding.")
          .add(
              "placing", &P::placing, "", Range::any(),
              "Port at which an emulator places the objects, as 'somato emulate' writes it. Empty: "
              "a person does.")
          .add("clock", &P::clock, "", Range::between(0.01, 1000.0),
               "Seconds of the device per second; 1 except for an emulator.")
          .add(
              "clock_port", &P::clock_port, "", Range::any(),
              "Port of an emulator whose time passes only while its host waits, as 'somato emulate "
              "--clock host' writes it; 'clock' then has no effect. Empty: real time.");
  return declared;
}

const Declarations<ServoLine>& ServoLine::declarations() {
  using P = ServoLine;
  static const auto declared = Declarations<P>()
                                   .add("bus", &P::bus, "", Range::any(), "Protocol of the servos.")
                                   .add("port", &P::port, "", Range::any(),
                                        "Serial port, such as \"/dev/ttyUSB0\". Required.")
                                   .add("baud", &P::baud, "bit/s", Range::between(2400, 4000000),
                                        "Speed of the line, as set on the device.");
  return declared;
}

const Declarations<ServoSettings>& ServoSettings::declarations() {
  using P = ServoSettings;
  static const auto declared =
      Declarations<P>()
          .add("channel", &P::channel, "", Range::between(0, 253),
               "Channel of the controller, or id of the servo.")
          .add("unit", &P::unit, "", Range::any(), R"(Unit of its positions: "deg" or "mm".)")
          .add("zero", &P::zero, "", Range::between(-1e6, 1e6),
               "Position on the bus at position 0: a pulse in us, or a number of steps.")
          .add("scale", &P::scale, "", Range::between(-1e6, 1e6),
               "Change on the bus per deg or mm; negative for a servo that turns the other way.")
          .add("least", &P::least, "", Range::between(-1e6, 1e6),
               "Lowest permitted position, in its unit. Required.")
          .add("most", &P::most, "", Range::between(-1e6, 1e6),
               "Highest permitted position, in its unit. Required.")
          .add("fastest", &P::fastest, "", Range{0.0, 1e6, true},
               "Highest permitted speed, in its unit per second.")
          .add("rest", &P::rest, "", Range::between(-1e6, 1e6),
               "Position between explorations; automatic: the lowest.");
  return declared;
}

const Declarations<FrameLine>& FrameLine::declarations() {
  using P = FrameLine;
  static const auto declared =
      Declarations<P>()
          .add("format", &P::format, "", Range::any(), "Format of the frames.")
          .add("port", &P::port, "", Range::any(),
               "Serial port, such as \"/dev/ttyACM0\". Required.")
          .add("baud", &P::baud, "bit/s", Range::between(2400, 4000000), "Speed of the line.")
          .add("elements", &P::elements, "", Range::between(1, 4096),
               "Number of values in a frame. Required.")
          .add("rate", &P::rate, "Hz", Range::between(0.1, 100000),
               "Number of frames per second that the board sends.")
          .add("keep", &P::keep, "", Range::any(),
               "The frames that are recorded: at the end of each step the latest, or every one "
               "with its time. Their channels then have other times than those of the servos.");
  return declared;
}

const Declarations<SensorSettings>& SensorSettings::declarations() {
  using P = SensorSettings;
  static const auto declared =
      Declarations<P>()
          .add("unit", &P::unit, "", Range::any(), "Unit of the values.")
          .add("from", &P::from, "", Range::any(),
               "Origin of the values: the positions that the driver has commanded (driver), those "
               "that the servos measure (servos), their currents in mA (currents), the frames of "
               "the sensor line (frames), or the microphone.")
          .add("elements", &P::elements, "", Range::any(),
               "Names of the elements; \"name_1..7\" stands for seven. Empty: one element without "
               "a name, or for servos their names.")
          .add("servos", &P::servos, "", Range::any(),
               "Servos, for the origins driver, servos and currents.")
          .add("first", &P::first, "", Range::between(0, 4095),
               "Number of its first value in a frame, counted from 0.")
          .add("gain", &P::gain, "", Range::between(-1e9, 1e9),
               "Factor from the origin's values to the unit.")
          .add("offset", &P::offset, "", Range::between(-1e9, 1e9), "Added after the factor.");
  return declared;
}

const Declarations<MicrophoneSettings>& MicrophoneSettings::declarations() {
  using P = MicrophoneSettings;
  static const auto declared =
      Declarations<P>()
          .add("source", &P::source, "", Range::any(),
               "Sound device of ALSA, such as \"alsa:default\", or a file or pipe of 16-bit "
               "samples: \"wav:FILE\" or \"raw:FILE\". Required.")
          .add("rate", &P::rate, "Hz", Range::between(100, 192000), "Samples per second.");
  return declared;
}

const Declarations<SafetySettings>& SafetySettings::declarations() {
  using P = SafetySettings;
  static const auto declared =
      Declarations<P>()
          .add("sensor", &P::sensor, "", Range::any(),
               "Sensor whose values must stay below the limit, such as touch or currents.")
          .add("limit", &P::limit, "", Range::above(0.0),
               "Largest permitted magnitude of a value of this sensor, in its unit; a larger one "
               "stops the body. Automatic: none.")
          .add("missed", &P::missed, "", Range::between(1, 10000),
               "Number of periods of a line without a valid answer or frame after which the body "
               "stops; requests before it moves wait at least as long.")
          .add("hold", &P::hold, "s", Range::between(0.0, 60.0),
               "Time for which a stopped body holds its position before the servos are switched "
               "off.")
          .add("deviation", &P::deviation, "", Range{0.0, 1.0, true},
               "Share of a servo's range by which it may be away from where it is sent: one that "
               "moves farther away, or stays there, stops the body. The default is more than a "
               "loaded servo lags behind.")
          .add("unmoved", &P::unmoved, "s", Range::between(0.05, 60.0),
               "Time after which a servo that is farther away than the deviation and does not move "
               "is stuck; if the body closes or presses, only if it has not moved at all, because "
               "what it explores may stop it. The default is longer than a servo needs to start.")
          .add("beyond", &P::beyond, "", Range::between(0.0, 1.0),
               "Share of a servo's range by which its measured position may exceed its limits. The "
               "default is more than a servo overshoots.")
          .add("hottest", &P::hottest, "deg C", Range::between(20.0, 150.0),
               "Highest permitted temperature of a servo that reports one. The default is the "
               "lowest at which the servos' makers switch them off.")
          .add("pause", &P::pause, "s", Range::between(0.05, 60.0),
               "Longest time for which the program may be held up while servos move; afterwards "
               "the body stops. The default is longer than a busy computer takes.");
  return declared;
}

}  // namespace somato::devices
