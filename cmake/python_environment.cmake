# python_environment: what Python needs in its environment to load the libraries of this build. Those with sanitizers need
# their run time in the interpreter before anything else, and libstdc++ beside it.
set(python_environment PYTHONDONTWRITEBYTECODE=1)
set(runtimes)
if(CMAKE_CXX_FLAGS MATCHES "fsanitize=address")
  set(runtimes libasan.so libstdc++.so)
  list(APPEND python_environment ASAN_OPTIONS=detect_leaks=0)
elseif(CMAKE_CXX_FLAGS MATCHES "fsanitize=thread")
  set(runtimes libclang_rt.tsan-${CMAKE_SYSTEM_PROCESSOR}.so libstdc++.so)
endif()
set(preloaded)
foreach(runtime ${runtimes})
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=${runtime}
    OUTPUT_VARIABLE file OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(APPEND preloaded "${file} ")
endforeach()
if(preloaded)
  list(APPEND python_environment "LD_PRELOAD=${preloaded}")
endif()
