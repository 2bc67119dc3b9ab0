# How tests start Python with the libraries of this build: python_interpreter and python_environment. Libraries with
# sanitizers need their run time in the process before anything else. The address sanitizer's is loaded first, and
# libstdc++ beside it; clang's thread sanitizer can only be linked to the interpreter.
set(python_interpreter ${Python3_EXECUTABLE})
set(python_environment PYTHONDONTWRITEBYTECODE=1)
if(CMAKE_CXX_FLAGS MATCHES "fsanitize=address")
  set(preloaded)
  foreach(runtime asan stdc++)
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=lib${runtime}.so
      OUTPUT_VARIABLE file OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    string(APPEND preloaded "${file} ")
  endforeach()
  list(APPEND python_environment "LD_PRELOAD=${preloaded}" ASAN_OPTIONS=detect_leaks=0)
elseif(CMAKE_CXX_FLAGS MATCHES "fsanitize=thread")
  if(NOT TARGET sanitized_python)
    find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Embed)
    add_executable(sanitized_python ${CMAKE_CURRENT_LIST_DIR}/sanitized_python.cpp)
    target_link_libraries(sanitized_python PRIVATE Python3::Python)
    set_target_properties(sanitized_python PROPERTIES ENABLE_EXPORTS ON)
  endif()
  set(python_interpreter $<TARGET_FILE:sanitized_python>)
endif()
