#include "recordings/bags/sqlite_bag.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <utility>

namespace somato {
namespace {

constexpr int kLargestValue = 1 << 26;  // Bytes of a message, as in a chunk of MCAP.

std::string text_in(sqlite3_stmt* statement, int column) {
  const void* text = sqlite3_column_blob(statement, column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
  return text ? std::string(static_cast<const char*>(text), size) : std::string();
}

}  // namespace

void SqliteBag::Close::operator()(sqlite3* database) const {
  (void)sqlite3_close(database);
}

void SqliteBag::Close::operator()(sqlite3_stmt* statement) const {
  (void)sqlite3_finalize(statement);
}

tl::unexpected<Error> SqliteBag::failure(const std::string& what) const {
  return fail(ErrorKind::kData, fmt::format("{} ({})", what, sqlite3_errmsg(database_.get())),
              path_, "copy the bag again, with all its files");
}

Result<std::unique_ptr<BagSource>> SqliteBag::open(const std::string& path) {
  std::unique_ptr<SqliteBag> bag(new SqliteBag(path));
  SOMATO_TRY_VOID(bag->begin());
  return bag;
}

// A file of a stranger: its schema is not trusted to call functions.
Result<void> SqliteBag::begin() {
  sqlite3* database = nullptr;
  const int status = sqlite3_open_v2(path_.c_str(), &database, SQLITE_OPEN_READONLY, nullptr);
  database_.reset(database);
  if (status != SQLITE_OK) return failure("the database cannot be opened");
  (void)sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  (void)sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  (void)sqlite3_limit(database, SQLITE_LIMIT_LENGTH, kLargestValue);
  SOMATO_TRY_VOID(read_topics());
  SOMATO_TRY(messages_, prepare("SELECT topic_id, timestamp, data FROM messages ORDER BY id"));
  return {};
}

Result<SqliteBag::Statement> SqliteBag::prepare(const char* query) const {
  sqlite3_stmt* statement = nullptr;
  const int status = sqlite3_prepare_v2(database_.get(), query, -1, &statement, nullptr);
  if (status != SQLITE_OK) return failure("it is not a database of rosbag2");
  return Statement(statement);
}

Result<bool> SqliteBag::step(const Statement& statement) const {
  const int status = sqlite3_step(statement.get());
  if (status == SQLITE_ROW) return true;
  if (status == SQLITE_DONE) return false;
  return failure("the database cannot be read");
}

// Bags before ROS 2 Iron have no such table.
Result<std::map<std::string, SqliteBag::Definition>> SqliteBag::read_definitions() const {
  std::map<std::string, Definition> definitions;
  SOMATO_TRY(const Statement table,
             prepare("SELECT name FROM sqlite_master WHERE name = 'message_definitions'"));
  SOMATO_TRY(const bool has_table, step(table));
  if (!has_table) return definitions;
  SOMATO_TRY(const Statement rows,
             prepare("SELECT topic_type, encoding, encoded_message_definition "
                     "FROM message_definitions"));
  for (;;) {
    SOMATO_TRY(const bool has_row, step(rows));
    if (!has_row) return definitions;
    definitions[text_in(rows.get(), 0)] = {text_in(rows.get(), 1), text_in(rows.get(), 2)};
  }
}

Result<void> SqliteBag::read_topics() {
  SOMATO_TRY(const auto definitions, read_definitions());
  SOMATO_TRY(const Statement rows,
             prepare("SELECT id, name, type, serialization_format FROM topics ORDER BY id"));
  for (;;) {
    SOMATO_TRY(const bool has_row, step(rows));
    if (!has_row) return {};
    BagTopic topic{text_in(rows.get(), 1),
                   {text_in(rows.get(), 2), text_in(rows.get(), 3), "", ""}};
    const auto found = definitions.find(topic.encoding.type);
    if (found != definitions.end()) {
      topic.encoding.definition_encoding = found->second.encoding;
      topic.encoding.definition = found->second.text;
    }
    topic_by_id_[sqlite3_column_int64(rows.get(), 0)] = topics_.size();
    topics_.push_back(std::move(topic));
  }
}

Result<std::optional<BagMessage>> SqliteBag::next() {
  SOMATO_TRY(const bool has_row, step(messages_));
  if (!has_row) return std::optional<BagMessage>();
  const auto topic = topic_by_id_.find(sqlite3_column_int64(messages_.get(), 0));
  if (topic == topic_by_id_.end()) {
    return fail(ErrorKind::kData, "a message belongs to no topic of the bag", path_,
                "copy the bag again, with all its files");
  }
  const auto* data = static_cast<const char*>(sqlite3_column_blob(messages_.get(), 2));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(messages_.get(), 2));
  return BagMessage{topic->second, sqlite3_column_int64(messages_.get(), 1),
                    data ? std::string_view(data, size) : std::string_view()};
}

}  // namespace somato
