#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "recordings/bags/bag_source.h"

struct sqlite3;
struct sqlite3_stmt;

namespace somato {

/// A file of a bag in SQLite (.db3): the storage `sqlite3` of rosbag2.
class SqliteBag : public BagSource {
 public:
  /// Definitions are in the file since ROS 2 Iron; without them, BagTopic's are empty. Errors
  /// (kData, with the file): no SQLite database, or not one of rosbag2.
  static Result<std::unique_ptr<BagSource>> open(const std::string& path);

  Result<std::optional<BagMessage>> next() override;
  const std::vector<BagTopic>& topics() const override { return topics_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Close>;
  struct Definition {
    std::string encoding;
    std::string text;
  };

  explicit SqliteBag(std::string path) : path_(std::move(path)) {}

  tl::unexpected<Error> failure(const std::string& what) const;
  Result<void> begin();
  Result<Statement> prepare(const char* query) const;
  Result<bool> step(const Statement& statement) const;
  Result<std::map<std::string, Definition>> read_definitions() const;
  Result<void> read_topics();

  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
  Statement messages_;
  std::vector<BagTopic> topics_;
  std::map<std::int64_t, std::size_t> topic_by_id_;
};

}  // namespace somato
