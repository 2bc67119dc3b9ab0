// Writes the unit's modelDescription.xml: describe FILE

#include "fmi/description.hpp"

#include <exception>
#include <fstream>
#include <iostream>

int main(int count, char** arguments) try {
  if (count != 2) return 2;
  std::ofstream file(arguments[1], std::ios::binary);
  file << microslip::fmi::model_description(microslip::fmi::model_info()) << std::flush;
  return file ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
