#include "app/program_arguments.hpp"

namespace microslip::app {

std::vector<std::string> program_arguments(int count, char** arguments) {
  return {arguments + (count > 0 ? 1 : 0), arguments + count};
}

} // namespace microslip::app
