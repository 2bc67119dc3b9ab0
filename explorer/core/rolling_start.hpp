#pragma once

#include "io/case_file.hpp"
#include "io/json.hpp"

namespace microslip::explorer {

/// Transient rolling step by step with all tractions, as a JSON object. Where a case gives forces instead of creepages
/// the bodies are first shifted by them (Cattaneo 1938, Mindlin 1949), and then roll on under the same forces; else
/// they roll from zero tractions. By Kalker's regular elements, which are the same ones in all frames.
/// Throws Error for a case that is not about transient rolling by the exact theory.
io::Json rolling_start(const io::RollingCase& input);

} // namespace microslip::explorer
