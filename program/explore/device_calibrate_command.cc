#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "base/files/whole_file.h"
#include "explore/device.h"
#include "explore/placing.h"
#include "flags/commands.h"
#include "hardware/device_files/calibration.h"
#include "hardware/devices/device_body.h"
#include "hardware/devices/device_io.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

using devices::Calibration;
using devices::DeviceBody;
using devices::ServoSettings;

constexpr const char* kHelp =
    "+ N, - N   move by N units (1 without a number)\n"
    "zero       this is position 0\n"
    "at N       this is position N\n"
    "least, most, rest\n"
    "           this is the lowest or highest permitted position, or the one to rest at\n"
    "save       write the device file, and end\n"
    "quit       end without writing\n";

// The next line of the input; the servo is driven while it is awaited. Empty at its end.
Result<std::optional<std::string>> next_line(DeviceBody& body) {
  constexpr double kStep = 0.05;
  std::string line;
  while (!stop_requested()) {
    SOMATO_TRY_VOID(body.step(kStep));
    pollfd input{STDIN_FILENO, POLLIN, 0};
    while (poll(&input, 1, 0) > 0) {
      char byte = 0;
      if (::read(STDIN_FILENO, &byte, 1) <= 0) return std::optional<std::string>();
      if (byte == '\n') return std::optional<std::string>(line);
      line += byte;
    }
  }
  return fail(ErrorKind::kInterrupted, "calibrating was interrupted; the file is unchanged");
}

// Nothing moves before a person says so: a controller that does not know where the servo is lets it
// jump.
Result<void> permit_jump(const ServoSettings& servo) {
  fmt::print(
      "The position of the servo \"{}\" is unknown: when you press Enter, it jumps to {:g} "
      "{}. Take your hands away.\n",
      servo.name, servo.resting(), servo.unit);
  std::fflush(stdout);
  return wait_for_enter();
}

// Moves one servo and keeps what is said about its positions.
class Session {
 public:
  Session(DeviceBody& body, const ServoSettings& moved, const ServoSettings& servo)
      : body_(body), moved_(moved), calibration_(servo) {}

  // Whether the line was understood.
  Result<bool> handle(const std::string& line) {
    const std::string word = line.substr(0, line.find_first_of(" 0123456789."));
    const std::optional<double> number = number_in(line.substr(word.size()));
    if (word == "+") return moved_by(number.value_or(1.0));
    if (word == "-") return moved_by(-number.value_or(1.0));
    if (word == "at" && number) {
      return calibration_.set_position(on_bus(), *number).map([] { return true; });
    }
    if (word == "zero") calibration_.set_zero(on_bus());
    if (word == "least") calibration_.set_least(on_bus());
    if (word == "most") calibration_.set_most(on_bus());
    if (word == "rest") calibration_.set_rest(on_bus());
    return word == "zero" || word == "least" || word == "most" || word == "rest";
  }

  std::string state() const {
    const ServoSettings servo = calibration_.servo();
    return fmt::format("{:.1f} {} ({:.0f} on the bus); limits {:.1f} to {:.1f}\n",
                       servo.from_bus(on_bus()), servo.unit, on_bus(), servo.least, servo.most);
  }

  const Calibration& calibration() const { return calibration_; }

 private:
  static std::optional<double> number_in(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || !std::isfinite(number)) return std::nullopt;
    return number;
  }

  double on_bus() const { return moved_.on_bus(body_.state().positions.front()); }

  // Moves there before the next line is read.
  Result<bool> moved_by(double way) {
    const double target = body_.state().positions.front() + way;
    if (target < moved_.least || target > moved_.most) return false;
    SOMATO_TRY_VOID(body_.command(std::span(&target, 1)));
    SOMATO_TRY_VOID(body_.step(std::abs(way) / moved_.fastest + 0.1));
    return true;
  }

  DeviceBody& body_;
  const ServoSettings& moved_;
  Calibration calibration_;
};

Result<void> save(const Calibration& calibration, const std::string& path) {
  SOMATO_TRY(const auto text, read_whole(path));
  SOMATO_TRY(const auto changed, calibration.in_text(text, path));
  SOMATO_TRY_VOID(save_whole(path, changed));
  fmt::print("{}: servo \"{}\" is calibrated\n", path, calibration.servo().name);
  return {};
}

Result<void> run_session(Session& session, DeviceBody& body, const std::string& path) {
  fmt::print("{}{}", kHelp, session.state());
  for (;;) {
    std::fflush(stdout);
    SOMATO_TRY(const auto line, next_line(body));
    if (!line || *line == "quit") {
      fmt::print("The file is unchanged.\n");
      return {};
    }
    if (*line == "save") return save(session.calibration(), path);
    const auto understood = session.handle(*line);
    if (!understood && understood.error().kind == ErrorKind::kSystem)
      return fail(understood.error());
    if (!understood) fmt::print("{}\n", to_string(understood.error()));
    if (understood && !*understood) fmt::print("This is not possible here.\n{}", kHelp);
    fmt::print("{}", session.state());
  }
}

Result<void> run_calibrate(const Arguments& arguments) {
  const std::string path = arguments.text("FILE");
  SOMATO_TRY(const auto file, devices::read_device_file(path));
  if (!file.servo_line) {
    return fail(ErrorKind::kUsage, "the device has no servos", path,
                "calibrate a device with servos");
  }
  SOMATO_TRY(const auto one, devices::one_servo(file, arguments.text("servo")));
  catch_stop_requests();
  SOMATO_TRY(const auto lines, open_lines(one));
  const ServoGuard guard(*lines, devices::relax_bytes_of(one));
  SOMATO_TRY(const auto body, DeviceBody::start(one, *lines, permit_jump));
  const auto servo = std::find_if(file.servos.begin(), file.servos.end(), [&](const auto& each) {
    return each.name == one.servos.front().name;
  });
  Session session(*body, one.servos.front(), *servo);
  return run_session(session, *body, path);
}

}  // namespace

Command device_calibrate_command() {
  return {"device calibrate",
          "Calibrate one servo of a device: move it slowly, and write its zero, scale and limits",
          {{"FILE", "The device file, which is changed", true}},
          {{"--servo", "Name of the servo", true}},
          {},
          run_calibrate};
}

}  // namespace somato::program
