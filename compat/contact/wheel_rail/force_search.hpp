#pragma once

#include <optional>
#include <vector>

namespace microslip::contact_program {

/// Finds where a force that grows with the depth as Hertz's does, F ~ (z - z0)^1.5, reaches a target: the straight line
/// of F^(2/3) over z through the two points that are next to it, kept within the bracket once there is one, with
/// bisection where that hardly becomes shorter.
class ForceSearch {
public:
  /// `contact` is the depth where the force begins.
  ForceSearch(double target, double contact) : target_(target), points_{{contact, 0}} {}

  void add(double z, double force);
  /// The next depth; nothing if the bracket cannot be shortened any more.
  std::optional<double> next();

private:
  struct Point {
    double z, force;
  };

  double secant() const;

  double target_;
  std::vector<Point> points_; ///< by ascending z
  double width_ = 1e30;       ///< of the bracket when it was last halved
  int slow_ = 0;              ///< steps since then
};

} // namespace microslip::contact_program
