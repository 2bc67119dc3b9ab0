#pragma once

namespace microslip::app {

/// Exit codes of the program.
struct ExitCode {
  static constexpr int done = 0, not_met = 1, bad_input = 2;
  static constexpr int interrupted = 130; ///< as shells report an end by Ctrl-C; by SIGTERM too
};

struct ExitCodeMeaning {
  int code;
  const char* meaning;
};

inline constexpr ExitCodeMeaning exit_code_meanings[] = {
    {ExitCode::done, "done"},
    {ExitCode::not_met, "a result is not converged, a case is not run or written, or figures are not met"},
    {ExitCode::bad_input, "bad input, or a file or standard output cannot be read or written"},
    {ExitCode::interrupted, "interrupted by Ctrl-C or SIGTERM; no file is left half-written"},
};

} // namespace microslip::app
