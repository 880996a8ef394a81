# What every C file of the project is compiled with. `-ffp-contract=off` is part of the
# promise "same input, same bits": without it clang fuses a*b+c where the processor can.
add_library(batten_warnings INTERFACE)
target_compile_features(batten_warnings INTERFACE c_std_17)
target_compile_options(batten_warnings INTERFACE
    -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wvla -Wformat=2
    -Wstrict-prototypes -Wmissing-prototypes -Wcast-qual -Wundef
    # Tests may mix int, size_t and double freely; what we ship may not.
    $<$<NOT:$<BOOL:$<TARGET_PROPERTY:BATTEN_IS_TEST>>>:-Wconversion>
    # clang calls INFINITY and NAN floats that are promoted; gcc knows better.
    $<$<AND:$<C_COMPILER_ID:GNU>,$<NOT:$<BOOL:$<TARGET_PROPERTY:BATTEN_IS_TEST>>>>:-Wdouble-promotion>
    # What ships does not tell in which folder it was built, so that a build elsewhere has the same bytes.
    $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=>
    $<$<BOOL:${BATTEN_WERROR}>:-Werror>)

# On 32-bit Intel the x87 registers round to 64 bits at some places and to 53 at others: not our promise.
include(CheckCSourceCompiles)
set(narrow "#include <float.h>\n_Static_assert(FLT_EVAL_METHOD == 0, \"x87\");int main(void) { return 0; }")
check_c_source_compiles("${narrow}" BATTEN_DOUBLES_ARE_DOUBLES)
if(NOT BATTEN_DOUBLES_ARE_DOUBLES)
    set(CMAKE_REQUIRED_FLAGS "-msse2 -mfpmath=sse")
    check_c_source_compiles("${narrow}" BATTEN_DOUBLES_BY_SSE)
    unset(CMAKE_REQUIRED_FLAGS)
    if(NOT BATTEN_DOUBLES_BY_SSE)
        message(FATAL_ERROR "This processor or compiler computes doubles with more bits than they have (FLT_EVAL_METHOD "
            "is not 0); Batten promises the same bits everywhere, so it cannot be built here.")
    endif()
    target_compile_options(batten_warnings INTERFACE -msse2 -mfpmath=sse)
endif()
if(MINGW)
    # The printf of C99, not that of the system.
    target_compile_definitions(batten_warnings INTERFACE __USE_MINGW_ANSI_STDIO=1)
endif()
set(CMAKE_C_EXTENSIONS OFF)
