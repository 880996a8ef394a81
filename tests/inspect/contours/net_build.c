/* Nets of rows of squares: how many triangles and nodes they have, their range, and values that are levels. */
#include "inspect/contours/net.h"
#include "support/test.h"

/* z = at + slope u over squares in a row, of which piece k is [k, k + 1] x [0, 1]. */
typedef struct {
    double at, slope;
} ramp;

static batten_status evaluate(const void *shape, int piece, const double uv[2], int order,
                              double *out)
{
    const ramp *r = shape;
    (void)piece;
    for (int k = 0; k < 3 * BATTEN_SURFACE_DERIVATIVES(order); k++)
        out[k] = 0;
    out[0] = uv[0];
    out[1] = uv[1];
    out[2] = r->at + r->slope * uv[0];
    out[3] = out[7] = 1;
    out[5] = r->slope;
    return BATTEN_OK;
}

static const batten_surface_field height = {
    BATTEN_FIELD_HEIGHT, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};

typedef struct {
    int *nodes;
    double *uv;
    bat_pieces pieces;
} row;

static row row_of(int count, const ramp *shape)
{
    row r = {test_array((size_t)count * 4, sizeof *r.nodes),
             test_array((size_t)count * 8, sizeof *r.uv),
             {0}};
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 4; k++) {
            const int right = k == 1 || k == 2, above = k >= 2;
            r.nodes[4 * i + k] = 2 * (i + right) + above;
            r.uv[8 * i + 2 * k] = i + right;
            r.uv[8 * i + 2 * k + 1] = above;
        }
    r.pieces = (bat_pieces){.shape = shape,
                            .evaluate = evaluate,
                            .piece_count = count,
                            .corner_count = 4,
                            .nodes = r.nodes,
                            .uv = r.uv,
                            .node_count = 2 * count + 2,
                            .size = 3};
    return r;
}

static bat_net net_of(const row *r, batten_levels levels)
{
    return (bat_net){.pieces = &r->pieces,
                     .field = &height,
                     .order = bat_field_order(&height),
                     .level_count = levels.count,
                     .levels = levels.at};
}

/* A square is four triangles, which are quartered so often; by Euler V = 1 + E - F, and every edge but those of the rim
 * has two triangles. */
TEST(few_pieces_are_quartered_four_times_and_many_never)
{
    static const struct {
        int pieces, rounds;
    } rows[] = {{1, 4},    {4, 4},    {5, 3},    {100, 3}, {101, 2},
                {1000, 2}, {1001, 1}, {5000, 1}, {5001, 0}};
    const ramp flat = {0, 0};
    for (int i = 0; i < (test_cases(10) < 10 ? 1 : COUNT(rows)); i++) {
        const long n = rows[i].pieces, halves = 1L << rows[i].rounds;
        const long faces = 4 * n * halves * halves, rim = (2 * n + 2) * halves;
        const row r = row_of(rows[i].pieces, &flat);
        bat_net net = net_of(&r, (batten_levels){0, NULL});
        batten_status status = bat_net_build(&net);
        if (!test_memory_failed(status, BATTEN_OK)) {
            CHECK_STATUS(status, BATTEN_OK);
            CHECK_INT(net.triangle_count, faces);
            CHECK_INT(net.node_count, 1 + (3 * faces + rim) / 2 - faces);
            CHECK_INT(net.critical_count, 0);
        }
        bat_net_free(&net);
    }
}

TEST(the_range_of_a_net_is_that_of_its_nodes)
{
    static const ramp ramps[] = {{2, 3}, {-5, 3}, {-2, -4}, {1, 0}, {-1e6, 1}};
    static const double rounded[] = {5e-14, 5e-14, 6e-14, 3e-14, 1e-8};
    for (int i = 0; i < COUNT(ramps); i++) {
        const row r = row_of(1, &ramps[i]);
        bat_net net = net_of(&r, (batten_levels){0, NULL});
        const double other = ramps[i].at + ramps[i].slope, range = fabs(ramps[i].slope) * 1e-12;
        const batten_status status = bat_net_build(&net);
        if (!test_memory_failed(status, BATTEN_OK)) {
            CHECK_STATUS(status, BATTEN_OK);
            CHECK_BITS(net.least, fmin(ramps[i].at, other));
            CHECK_BITS(net.greatest, fmax(ramps[i].at, other));
            CHECK_NEAR(net.roundoff, fmax(range, rounded[i]), 1e-22);
        }
        bat_net_free(&net);
    }
}

/* Nodes at u = 1/2 have the value 3.5, and rounding is 3e-12. */
TEST(values_of_nodes_within_rounding_of_a_level_are_that_level)
{
    static const double off[] = {2e-12, -2e-12, 4e-12, -4e-12};
    static const ramp rising = {2, 3};
    const row r = row_of(1, &rising);
    for (int i = 0; i < COUNT(off); i++) {
        const double level = 3.5 + off[i];
        bat_net net = net_of(&r, (batten_levels){1, &level});
        int at_level = 0, beside = 0;
        const batten_status status = bat_net_build(&net);
        if (!test_memory_failed(status, BATTEN_OK)) {
            CHECK_STATUS(status, BATTEN_OK);
            for (size_t k = 0; k < net.node_count; k++) {
                at_level += net.values[k] == level;
                beside += net.values[k] == 3.5;
            }
            CHECK_INT(i < 2 ? beside : at_level, 0);
            CHECK((i < 2 ? at_level : beside) >= 17);
        }
        bat_net_free(&net);
    }
}
