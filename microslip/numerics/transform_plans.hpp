#pragma once

#include <memory>

namespace microslip {

/// Tables of factors of fast transforms, for each length. They are made when they are first needed and live as
/// long as anything that uses them. Copies share them. Distinct threads may use the same ones.
class TransformPlans {
public:
  TransformPlans();

  struct Kept;
  Kept& kept() const { return *kept_; }

private:
  std::shared_ptr<Kept> kept_;
};

} // namespace microslip
