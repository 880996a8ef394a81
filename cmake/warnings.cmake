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
    $<$<BOOL:${BATTEN_WERROR}>:-Werror>)
set(CMAKE_C_EXTENSIONS OFF)
