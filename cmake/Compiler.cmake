# Warnings are errors; release code is vectorised for this machine, NaN stays detectable. Two warnings
# are no fault of the code: g++ 12 sees uninitialised values in Eigen's vector code, and clang calls
# a loop that it chose not to vectorise a failure.
add_library(washtub_compiler INTERFACE)
target_compile_options(washtub_compiler INTERFACE
  -Wall -Wextra -Wconversion -Wno-sign-conversion -Werror
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
  $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed>
  -fopenmp-simd -fno-math-errno -fno-trapping-math -fno-signed-zeros)
if(WASHTUB_NATIVE)
  target_compile_options(washtub_compiler INTERFACE -march=native)
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag("-mprefer-vector-width=512" HAS_VECTOR_WIDTH)
  if(HAS_VECTOR_WIDTH)
    target_compile_options(washtub_compiler INTERFACE -mprefer-vector-width=512)
  endif()
endif()
if(WASHTUB_SANITIZE)
  target_compile_options(washtub_compiler INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(washtub_compiler INTERFACE -fsanitize=address,undefined)
endif()
