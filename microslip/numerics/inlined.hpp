#pragma once

/// Marks the small functions of kernels: a call between them would spill the vector registers, and those that are in
/// headers are compiled for several instruction sets, of which the linker may keep any.
#define MICROSLIP_INLINE [[gnu::always_inline]] inline
