// Writes the unit's description and documentation: describe 2.0|3.0 modelDescription.xml index.html

#include "fmi/description.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <string>

namespace microslip::fmi {
namespace {

bool write(const char* name, const std::string& text) {
  std::ofstream file(name, std::ios::binary);
  file << text << std::flush;
  return file.good();
}

int describe(char** arguments) {
  const Version version = arguments[1] == std::string("3.0") ? Version::fmi3 : Version::fmi2;
  const ModelInfo info = model_info();
  return write(arguments[2], model_description(info, version)) && write(arguments[3], documentation(info)) ? 0 : 1;
}

} // namespace
} // namespace microslip::fmi

int main(int count, char** arguments) {
  try {
    return count == 4 ? microslip::fmi::describe(arguments) : 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
