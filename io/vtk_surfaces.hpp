#pragma once

#include <filesystem>
#include <vector>

namespace microslip::io {

/// Writes the fields of a result file as surfaces for ParaView and other readers of VTK's XML format: NAME.GROUP.vtp
/// for each group of fields, its elements as rectangles with every field of the file as a number of the element, "px
/// [Pa]", and two vectors: `traction on body 1` [Pa], pressure and friction together, and `slip of body 1`. Lengths in
/// m.
///
/// Contacts of two bodies lie in the plane z = 0, body 1 above it. Patches on rails lie in track axes, x forward, y to
/// the left, z up, as planes at their places, turned about x by their angles; vectors are in these axes, too. Tractions
/// times areas add up to the force on the wheel where the rail's surface does not turn across a patch.
///
/// Returns the names. Each file appears whole or not at all. Throws Error with the file's name if it has no fields.
std::vector<std::filesystem::path> write_vtk_surfaces(const std::filesystem::path& result_file,
                                                      const std::filesystem::path& vtp);

/// Returns whether a name asks for surfaces: it ends with .vtp.
bool is_vtk(const std::filesystem::path& name);

} // namespace microslip::io
