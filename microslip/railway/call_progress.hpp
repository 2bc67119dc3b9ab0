#pragma once

#include "microslip/progress.hpp"

namespace microslip {

/// While it lives a solver tells the progress function of the call at hand, of no fraction, and ends with Stopped where
/// that returns false. The function must outlive it.
class CallProgress {
public:
  CallProgress(Progress& of_solver, const Progress& of_call) : of_solver_(of_solver) {
    if (!of_call) return;
    of_solver_ = [&of_call](double) {
      go_on(of_call, 0);
      return true;
    };
  }
  CallProgress(const CallProgress&) = delete;
  CallProgress& operator=(const CallProgress&) = delete;
  ~CallProgress() { of_solver_ = {}; }

private:
  Progress& of_solver_;
};

} // namespace microslip
