# Release code is vectorised for the processor asked for, NaN stays detectable. Warnings are errors
# where the code is checked, and no more than warnings where it is used: which there are depends on
# the processor. Some are no fault of the code: g++ 12 sees uninitialised values and wrong bounds in
# Eigen's vector code, and clang calls a loop that it chose not to vectorise a failure.
add_library(washtub_compiler INTERFACE)
target_compile_options(washtub_compiler INTERFACE
  -Wall -Wextra -Wconversion -Wno-sign-conversion $<$<BOOL:${WASHTUB_WERROR}>:-Werror>
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-array-bounds>"
  $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed>
  -fopenmp-simd -fno-math-errno -fno-trapping-math -fno-signed-zeros)
set(WASHTUB_PROCESSOR ${WASHTUB_ARCH})
if(NOT WASHTUB_NATIVE)
  set(WASHTUB_PROCESSOR portable)
endif()
if(NOT WASHTUB_PROCESSOR STREQUAL portable)
  target_compile_options(washtub_compiler INTERFACE -march=${WASHTUB_PROCESSOR})
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag("-mprefer-vector-width=512" HAS_VECTOR_WIDTH)
  if(HAS_VECTOR_WIDTH)
    target_compile_options(washtub_compiler INTERFACE -mprefer-vector-width=512)
  endif()
endif()
if(WASHTUB_SANITIZE)  # what the three left out would see ends the program all the same
  target_compile_options(washtub_compiler INTERFACE -fsanitize=address,undefined
    -fno-sanitize=null,object-size,vptr -fno-omit-frame-pointer)
  target_link_options(washtub_compiler INTERFACE -fsanitize=address,undefined)
endif()
if(WASHTUB_FUZZ)  # a finding of the sanitizers ends the fuzzer
  target_compile_options(washtub_compiler INTERFACE
    -fsanitize=fuzzer-no-link,float-cast-overflow -fno-sanitize-recover=all)
  target_link_options(washtub_compiler INTERFACE -fsanitize=float-cast-overflow)
endif()
