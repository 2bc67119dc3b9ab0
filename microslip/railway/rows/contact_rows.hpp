#pragma once

#include "microslip/railway/geometry/contact_search.hpp"
#include "microslip/railway/geometry/patch_surface.hpp"
#include "microslip/railway/rows/row_normal.hpp"
#include "microslip/railway/rows/virtual_penetration.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// A row of a contact between wheel and rail, with its plane: that of the rail's surface at its centre.
struct ContactRow {
  PatchRow at;         ///< at x = 0 of the track axes; s is the rail profile's parameter
  NormalRow normal;    ///< its centre is on the wheel's locus
  int region = 0;      ///< of the overlap
  int number = 0;      ///< from where the count of rows has its mean: that of the same row in a position nearby
  bool joined = false; ///< to the row before, without a hole between them
};

/// Cuts the regions of overlap into rows. Along the rail's surface there are rows in proportion to
///   t/(t + 0.1) sqrt(kappa/(2 zeta) + (2.5/L)^2) ds,
/// with kappa the surfaces' relative curvature, zeta the greatest overlap along the normal, t the overlap over the
/// greatest one and L the length of a parabola with as large an area of overlap: a contact with one curvature has 16
/// rows, of which some ten carry loads, and where curvatures vary the rows follow them. Rows are counted through all
/// regions, and cut off at their ends. Count and edges are integrals over the overlap, whose density vanishes at its
/// ends, and no minimum nor region is chosen: rows are continuous while regions appear, merge and split.
class ContactRows {
public:
  /// The profiles must outlive it, and the equivalent rail where they are its; takes the memory for its rows.
  ContactRows(const Profile& rail, const Profile& wheel, std::size_t most_rows,
              const EquivalentRail* equivalent = nullptr);

  /// Rows of the wheel in its position, with the regions of overlap there and the virtual penetration in them. Rows are
  /// wider where there would be more than can be. Rows with the numbers of the last call's are these, moved. False if
  /// there are as many regions: rows at the field side are left out. Cost some 300 ns a row.
  bool place(const WheelPlacement<double>& placement, std::span<const ContactRegion> regions,
             const VirtualPenetration& penetration);

  std::span<const ContactRow> rows() const { return rows_; }

private:
  void count_rows(const VirtualPenetration& penetration);
  bool cut(const Frame<double>& rail, const WheelLocus<double>& locus,
           std::span<const VirtualPenetration::Sample> region, int index, const double* count, double phase);
  ContactRow& add(const Frame<double>& rail, const WheelLocus<double>& locus, double low, double high, double wheel_s);
  void find_before();

  const Profile* rail_;
  const Profile* wheel_;
  const EquivalentRail* equivalent_;
  std::size_t most_;
  std::vector<ContactRow> rows_, last_; ///< those of the last position
  std::vector<double> count_;           ///< of rows up to each sample, through all regions
};

} // namespace microslip
