#pragma once

namespace microslip::io {

/// Keeps HDF5 from flushing what is open when the process ends, which all ResultFiles have closed by then: after a
/// write that failed, as on a full disk, it would crash there. For programs, before any file; of a module others may
/// rely on it.
void leave_hdf5_at_exit();

} // namespace microslip::io
