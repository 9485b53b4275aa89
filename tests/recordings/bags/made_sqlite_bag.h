#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <string>

namespace somato {

/// Writes a bag of rosbag2 in SQLite, for tests: one topic of the type `type`.
class MadeSqliteBag {
 public:
  MadeSqliteBag(const std::string& path, const std::string& topic, const std::string& type,
                const std::string& definition) {
    (void)sqlite3_open(path.c_str(), &database_);
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL)");
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp "
        "INTEGER NOT NULL, data BLOB NOT NULL)");
    run("INSERT INTO topics VALUES(7, '" + topic + "', '" + type + "', 'cdr')");
    if (definition.empty()) return;
    run("CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, "
        "encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL)");
    run("INSERT INTO message_definitions VALUES(1, '" + type + "', 'ros2msg', '" + definition +
        "')");
  }
  MadeSqliteBag(const MadeSqliteBag&) = delete;
  MadeSqliteBag(MadeSqliteBag&&) = delete;
  MadeSqliteBag& operator=(const MadeSqliteBag&) = delete;
  MadeSqliteBag& operator=(MadeSqliteBag&&) = delete;
  ~MadeSqliteBag() { (void)sqlite3_close(database_); }

  void add(std::int64_t time, const std::string& message) {
    sqlite3_stmt* row = nullptr;
    (void)sqlite3_prepare_v2(database_, "INSERT INTO messages VALUES(NULL, 7, ?, ?)", -1, &row,
                             nullptr);
    (void)sqlite3_bind_int64(row, 1, time);
    (void)sqlite3_bind_blob(row, 2, message.data(), static_cast<int>(message.size()), nullptr);
    (void)sqlite3_step(row);
    (void)sqlite3_finalize(row);
  }

  /// A topic without messages, behind the other one.
  void add_unused_topic(const std::string& name, const std::string& type) {
    run("INSERT INTO topics VALUES(8, '" + name + "', '" + type + "', 'cdr')");
  }

  void run(const std::string& statement) {
    (void)sqlite3_exec(database_, statement.c_str(), nullptr, nullptr, nullptr);
  }

 private:
  sqlite3* database_ = nullptr;
};

}  // namespace somato
