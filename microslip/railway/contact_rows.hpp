#pragma once

#include "microslip/railway/contact_search.hpp"
#include "microslip/railway/patch_surface.hpp"
#include "microslip/railway/row_normal.hpp"

#include <array>
#include <span>
#include <vector>

namespace microslip {

/// A row of a contact between wheel and rail, with its plane: that of the rail's surface at its centre.
struct ContactRow {
  PatchRow at;         ///< at x = 0 of the track axes; s is the rail profile's parameter
  NormalRow normal;    ///< its centre is on the wheel's locus
  int region = 0;      ///< of the overlap
  bool joined = false; ///< to the row before, without a hole between them
};

/// Cuts the regions of overlap into rows. Along the rail's surface there are rows in proportion to sqrt(kappa/(2 zeta)
/// + (2.5/L)^2) ds, with kappa the surfaces' relative curvature, zeta the greatest overlap along the normal and L the
/// length of a parabola with as large an area of overlap: a contact with one curvature has 14 rows, of which some ten
/// bear loads, and where curvatures vary the rows follow them. Rows are counted through all regions; an edge lies where
/// the overlap is deepest, and rows at a region's end are cut off there. As the ends of the overlap bear no load, all
/// that follows is continuous while regions appear, merge and split.
class ContactRows {
public:
  /// The profiles must outlive it, and the equivalent rail where they are its; takes the memory for its rows.
  ContactRows(const Profile& rail, const Profile& wheel, std::size_t most_rows,
              const EquivalentRail* equivalent = nullptr);

  /// Rows of the wheel in its position, which is by `lowering` [m] lower than where it was searched; the regions and
  /// points are those of the search, `depth` [m] is the greatest overlap. Rows are wider where there would be more than
  /// can be. False if there are as many regions: rows at the field side are left out. Cost some 300 ns a row.
  bool place(const WheelPlacement<double>& placement, std::span<const ContactRegion> regions,
             std::span<const ContactPoint> points, double lowering, double depth);

  std::span<const ContactRow> rows() const { return rows_; }

private:
  static constexpr int intervals = 16; ///< of a region, on which the curvature is taken as constant

  /// A region at equal distances along the rail's profile.
  struct Samples {
    double low = 0, step = 0;                    ///< parameter of the rail's profile [m]
    std::array<double, intervals + 1> slope{};   ///< of the wheel's surface against the rail's, a sine
    std::array<double, intervals + 1> level{};   ///< cosine of the rail's inclination
    std::array<double, intervals + 1> measure{}; ///< rows so far, through all regions
    double measure_at(double s) const;
  };

  double sample(const WheelPlacement<double>& placement, const ContactRegion& region);
  void measure(double length, double depth);
  double find_phase(std::span<const ContactRegion> regions, std::span<const ContactPoint> points,
                    double lowering) const;
  bool cut(const WheelPlacement<double>& placement, const ContactRegion& region, int index, double phase);
  void add(const WheelPlacement<double>& placement, double low, double high, double wheel_s, int region);

  const Profile* rail_;
  const Profile* wheel_;
  const EquivalentRail* equivalent_;
  std::size_t most_;
  std::vector<ContactRow> rows_;
  std::vector<Samples> samples_; ///< of each region
};

} // namespace microslip
