# Flags of every target of this project: strict warnings, and floating point that is the same on every machine
# (no contraction to fused multiply-add), while square roots may still be vectorised.
add_library(microslip_flags INTERFACE)
target_compile_options(microslip_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual -Werror
  -ffp-contract=off -fno-math-errno -fno-trapping-math
  # g++ 12 sees overlaps in "literal" + std::string that are not there; clang warns of loops it chose not to vectorise.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed>)

# In release builds the time goes into the library, which is optimised fully. Around it full optimisation only compiles
# longer: programs and modules do with less, tests with little, and under sanitizers, which double it, with none.
add_library(microslip_program_flags INTERFACE)
target_link_libraries(microslip_program_flags INTERFACE microslip_flags)
target_compile_options(microslip_program_flags INTERFACE $<$<CONFIG:Release>:-O2>)
add_library(microslip_test_flags INTERFACE)
target_link_libraries(microslip_test_flags INTERFACE microslip_flags)
target_compile_options(microslip_test_flags INTERFACE $<$<CONFIG:Release>:-O1> $<$<CONFIG:RelWithDebInfo>:-O0>)
