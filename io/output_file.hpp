#pragma once

#include <filesystem>
#include <string_view>

namespace microslip::io {

/// A file that appears whole or not at all: written under a temporary name in the same folder and renamed by commit().
/// Without commit() nothing is left and an older file of that name stays as it was. Symbolic links are followed, also
/// to where nothing is yet. What is no regular file (a pipe, a terminal, /dev/null) and what a name such as /dev/stdout
/// stands for is written directly. Failures throw an Error with the path and the system's reason. Temporary names end
/// with the computer's name and the process number; what killed processes of this computer have left in the folder is
/// removed.
class OutputFile {
public:
  explicit OutputFile(const std::filesystem::path& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view bytes);
  /// Path where others may write the file until commit(); empty if it is written directly.
  const std::filesystem::path& temporary() const { return temporary_; }
  void commit();

private:
  [[noreturn]] void fail(int error_number) const;
  void open_temporary();

  std::filesystem::path path_;      ///< as the caller named it, for messages
  std::filesystem::path target_;    ///< where links lead
  std::filesystem::path temporary_; ///< empty if written directly
  int descriptor_ = -1;
};

/// The name of a command's result file in the folder that it writes to.
inline constexpr const char* result_name = "result.h5";

/// Removes the temporary files of all OutputFiles of this process; nothing may be written to them afterwards. For
/// signal handlers that end the process: it only calls unlink.
void remove_temporary_files() noexcept;

/// Error if both names are of one file, which the output would replace.
void require_other_file(const std::filesystem::path& output, const std::filesystem::path& input);

/// True if both names are of one file, there or not yet, of which the second OutputFile would replace the first. What
/// is written directly takes both.
bool is_same_output(const std::filesystem::path& one, const std::filesystem::path& other);

/// Creates a folder and those above it; Error if that is impossible.
void create_folder(const std::filesystem::path& path);
/// Error if that could not be done, or nothing be written there: for saying so before long work. Nothing is left.
void require_writable_folder(const std::filesystem::path& path);
/// Throws Error unless a file can be written, as OutputFile would.
void require_writable_file(const std::filesystem::path& path);
/// Throws Error unless a file can be written in a folder that may still be missing.
void require_writable_file_in(const std::filesystem::path& folder, const std::filesystem::path& name);

} // namespace microslip::io
