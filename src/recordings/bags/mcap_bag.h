#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "recordings/bags/bag_source.h"
#include "recordings/mcap/mcap_reader.h"

namespace somato {

/// A file of a bag in MCAP.
class McapBag : public BagSource {
 public:
  /// Errors: as McapReader::open().
  static Result<std::unique_ptr<BagSource>> open(const std::string& path);

  explicit McapBag(McapReader file) : file_(std::move(file)) {}

  Result<std::optional<BagMessage>> next() override;
  const std::vector<BagTopic>& topics() const override { return topics_; }

 private:
  McapReader file_;
  std::vector<BagTopic> topics_;
  std::map<std::uint16_t, std::size_t> topic_by_id_;
};

}  // namespace somato
