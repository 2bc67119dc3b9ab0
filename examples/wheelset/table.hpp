#pragma once

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <utility>

/// A text file that is there when it is whole.
class Table {
public:
  explicit Table(std::filesystem::path path) : path_(std::move(path)), file_(std::fopen(part().c_str(), "w")) {
    if (!file_) throw std::runtime_error("cannot write " + part().string());
  }
  std::FILE* file() const { return file_; }
  void finish() {
    const bool failed = std::ferror(file_) != 0;
    if (std::fclose(file_) != 0 || failed) throw std::runtime_error("cannot write " + part().string());
    std::filesystem::rename(part(), path_);
  }

private:
  std::filesystem::path part() const { return path_.string() + ".part"; }
  std::filesystem::path path_;
  std::FILE* file_;
};
