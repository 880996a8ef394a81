#include "base/elementary/turn.h"

#include "base/elementary.h"

#include "oracle.h"

typedef struct {
    double x, sine, cosine, tangent;
} large_angle;

/* Those doubles that come nearest to multiples of pi/2, by the continued fraction of 2^e 2/pi, and others that are
 * known to be hard; rounded from 1,400 bits. */
static const large_angle angles[] = {
    {0x1.6ac5b262ca1ffp+849, 0x1p+0, -0x1.14ae72e6ba22fp-61, -0x1.d9ba9a7975636p+60},
    {0x1.0f0cf064dd592p+73, -0x1.b453ab76bf397p-1, 0x1.0be2cef01c8f4p-1, -0x1.a0f79c1b6b257p+0},
    {0x1.fffffffffffffp+1023, 0x1.452fc98b34e97p-8, -0x1.fffe62ecfab75p-1,
     -0x1.4530cfe729484p-8},
    {0x1p+1023, 0x1.205248cbdb760p-1, -0x1.a719f26c232bfp-1, -0x1.5ce6b4c0d02a3p-1},
    {0x1p+20, 0x1.526ccb2fc8656p-2, 0x1.e33ada92fe2aep-1, 0x1.6692e5779206fp-2},
    {0x1.fffffffffffffp+19, 0x1.526ccb2de52a8p-2, 0x1.e33ada9352c61p-1, 0x1.6692e575533f1p-2},
    {0x1p+53, -0x1.b2a66c8f35586p-1, -0x1.0e9918bb35aacp-1, 0x1.9b33af5ae241fp+0},
    {0x1.ddd4baa009303p+998, 0x1.fe8388ea32208p-1, -0x1.37dc98cef57d0p-4,
     -0x1.a311a1d85ddf9p+3},
    {0x1.c6bf526340000p+49, 0x1.b76f88136cebap-1, -0x1.06c154609d33fp-1, -0x1.ac23600a95be4p+0},
    {0x1.921fb54442d18p+50, -0x1.1a2922caa21e7p-4, 0x1.fec8a2abc43d5p-1, -0x1.1ad522cf85f9dp-4},
    {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53, -0x1p+0, -0x1.1a62633145c07p-53},
    {0x1.921fb54442d18p+0, 0x1p+0, 0x1.1a62633145c07p-54, 0x1.d02967c31cdb5p+53},
    {0x1.16d0fc2ed4544p+11, -0x1.53cb37c6a9dcfp-43, 0x1p+0, -0x1.53cb37c6a9dcfp-43},
    {0x1.6300000000000p+8, -0x1.f9bd0307d1de3p-16, -0x1.fffffffc18e4cp-1,
     0x1.f9bd030bacc16p-16},
    {0x1.31b97c4000000p+26, -0x1.fb9755b6590d9p-27, 0x1.fffffffffffffp-1,
     -0x1.fb9755b6590dap-27},
    {0x1.9eb7148f354d6p+20, 0x1p+0, -0x1.d0afa32c646cap-55, -0x1.1a10d0f282028p+54},
    {0x1.f19e5d71b26bap+87, -0x1.230f73631c67dp-54, 0x1p+0, -0x1.230f73631c67dp-54},
    {0x1.741b6813300bap+221, -0x1.46ffe964146b1p-53, 0x1p+0, -0x1.46ffe964146b1p-53},
    {0x1.6dd6b29edc33ap+422, -0x1.3455f72eb7b7dp-55, -0x1p+0, 0x1.3455f72eb7b7dp-55},
    {0x1.8b28676cdcc5bp+556, -0x1.eca040e98a76fp-57, -0x1p+0, 0x1.eca040e98a76fp-57},
    {0x1.dfa8d18f2b3eep+690, -0x1.28904e0d7f525p-56, -0x1p+0, 0x1.28904e0d7f525p-56},
    {0x1.81ae0dffa3b33p+958, -0x1p+0, 0x1.24245af4cd995p-53, -0x1.c0a894108cd05p+52},
    {0x1.6c6cbc45dc8dep+5, 0x1p+0, -0x1.6d61b58c99c43p-61, -0x1.66b9ebc4850c6p+60},
    {0x1.6c6cbc45dc8dep+14, 0x1.6d61b58c99c43p-52, 0x1p+0, 0x1.6d61b58c99c43p-52},
    {0x1.67e57cdd4dc54p+17, 0x1.396f53352c401p-51, 0x1p+0, 0x1.396f53352c401p-51},
    {0x1.39c6fd67805a7p+19, 0x1.988efe18ff83fp-54, -0x1p+0, -0x1.988efe18ff83fp-54},
};

TEST(the_angles_nearest_to_quarter_turns_lose_nothing)
{
    for (int k = 0; k < COUNT(angles); k++)
        for (int side = -1; side <= 1; side += 2) {
            const large_angle *a = &angles[k];
            CHECK_BITS(bat_sin(side * a->x), side * a->sine);
            CHECK_BITS(bat_cos(side * a->x), a->cosine);
            CHECK_BITS(bat_tan(side * a->x), side * a->tangent);
        }
}

static const oracle_stretch stretches[] = {
    {"sin of large", bat_sin, oracle_sin, 0x1p20, 0x1p45, true},
    {"cos of large", bat_cos, oracle_cos, 0x1p20, 0x1p45, true},
    {"sin at the change", bat_sin, oracle_sin, 0x1p20 - 8, 0x1p20 + 8, false},
};

TEST(large_angles_are_reduced_as_small_ones)
{
    oracle_check(stretches, COUNT(stretches), 0.55);
}
