#pragma once

namespace microslip {

/// Budget of the iterations of one solve, all of them together: those of rounds, trials, fallbacks and coarser
/// grids, however they are nested. Each takes its Newton steps and their products from here, and what is left is left
/// to the others.
class NewtonBudget {
public:
  NewtonBudget(int steps, long products) : steps_left_(steps), products_left_(products) {}

  bool is_spent() const { return steps_left_ <= 0 || products_left_ <= 0; }
  void take_step() { --steps_left_; }
  void take_product() { --products_left_; }

private:
  int steps_left_;
  long products_left_;
};

/// Returns whether there is a budget and nothing left of it.
inline bool is_spent(const NewtonBudget* budget) {
  return budget && budget->is_spent();
}

} // namespace microslip
