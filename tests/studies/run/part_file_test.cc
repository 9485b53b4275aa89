#include "studies/run/part_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "studies/run/checked_line.h"

namespace somato {
namespace {

PartResults part() {
  PartResults part;
  part.question = "a question";
  part.system = "press";
  part.variation = "small";
  part.recordings = {{"one.mcap", "", 0, "", 0}, {"two.mcap", "", 0, "", 0}};
  part.pairs = {{0, 2011}, {1, 2012}};
  ProtocolResults protocol{"leave_group_out", "trial", "material", 24, {}, {}};
  protocol.metrics = {{"zeal", {1.0 / 3.0, 1e-300}},
                      {"accuracy", {std::numeric_limits<double>::quiet_NaN(), 1.0}},
                      {"zeal_chance", {0.5, 1.0}, {{{0.0, 3}, {1.0 / 3.0, 1}}, {{1.0, 4}}}}};
  part.protocols = {protocol, {"train_is_test", {}, "material", 24, {}, {}}};
  return part;
}

TEST(PartFile, GivesBackWhatWasKept) {
  const auto found = read_part_file(part_file(part()), "a.found");
  ASSERT_TRUE(found && *found);
  const std::optional<PartResults>& read = *found;
  EXPECT_EQ(read->question, "a question");
  EXPECT_EQ(read->system, "press");
  EXPECT_EQ(read->variation, "small");
  EXPECT_EQ(read->recordings, part().recordings);
  ASSERT_EQ(read->pairs.size(), 2U);
  EXPECT_EQ(read->pairs[1].recording, 1U);
  EXPECT_EQ(read->pairs[1].seed, 2012U);
  ASSERT_EQ(read->protocols.size(), 2U);
  const ProtocolResults& protocol = read->protocols[0];
  EXPECT_EQ(protocol.protocol, "leave_group_out");
  EXPECT_EQ(protocol.group, "trial");
  EXPECT_EQ(protocol.label, "material");
  EXPECT_EQ(protocol.samples, 24U);
  ASSERT_EQ(protocol.metrics.size(), 3U);
  EXPECT_EQ(protocol.metrics[0].name, "zeal");
  EXPECT_EQ(protocol.metrics[0].values, part().protocols[0].metrics[0].values);
  EXPECT_TRUE(protocol.metrics[0].of_each.empty());
  EXPECT_EQ(protocol.metrics[2].of_each, part().protocols[0].metrics[2].of_each);
  EXPECT_TRUE(std::isnan(protocol.metrics[1].values[0]));
  EXPECT_EQ(protocol.metrics[1].values[1], 1.0);
}

TEST(PartFile, DamageLeavesNothing) {
  const std::string whole = part_file(part());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_EQ(read_part_file(whole.substr(0, length), "").value(), std::nullopt) << length;
  }
  for (std::size_t i = 0; i < whole.size(); i += 7) {
    std::string damaged = whole;
    damaged[i] = damaged[i] == '1' ? '2' : '1';
    EXPECT_EQ(read_part_file(damaged, "").value(), std::nullopt) << i;
  }
  EXPECT_EQ(read_part_file("\n", "").value(), std::nullopt);
}

TEST(PartFile, OfAnotherFormatIsRefusedWithItsVersion) {
  const auto refusal = [](int version) {
    const auto read = read_part_file(checked_line({{"somato_part", version}}), "a.found");
    return read ? "" : to_string(read.error());
  };
  EXPECT_TRUE(refusal(4).starts_with(
      "a.found: written by an earlier version of Somato (format 4, supported is 5); "
      "complete the sweep with that version"))
      << refusal(4);
  EXPECT_EQ(refusal(6),
            "a.found: written by a newer version of Somato (format 6, supported is 5); "
            "update Somato");
  EXPECT_EQ(read_part_file(checked_line({{"somato_part", "5"}}), "").value(), std::nullopt);
  EXPECT_EQ(read_part_file(checked_line({5}), "").value(), std::nullopt);
}

}  // namespace
}  // namespace somato
