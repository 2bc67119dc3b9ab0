# Headers of other libraries that most sources of a target include, parsed once for all of them: of the standard library,
# which are most of the time to compile the library, and those given. None of ours: a change of
# theirs must not compile everything anew. A header that a source forgets is missed where nothing is precompiled: the
# explorer's core and clang-tidy.
set(MICROSLIP_COMMON_HEADERS <algorithm> <array> <cmath> <complex> <functional> <memory> <optional> <span> <string> <vector>)
function(microslip_precompile target)
  target_precompile_headers(${target} PRIVATE ${MICROSLIP_COMMON_HEADERS} ${ARGN})
  # So that compiler caches see what they hold. With precompiled headers g++ 12 sees copies of impossible sizes in
  # std::string that are not there.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess -Wno-stringop-overflow -Wno-array-bounds>)
endfunction()
