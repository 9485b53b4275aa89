#include "hardware/lines/serial_port.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <vector>

#include "base/support/temporary_folder.h"

namespace somato::wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Everything that arrives until there are as many bytes, or nothing comes for a second.
Bytes read_all(const Descriptor& from, std::size_t count) {
  Bytes all;
  while (all.size() < count) {
    pollfd polled{from.number(), POLLIN, 0};
    if (poll(&polled, 1, 1000) <= 0) break;
    Bytes part(count);
    const auto read = read_available(from.number(), part, "port");
    if (!read || *read == 0) break;
    all.insert(all.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(*read));
  }
  return all;
}

TEST(SerialPort, PassesEveryByteUnchangedInBothDirections) {
  const auto terminal = open_pseudo_terminal();
  ASSERT_TRUE(terminal);
  const auto host = open_serial_port(terminal->port, 115200);
  ASSERT_TRUE(host) << to_string(host.error());
  Bytes every(256);
  for (std::size_t i = 0; i < every.size(); ++i) every[i] = static_cast<std::uint8_t>(i);
  EXPECT_EQ(*write_available(host->number(), every, "port"), 256U);
  EXPECT_EQ(read_all(terminal->device, 256), every);
  EXPECT_EQ(*write_available(terminal->device.number(), every, "port"), 256U);
  EXPECT_EQ(read_all(*host, 256), every);
}

TEST(SerialPort, DoesNotWaitWhereNothingArrives) {
  const auto terminal = open_pseudo_terminal();
  const auto host = open_serial_port(terminal->port, 9600);
  Bytes some(8);
  EXPECT_EQ(*read_available(host->number(), some, "port"), 0U);
}

TEST(SerialPort, BelongsToOneAtATime) {
  const auto terminal = open_pseudo_terminal();
  const auto host = open_serial_port(terminal->port, 9600);
  const auto second = open_serial_port(terminal->port, 9600);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().what, "another process uses the port");
}

TEST(SerialPort, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const auto missing = open_serial_port(folder.path() + "/nothing", 9600);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kSystem);
  EXPECT_NE(missing.error().what.find("No such file"), std::string::npos);
  const auto no_port = open_serial_port("/dev/null", 9600);
  ASSERT_FALSE(no_port);
  EXPECT_EQ(no_port.error().what, "this is no serial port");
  const auto terminal = open_pseudo_terminal();
  const auto odd = open_serial_port(terminal->port, 12345);
  ASSERT_FALSE(odd);
  EXPECT_EQ(odd.error().what, "12345 is no speed of a serial port");
}

}  // namespace
}  // namespace somato::wire
