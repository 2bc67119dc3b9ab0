# Adds a call of creep_law.hpp to DYTSI's src/GeneralModel/WheelSetComponent.cpp, after its own law.
/^#include "WheelSetComponent\.h"/a #include "creep_law.hpp"
/^ *out\[1\] = epsilon\*Fy_val;/a replace_creep_forces({cp_a, cp_b, C11, C22, C23, get_G(), mu, N, xi_x, xi_y, xi_s}, out);
