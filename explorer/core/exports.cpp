// What the page's script calls.

#include "explorer/core/explorer.hpp"

#include <string>

#include <emscripten/emscripten.h>

/// The answer to a request; it stays until the next one.
extern "C" EMSCRIPTEN_KEEPALIVE const char* explorer_answer(const char* request) {
  static microslip::explorer::Explorer explorer;
  static std::string answer;
  answer = explorer.answer(request);
  return answer.c_str();
}
