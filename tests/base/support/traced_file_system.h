#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/file_system.h"

namespace somato::testing {

/// The real file system, with a list of what changed files and what was flushed, such as "write a",
/// "flush a", "rename b", "remove a", with the names of files and of the folders "folder".
class TracedFileSystem final : public FileSystem {
 public:
  std::vector<std::string> trace;

  Outcome<int> open(const std::string& path, Opening opening) override {
    const Outcome<int> file = real_.open(path, opening);
    if (!file) return file;
    names_[*file] = opening == Opening::kFolder ? "folder" : name_in(path);
    if (opening == Opening::kCreate) note("create", *file);
    return file;
  }
  Outcome<FileStatus> status(int file) override { return real_.status(file); }
  Outcome<std::size_t> read(int file, char* bytes, std::size_t count) override {
    return real_.read(file, bytes, count);
  }
  Outcome<std::size_t> read_at(int file, std::size_t place, char* bytes,
                               std::size_t count) override {
    note("read", file);
    return real_.read_at(file, place, bytes, count);
  }
  Outcome<std::size_t> write(int file, std::string_view bytes) override {
    note("write", file);
    return real_.write(file, bytes);
  }
  Outcome<void> set_permissions(int file, const FileStatus& like) override {
    return real_.set_permissions(file, like);
  }
  Outcome<void> flush(int file) override {
    note("flush", file);
    return real_.flush(file);
  }
  Outcome<void> lock(int file) override { return real_.lock(file); }
  Outcome<void> close(int file) override { return real_.close(file); }
  Outcome<void> rename(const std::string& from, const std::string& to) override {
    trace.push_back("rename " + name_in(to));
    return real_.rename(from, to);
  }
  Outcome<void> remove(const std::string& path) override {
    trace.push_back("remove " + name_in(path));
    return real_.remove(path);
  }

 private:
  static std::string name_in(const std::string& path) {
    const std::string name = std::filesystem::path(path).filename().string();
    return name.starts_with(".somato-") ? "new" : name;
  }

  // A step that follows an equal one is not noted.
  void note(const std::string& what, int file) {
    std::string step = what + " " + names_[file];
    if (trace.empty() || trace.back() != step) trace.push_back(std::move(step));
  }

  FileSystem& real_ = operating_system();
  std::map<int, std::string> names_;
};

}  // namespace somato::testing
