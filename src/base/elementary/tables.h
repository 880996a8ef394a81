/* The tables and constants of the elementary functions. Made by make_tables.py, which says how; change that. */
#ifndef BAT_ELEMENTARY_TABLES_H
#define BAT_ELEMENTARY_TABLES_H
#include <stdint.h>

/* 2^(j / 128), a pair. */
extern const double bat_exponentials[128][2];
/* e^(j / 128) for j = -88 ... 88: 26 bits and the rest. */
extern const double bat_small_exponentials[177][2];
/* 1/c to some bits, a/c - 1 for the start a of the part, log(c): as far as 2^-42, and the rest. */
extern const double bat_logarithms[128][4];
/* log2(c) for the same c: as far as 2^-42, and the rest. */
extern const double bat_binary_logarithms[128][2];
/* sin(j pi / 128), a pair. */
extern const double bat_sines[320][2];
/* tan(j pi / 128) for j from 0 to 31 and from -32 to -1: 26 bits and the rest. */
extern const double bat_tangents[64][2];
/* atan(j / 128), a pair. */
extern const double bat_arc_tangents[129][2];
/* asin(c + d) for c = j/256 from j = 24 on: asin(c), a pair, the factors of d, less 1, of d^2 ... d^6, and that of d over 2 c. */
extern const double bat_arc_sines[105][9];
/* t, near the cube root, of 17 bits; 1 / t^3. */
extern const double bat_cube_roots[96][2];
/* A word that is 0, and the bits of 1 / (2 pi) behind the point. */
extern const uint32_t bat_turns[41];

/* log(2) / 128, as far as 2^-42, so that its multiples are exact; and the rest. */
#define BAT_EXP_STEP_1 0x1.62e42fef8p-8
#define BAT_EXP_STEP_2 0x1.1cf79abc9e3b4p-43
/* 128 / log(2). */
#define BAT_EXP_STEPS 0x1.71547652b82fep7
/* log(2), as far as 2^-42, and the rest. */
#define BAT_LOG_2_1 0x1.62e42fefa38p-1
#define BAT_LOG_2_2 0x1.ef35793c7673p-45
/* 1 / log(2), of 26 bits, and the rest. */
#define BAT_LOG2_E_1 0x1.7154768p0
#define BAT_LOG2_E_2 -0x1.6a3e80f444178p-27
/* 1 / log(10), of 26 bits, and the rest. */
#define BAT_LOG10_E_1 0x1.bcb7b18p-2
#define BAT_LOG10_E_2 -0x1.6c8d78e6acaa4p-29
/* pi / 128 in three parts of 27 bits, whose multiples below 2^26 are exact, and the rest. */
#define BAT_TURN_STEP_1 0x1.921fb54p-6
#define BAT_TURN_STEP_2 0x1.10b46p-36
#define BAT_TURN_STEP_3 0x1.1a6263p-60
#define BAT_TURN_STEP_4 0x1.8a2e03707344ap-87
/* 128 / pi. */
#define BAT_TURN_STEPS 0x1.45f306dc9c883p5
/* 2 pi, a pair. */
#define BAT_WHOLE_TURN_1 0x1.921fb54442d18p2
#define BAT_WHOLE_TURN_2 0x1.1a62633145c07p-52
/* pi, a pair. */
#define BAT_PI_1 0x1.921fb54442d18p1
#define BAT_PI_2 0x1.1a62633145c07p-53

#endif
