#pragma once

#include <filesystem>

namespace microslip::io {

/// The file of the program that runs; empty if the system does not tell.
std::filesystem::path program_file();

/// The folder of the file that this code was loaded from: the program, or a shared object such as the Python module;
/// empty if the system does not tell.
std::filesystem::path library_folder();

/// The folder that holds the Python package `microslip`, as the program that runs was installed: share/microslip/python
/// beside the program's folder, or what holds the package if the program lies in it, as in a wheel (microslip/bin).
std::filesystem::path python_folder();

/// The explorer's page, share/microslip/explorer/index.html beside the program's folder, whether it is there or not.
std::filesystem::path explorer_page();

} // namespace microslip::io
