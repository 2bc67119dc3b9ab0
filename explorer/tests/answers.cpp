// Answers requests natively: a line of JSON on standard input, a line on standard output. Files go to the current
// folder.

#include "explorer/core/explorer.hpp"

#include <iostream>
#include <string>

int main() {
  microslip::explorer::Explorer explorer;
  for (std::string request; std::getline(std::cin, request);) std::cout << explorer.answer(request) << std::endl;
}
