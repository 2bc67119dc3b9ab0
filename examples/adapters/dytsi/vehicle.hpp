/// DYTSI's model of Cooperrider's bogies under a car, as a system of ordinary differential equations.

#ifndef MICROSLIP_DYTSI_VEHICLE_HPP
#define MICROSLIP_DYTSI_VEHICLE_HPP

#include <memory>
#include <string>
#include <vector>

namespace DYTSI_Models {
class CooperriderOrthogonalModel;
}

using State = std::vector<double>;

/// Car, two bogies and four wheelsets on straight level track: y' = f(y), at a speed that can be set.
class DytsiVehicle {
public:
  /// Reads an input file of DYTSI, whose table of contact geometry is looked for from the working folder. Throws
  /// std::runtime_error, with the file and the reason.
  explicit DytsiVehicle(const std::string& input_file);
  ~DytsiVehicle();

  void set_speed(double speed); ///< [m/s]
  std::size_t size() const;     ///< number of states
  /// Index of the lateral displacement [m] of the first wheelset.
  std::size_t first_wheelset() const;

  /// At rest but for bogies and wheelsets, which lie beside the track's middle [m].
  State displaced(double lateral) const;

  /// f(y), as DYTSI computes it. Throws std::runtime_error where DYTSI finds none, as beyond the table's ends.
  void derivative(const State& state, State& rate) const;

private:
  std::unique_ptr<DYTSI_Models::CooperriderOrthogonalModel> model_;
};

#endif
