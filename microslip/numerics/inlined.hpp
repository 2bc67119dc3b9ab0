#pragma once

/// For the small functions of marching kernels: a call between them would spill the vector registers.
#define MICROSLIP_INLINE [[gnu::always_inline]] inline
