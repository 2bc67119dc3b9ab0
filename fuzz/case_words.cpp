#include "microslip/description/input.hpp"

#include <iostream>

/// Prints sections, keys and words of case files as entries of a dictionary for the fuzzer.
int main() {
  using namespace microslip::description;
  for (const std::string_view kind : case_kinds) {
    const InputTable& table = inputs_of(kind);
    for (const Input& input : table.inputs()) {
      for (const std::string_view section : table.names(input.section)) std::cout << "\"[" << section << "]\"\n";
      std::cout << '"' << input.key << " = \"\n";
      for (const std::string_view word : input.words) std::cout << "\"\\\"" << word << "\\\"\"\n";
    }
  }
}
