#pragma once

#include <filesystem>
#include <memory>
#include <string>

/// Calls of the system by the readers and writers of files, where POSIX and Windows differ. A call that fails returns
/// -1 and leaves the reason in errno.
namespace microslip::io::system_calls {

/// Opens a file for bytes as they are, which child processes do not inherit; flags of <fcntl.h>. Permissions of a new
/// file are what the user's mask leaves.
int open(const std::filesystem::path& path, int flags);
/// Another descriptor of the same open file.
int duplicate(int descriptor);
/// Returns when the disk has what was written.
int flush(int descriptor);
/// Gives a file another name; a file that had it is gone.
int replace(const std::filesystem::path& from, const std::filesystem::path& to);
/// Succeeds (0) if this user may make files in a folder.
int access_folder(const std::filesystem::path& folder);
/// The bytes of an open file, mapped where the system can, read where it cannot; null if neither works.
std::shared_ptr<const void> contents(int descriptor, std::size_t size);

std::string host_name();
/// False where the system does not tell.
bool is_dead(long process);

} // namespace microslip::io::system_calls
